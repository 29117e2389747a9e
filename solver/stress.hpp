// SPDX-License-Identifier: GPL-3.0-or-later
// Stresses of a displacement, whichever way the part's volume strain is made.
#pragma once
#include <optional>

#include "solver/assembly.hpp"
#include "solver/local_spline.hpp"

namespace abut::solver {

/// Of one part and displacement, both of which it refers to. Cost of making it: with a projected dilatation one solution with
/// the mass matrix, else nothing.
class StressOf {
public:
    /// On one element: what its points share is done once.
    class OnElement {
    public:
        OnElement(const StressOf& stress, int element);
        Eigen::Vector3d operator()(const Vec2& x) const;

    private:
        const StressOf& stress_;
        int element_;
        std::optional<LocalSpline<2>> displacement_;  // without a structure
    };

    StressOf(const PartInput& input, const Eigen::VectorXd& displacement);

    /// (xx, yy, xy) at a point of an element.
    Eigen::Vector3d operator()(int element, const Vec2& x) const;
    /// The same where the gradient is at hand.
    Eigen::Vector3d operator()(int element, const Vec2& x, const Eigen::Matrix2d& gradient) const;

private:
    const PartInput& input_;
    const Eigen::VectorXd& displacement_;
    Eigen::VectorXd pressure_;
};

}  // namespace abut::solver
