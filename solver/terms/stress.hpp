// SPDX-License-Identifier: GPL-3.0-or-later
// Stresses of a displacement, whichever way the part's volume strain is made, less those of its free strain and of what leaves
// no stress.
#pragma once
#include <optional>

#include "solver/splines/local_spline.hpp"
#include "solver/terms/solution_structure.hpp"

namespace abut::solver {

/// The displacement (2n) less the one that leaves no stress (PartInput::stress_free); empty where there is none.
Eigen::VectorXd elastic_displacement(const PartInput& input, const Eigen::VectorXd& displacement);

/// The stresses of one part and displacement, both of which it refers to. Cost of making it: with a projected dilatation one
/// solution with the mass matrix, else nothing.
class StressOf {
public:
    /// The stresses on one element: what its points share is done once.
    class OnElement {
    public:
        OnElement(const StressOf& stress, int element);
        Eigen::Vector3d operator()(const Vec2& x) const;
        /// The stress (xx, yy, xy) at x where the B-splines of the element's column and row there are at hand. Without a
        /// structure only.
        Eigen::Vector3d operator()(const Vec2& x, const LineValues& along_x, const LineValues& along_y) const;

    private:
        const StressOf& stress_;
        int element_;
        std::optional<LocalSpline<2>> displacement_;  // without a structure
    };

    StressOf(const PartInput& input, const Eigen::VectorXd& displacement);
    StressOf(const StressOf&) = delete;
    StressOf& operator=(const StressOf&) = delete;

    /// The stress (xx, yy, xy) at a point of an element.
    Eigen::Vector3d operator()(int element, const Vec2& x) const;
    /// The stress (xx, yy, xy) at a point where the displacement is at hand.
    Eigen::Vector3d operator()(int element, const Vec2& x, const DisplacementAt& u) const;
    /// The stress zz of a part with an axis, or with a free strain, which does not follow from the others by out_of_plane
    /// alone.
    double zz(int element, const Vec2& x) const;

private:
    /// The pressure of the projected volume strain.
    double volume_pressure(int element, const Vec2& x) const;

    const PartInput& input_;
    Eigen::VectorXd elastic_;  // the displacement less the one that leaves no stress, where there is any
    const Eigen::VectorXd& displacement_;
    Eigen::VectorXd pressure_;
};

/// Is zz more than out_of_plane (xx + yy)?
inline bool has_own_zz(const PartInput& input) {
    return input.axis || (input.free_strain && input.elasticity.expansion_zz != 0);
}

}  // namespace abut::solver
