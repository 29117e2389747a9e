// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/second_order_loads.hpp"

#include <Eigen/Dense>

#include "solver/contact/independent_groups.hpp"
#include "solver/terms/finite_motion.hpp"
#include "src/analysis/moved_forces.hpp"
#include "src/analysis/placement.hpp"
#include "src/base/index.hpp"

namespace abut {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using geometry::cross, geometry::left_of;

/// The part's motion as a whole, in assembly coordinates.
solver::RigidMotion motion_of(const SolvedAssembly& solved, std::size_t i) {
    const PartOnGrid& grid = solved.grids[i];
    if (is_held_by_edges(solved, i) || grid.input.axis) return rigid_motion_of(solved, i);
    return fitted_motion_of(solved, i).motion;
}

/// A load less what it works in motions of the part that nothing resists: they are left out, and no rounding is to drive them.
VectorXd without_neutral_work(const SolvedAssembly& solved, std::size_t i, VectorXd load) {
    for (const solver::PartMotion& neutral : solved.solution.neutral) {
        if (at(neutral.part) != i) continue;
        const VectorXd motion = solver::coefficients_of(solved.grids[i].input.space, neutral.motion);
        load -= motion * (motion.dot(load) / motion.squaredNorm());
    }
    return load;
}

}  // namespace

bool is_held_by_edges(const SolvedAssembly& solved, std::size_t part) {
    return !solved.problem.parts[part].supports.empty();
}

VectorXd load_of(const PartOnGrid& grid, const Wrench& wrench) {
    const MatrixXd motions = unit_motions(grid);
    const Eigen::Vector3d works(wrench.force.x(), wrench.force.y(), wrench.moment);
    return motions * (motions.transpose() * motions).ldlt().solve(works);
}

std::vector<Wrench> wrenches_as_contacts_move(const Scene& scene, const SolvedAssembly& solved) {
    std::vector<solver::RigidMotion> motions;
    for (std::size_t i = 0; i < solved.grids.size(); ++i) motions.push_back(motion_of(solved, i));
    std::vector<Wrench> changes(solved.grids.size());
    for (const MovedForce& line : moved_forces(scene, solved, motions)) {
        const ContactInterface& c = solved.contacts[line.contact];
        if (c.face.bilateral || (is_held_by_edges(solved, at(c.face.part[0])) && is_held_by_edges(solved, at(c.face.part[1]))))
            continue;  // nothing goes anywhere
        for (const int side : {0, 1}) {
            const std::size_t i = at(c.face.part[at(side)]);
            const PartOnGrid& grid = solved.grids[i];
            const double sign = side == 0 ? 1 : -1;
            const Vec2 center = grid.frame.to_global(grid.center), arm = line.drawn - center,
                       moved_arm = line.moved - center - motions[i].at(center),
                       own_arm = arm + motions[i].rotation * left_of(arm);  // of the point that it acts at, gone with the part
            changes[i].force += sign * grid.frame.vector_to_local(line.turned - line.force);
            changes[i].moment +=
                sign * (cross(moved_arm, line.turned) - cross(own_arm, line.force) + motions[i].rotation * line.virial);
        }
    }
    return changes;
}

double moment_as_part_turns(const SolvedAssembly& solved, std::size_t i) {
    const PartOnGrid& grid = solved.grids[i];
    const double rotation = motion_of(solved, i).rotation;
    if (rotation == 0) return 0;
    return -rotation * (grid.is_rigid
                            ? virial_of(grid.input.space, solved.solution.load[i], grid.center)
                            : stress_integral(solved.problem.parts[i].input, solved.solution.displacement[i]).trace());
}

std::vector<VectorXd> second_order_loads(const Scene& scene, const SolvedAssembly& solved) {
    std::vector<Wrench> wrenches = wrenches_as_contacts_move(scene, solved);
    std::vector<VectorXd> loads;
    for (std::size_t i = 0; i < solved.grids.size(); ++i) {
        const PartOnGrid& grid = solved.grids[i];
        if (grid.is_rigid) wrenches[i].moment += moment_as_part_turns(solved, i);
        VectorXd load = load_of(grid, wrenches[i]);
        if (!grid.is_rigid) load += solver::finite_motion_load(solved.problem.parts[i].input, solved.solution.displacement[i]);
        loads.push_back(without_neutral_work(solved, i, std::move(load)));
    }
    return loads;
}

SolvedAssembly solved_under(const SolvedAssembly& solved, const std::vector<VectorXd>& more, int threads) {
    SolvedAssembly moved = solved;
    for (std::size_t i = 0; i < more.size(); ++i) {
        moved.problem.parts[i].applied += more[i];
        moved.problem.parts[i].load += more[i];
    }
    moved.solution = solver::solve_groups(moved.problem, threads);
    return moved;
}

}  // namespace abut
