// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/placement.hpp"

#include <algorithm>
#include <cmath>

#include "solver/linear_algebra/dense.hpp"
#include "src/base/index.hpp"
#include "src/motion/closing_rows.hpp"

namespace abut {

Eigen::VectorXd rigid_amplitudes_of(const SolvedAssembly& solved, std::size_t grid) {
    const solver::PartSystem& system = solved.problem.parts[grid];
    const Eigen::VectorXd& u = solved.solution.displacement[grid];
    if (system.free_motions.empty() || u.size() != system.modes.rows()) return Eigen::VectorXd::Zero(system.modes.cols());
    return solver::PivotedCholesky(system.modes.transpose() * system.modes).solve(system.modes.transpose() * u);
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

namespace {

/// Do parts press on each other far from where they were paired? Along the normal it is the gap that counts as way: what bodies
/// come nearer by beyond it deforms them.
bool presses_elsewhere(const Scene& scene, const SolvedAssembly& solved, const std::vector<solver::RigidMotion>& motions) {
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        const ContactInterface& c = solved.contacts[k];
        if (solved.runs[k].empty() || c.face.bilateral) continue;
        const ContactRun& run = solved.runs[k].front();
        const geometry::FacingPair pair = pair_at(scene, c, 0.5 * (run.begin + run.end));
        if (!pair.found) continue;
        const std::size_t first = at(c.face.part[0]), second = at(c.face.part[1]);
        const ClosingRow row = closing_row(solved.grids[first].part, solved.grids[second].part, pair);
        const Vec2 by = motions[second].at(row.pivot2) - motions[first].at(row.pivot1),
                   way = by - (row.normal.dot(by) + std::max(0.0, row.gap)) * row.normal;
        if (row.shift(way) > paired_fraction(scene) * std::min(solved.grids[first].size, solved.grids[second].size))
            return true;
    }
    return false;
}

}  // namespace

std::optional<std::vector<Placement>> placements_of(const Scene& scene, const SolvedAssembly& solved) {
    if (!why_not_followed(scene).empty()) return std::nullopt;
    std::vector<Placement> placements(scene.parts.size());
    std::vector<solver::RigidMotion> motions;
    bool goes_far = false;
    for (std::size_t k = 0; k < solved.grids.size(); ++k) {
        const double size = solved.grids[k].size;
        const solver::RigidMotion& motion = motions.emplace_back(rigid_motion_of(solved, k));
        placements[at(solved.grids[k].part)] =
            without_rounding(about_center(motion.center, motion.translation, motion.rotation), motion.center, size);
        goes_far =
            goes_far || std::max(motion.translation.norm(), 0.5 * size * std::abs(motion.rotation)) > placed_fraction * size;
    }
    // what friction holds by counts from where parts were
    goes_far = goes_far || (!has_friction(scene.contacts) && presses_elsewhere(scene, solved, motions));
    if (!goes_far) return std::nullopt;
    return placements;
}

}  // namespace abut
