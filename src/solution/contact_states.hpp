// SPDX-License-Identifier: GPL-3.0-or-later
// Where a contact with friction sticks, slips and is open.
#pragma once
#include <cmath>

#include "src/solution/solved_assembly.hpp"

namespace abut {

/// The coefficient of friction of a contact; infinite: rough; 0: none.
double friction_of(const SolvedAssembly& solved, std::size_t contact);

/// A traction that is nearer to its bound than this share of it slips: the coefficients are to rounding.
inline constexpr double slip_fraction = 1e-6;

enum class FrictionState : char { open, stick, slip_forward, slip_backward };

/// The state at a place s of the middle curve. Forward: the second part slips along the first's normal turned left.
FrictionState state_at(const SolvedAssembly& solved, std::size_t contact, double s);

/// A place within a contact where sticking and slipping meet: what is left of the traction to its bound ends there like the
/// root of the distance, as the pressure does at a free end.
struct StickBorder {
    double s;        ///< on the middle curve
    int outward;     ///< +1: it slips at larger s; -1: the other way
    StretchEnd end;  ///< how far into the sticking stretch the border's own error counts apart from the rest, and that error
};
/// The borders of a contact, ascending; none nearer to an end of contact than the knots there stand apart.
std::vector<StickBorder> stick_borders(const SolvedAssembly& solved, std::size_t contact);

/// The traction's error at a contact's free ends, L2: from tractions of the same force that slip there, however narrow the
/// stretch that slips is beside the knots. None of rough faces, where the traction may have no limit.
double traction_error_at_ends(const SolvedAssembly& solved, std::size_t contact);

/// How much of a contact sticks, and how much slips, on the middle curve.
struct FrictionLengths {
    double stick = 0, slip = 0;
    double unseen = 0;  ///< of what counts as sticking, beside ends of contact: borders there would not be seen
};
/// The lengths of a contact; borders: its own.
FrictionLengths friction_lengths(const SolvedAssembly& solved, std::size_t contact, const std::vector<StickBorder>& borders);

/// Integrals of the pressure and of the traction on the second part (force).
struct FrictionSums {
    double normal = 0, shear = 0;
    /// The share that the shear is of what a coefficient of friction bears.
    double share_of_limit(double friction) const { return std::abs(shear) / (friction * normal); }
};
FrictionSums friction_sums(const SolvedAssembly& solved, std::size_t contact);

}  // namespace abut
