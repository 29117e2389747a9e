// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/placement.hpp"

#include <algorithm>
#include <cmath>

#include "solver/linear_algebra/dense.hpp"
#include "src/analysis/static_forces.hpp"
#include "src/base/index.hpp"
#include "src/motion/moving_parts.hpp"

namespace abut {

Eigen::MatrixXd unit_motions(const PartOnGrid& grid) {
    using solver::RigidMotion;
    return solver::coefficients_of(grid.input.space, {RigidMotion{{1, 0}, 0, grid.center}, RigidMotion{{0, 1}, 0, grid.center},
                                                      RigidMotion{{0, 0}, 1, grid.center}});
}

Eigen::VectorXd rigid_amplitudes_of(const SolvedAssembly& solved, std::size_t grid) {
    const solver::PartSystem& system = solved.problem.parts[grid];
    const Eigen::VectorXd& u = solved.solution.displacement[grid];
    if (system.free_motions.empty() || u.size() != system.modes.rows()) return Eigen::VectorXd::Zero(system.modes.cols());
    const Eigen::MatrixXd free = combinations_let_go(solved, grid, true), modes = system.modes * free;
    if (free.cols() == 0) return Eigen::VectorXd::Zero(system.modes.cols());
    return free * solver::PivotedCholesky(modes.transpose() * modes).solve(modes.transpose() * u);
}

solver::RigidMotion rigid_motion_of(const SolvedAssembly& solved, std::size_t grid) {
    const solver::PartSystem& system = solved.problem.parts[grid];
    const PartOnGrid& g = solved.grids[grid];
    solver::RigidMotion motion{{0, 0}, 0, g.frame.to_global(g.center)};
    const Eigen::VectorXd share = rigid_amplitudes_of(solved, grid);
    Vec2 at_center(0, 0);
    for (Eigen::Index k = 0; k < share.size(); ++k) {
        const solver::RigidMotion& unit = system.free_motions[static_cast<std::size_t>(k)];
        at_center += share[k] * unit.at(g.center);
        motion.rotation += share[k] * unit.rotation;
    }
    motion.translation = g.frame.vector_to_global(at_center);
    return motion;
}

FittedMotion fitted_motion(const PartOnGrid& g, const Eigen::VectorXd& displacement) {
    const Eigen::MatrixXd units = unit_motions(g);
    const Eigen::Vector3d share = solver::PivotedCholesky(units.transpose() * units).solve(units.transpose() * displacement);
    return {{g.frame.vector_to_global(share.head<2>()), share[2], g.frame.to_global(g.center)}, displacement - units * share};
}

FittedMotion fitted_motion_of(const SolvedAssembly& solved, std::size_t grid) {
    return fitted_motion(solved.grids[grid], solved.solution.displacement[grid]);
}

std::optional<std::vector<Placement>> placements_of(const Scene& scene, const ResolvedConditions& conditions,
                                                    const SolvedAssembly& solved) {
    if (!why_not_followed(scene, conditions).empty()) return std::nullopt;
    if (scene.in_steps && has_friction(scene.contacts)) return std::nullopt;  // they stay where the first takes the parts
    return far_placements_of(scene, solved);
}

std::optional<std::vector<Placement>> far_placements_of(const Scene& scene, const SolvedAssembly& solved) {
    const Bodies bodies = bodies_of(scene);
    std::vector<Placement> placements(scene.parts.size());
    bool any = false;
    for (std::size_t k = 0; k < solved.grids.size(); ++k) {
        const int part = solved.grids[k].part;
        if (std::count(bodies.of_part.begin(), bodies.of_part.end(), bodies.of_part[at(part)]) > 1) continue;
        const double size = solved.grids[k].size;
        const solver::RigidMotion motion = rigid_motion_of(solved, k);
        if (std::max(motion.translation.norm(), 0.5 * size * std::abs(motion.rotation)) <= placed_fraction * size) continue;
        any = true;
        placements[at(part)] =
            without_rounding(about_center(motion.center, motion.translation, motion.rotation), motion.center, size);
    }
    if (!any) return std::nullopt;
    return placements;
}

}  // namespace abut
