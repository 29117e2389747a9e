// SPDX-License-Identifier: GPL-3.0-or-later
// Elastic foundations along a part's boundary: traction = -normal (n.u) n - tangential (t.u) t.
#pragma once
#include <vector>

#include "solver/terms/solution_structure.hpp"
#include "solver/terms/supports.hpp"

namespace abut::solver {

/// A point of a foundation. normal: unit, outward; weight: arc length.
struct SpringPoint {
    int element;
    Vec2 x, normal;
    double weight;
};

/// A foundation along a boundary. Stiffness: traction per displacement (force per length^3), not negative.
struct SpringSet {
    int tag = 0;
    std::vector<SpringPoint> points;
    double normal = 0, tangential = 0;
};

/// The force of the foundation on the part, per area, for a displacement.
Vec2 spring_traction(const SpringSet& set, const SpringPoint& p, const Vec2& displacement);

/// Adds a foundation to the stiffness, and to the load what it does with the displacement that a structure prescribes.
void add_springs(const PartInput& input, const SpringSet& set, BlockMatrix& stiffness, Eigen::VectorXd& load);

/// The force (2n) of the foundation on the part's functions for a displacement; not with a structure.
Eigen::VectorXd spring_load(const PartInput& input, const SpringSet& set, const Eigen::VectorXd& displacement);

/// The resultant of the foundation on the part, and the energy that it stores.
struct SpringAnswer {
    Resultant force;
    double energy = 0;
};
SpringAnswer spring_answer(const PartInput& input, const SpringSet& set, const Eigen::VectorXd& displacement);

}  // namespace abut::solver
