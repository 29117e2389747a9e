// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/terms/springs.hpp"

#include "src/base/ensure.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;

/// Traction = -K u.
Eigen::Matrix2d stiffness_at(const SpringSet& set, const SpringPoint& p) {
    const Eigen::Matrix2d nn = p.normal * p.normal.transpose();
    return set.normal * nn + set.tangential * (Eigen::Matrix2d::Identity() - nn);
}

}  // namespace

Vec2 spring_traction(const SpringSet& set, const SpringPoint& p, const Vec2& displacement) {
    return -stiffness_at(set, p) * displacement;
}

void add_springs(const PartInput& input, const SpringSet& set, BlockMatrix& stiffness, Eigen::VectorXd& load) {
    for (const SpringPoint& p : set.points) {
        const DisplacementBasis b = displacement_basis(input, p.element, p.x);
        const std::vector<int>& functions = b.x.functions;
        const Eigen::Matrix2d k = p.weight * input.thickness * stiffness_at(set, p);
        const auto values = [&](std::size_t i) {
            return Vec2(b.of(0).value[static_cast<Index>(i)], b.of(1).value[static_cast<Index>(i)]);
        };
        const Vec2 of_data = k * b.data.value;
        for (std::size_t i = 0; i < functions.size(); ++i) {
            const Vec2 row = values(i);
            load.segment<2>(2 * functions[i]) -= row.cwiseProduct(of_data);
            for (std::size_t j = 0; j < functions.size(); ++j)
                if (functions[j] <= functions[i])
                    stiffness.at(functions[i], functions[j]) += row.asDiagonal() * k * values(j).asDiagonal();
        }
    }
}

Eigen::VectorXd spring_load(const PartInput& input, const SpringSet& set, const Eigen::VectorXd& displacement) {
    ENSURE(!input.structure, "forces of springs are on plain functions");
    std::vector<TractionPoint> points;
    for (const SpringPoint& p : set.points) {
        const Vec2 u = displacement_at(input, displacement, p.element, p.x).value;
        points.push_back({p.element, p.x, p.weight, spring_traction(set, p, u)});
    }
    return boundary_load(input, points);
}

SpringAnswer spring_answer(const PartInput& input, const SpringSet& set, const Eigen::VectorXd& displacement) {
    SpringAnswer answer;
    for (const SpringPoint& p : set.points) {
        const Vec2 u = displacement_at(input, displacement, p.element, p.x).value;
        const Vec2 force = p.weight * input.thickness * spring_traction(set, p, u);
        answer.force.add(p.x, force);
        answer.energy -= 0.5 * force.dot(u);
    }
    return answer;
}

}  // namespace abut::solver
