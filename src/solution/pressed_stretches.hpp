// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>
#include <vector>

#include "solver/splines/bspline.hpp"
#include "src/solution/contact_interface.hpp"

namespace abut {

/// An end of a stretch of contact.
struct StretchEnd {
    enum class Kind {
        free,    ///< the gap opens: the pressure ends like the root of the distance
        corner,  ///< the interface ends and the pressure rises towards it: it may have no limit there
        plain    ///< the interface ends, and nothing happens: a symmetry plane, or the seam of one that goes all the way round
    };
    Kind kind = Kind::plain;
    double reach = 0;  ///< how far into the contact the end's own error counts apart from the rest: free ends and corners
    double error = 0;  ///< free ends: L2 distance within the reach between the spline and the root that is fitted to the force
};

/// Knot spacings beside a free end in which its error counts.
inline constexpr double error_reach = 3;

/// A stretch of an interface's middle curve under pressure.
struct PressedStretch {
    double begin, end;        ///< arc lengths
    bool from_start, to_end;  ///< reaches the interface's own ends
    StretchEnd at_begin{}, at_end{};
};

/// The stretches of every contact.
using PressedStretches = std::vector<std::vector<PressedStretch>>;

/// The stretches where the pressure spline is positive. Ends inside the interface are found by fitting the force near them:
/// pressures end like the root of the distance, so the last active coefficient alone would put the end up to a knot too far.
std::vector<PressedStretch> pressed_stretches(const solver::KnotVector& pressure, const Eigen::VectorXd& coefficients);

/// The length of all stretches together.
double length_of(const std::vector<PressedStretch>& stretches);

}  // namespace abut
