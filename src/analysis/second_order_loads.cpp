// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/second_order_loads.hpp"

#include <Eigen/Dense>

#include "solver/contact/independent_groups.hpp"
#include "solver/parts/rigid_body.hpp"
#include "solver/terms/finite_motion.hpp"
#include "src/analysis/face_motion.hpp"
#include "src/analysis/moved_forces.hpp"
#include "src/analysis/placement.hpp"
#include "src/base/index.hpp"
#include "src/solution/contact_states.hpp"

namespace abut {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using geometry::cross;

VectorXd load_of(const SolvedAssembly& solved, const ContactChange& change) {
    const PartOnGrid& grid = solved.grids[change.part];
    if (!grid.input.axis) return load_on_face(solved, change.contact, change.side, change.force, change.moment, change.at);
    return even_load(grid, grid.frame.vector_to_local(change.force), change.moment);
}

/// Do the faces stay on each other, bonded or by friction?
bool sticks(const SolvedAssembly& solved, std::size_t contact) {
    if (solved.contacts[contact].face.bilateral) return true;
    const double friction = friction_of(solved, contact);
    return friction > 0 && friction_sums(solved, contact).share_of_limit(friction) < 1 - slip_fraction;
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

VectorXd even_load(const PartOnGrid& grid, const Vec2& force, double moment) {
    const MatrixXd motions = unit_motions(grid);
    const Eigen::Vector3d works(force.x(), force.y(), moment);
    return motions * (motions.transpose() * motions).ldlt().solve(works);
}

std::vector<ContactChange> changes_as_contacts_move(const Scene& scene, const SolvedAssembly& solved) {
    std::vector<ContactChange> changes;
    for (const MovedForce& line : moved_forces(scene, solved)) {
        const ContactInterface& c = solved.contacts[line.contact];
        if (ends_at_mirror(solved, line.contact)) continue;            // it acts on the line of symmetry, and stays there
        if (line.any_place && sticks(solved, line.contact)) continue;  // what is glued has the loads of finite_motion_load
        for (const std::size_t side : {0U, 1U}) {
            const solver::RigidMotion motion = face_motion(solved, line.contact, side);
            const Vec2 gone = line.moved - line.drawn - motion.at(line.drawn);
            const double sign = side == 0 ? 1 : -1;
            changes.push_back({line.contact, side, at(c.face.part[side]), line.drawn, sign * (line.turned - line.force),
                               sign * (cross(gone, line.turned) + motion.rotation * line.virial)});
        }
    }
    return changes;
}

double moment_as_part_turns(const SolvedAssembly& solved, std::size_t i) {
    const PartOnGrid& grid = solved.grids[i];
    if (is_held_by_edges(solved, i) || grid.input.axis) return 0;
    const double rotation = fitted_motion_of(solved, i).motion.rotation;
    const solver::PartSystem& part = solved.problem.parts[i];
    const VectorXd& u = solved.solution.displacement[i];
    if (!grid.is_rigid) return -rotation * stress_integral(part.input, u).trace();
    return -rotation * virial_of(grid.input.space, solver::forces_on(part, u, solved.solution.load[i]), grid.center);
}

std::vector<VectorXd> second_order_loads(const Scene& scene, const SolvedAssembly& solved) {
    std::vector<VectorXd> loads;
    for (std::size_t i = 0; i < solved.grids.size(); ++i) {
        const PartOnGrid& grid = solved.grids[i];
        loads.push_back(grid.is_rigid
                            ? even_load(grid, {0, 0}, moment_as_part_turns(solved, i))
                            : solver::finite_motion_load(solved.problem.parts[i].input, solved.solution.displacement[i]));
    }
    for (const ContactChange& change : changes_as_contacts_move(scene, solved)) loads[change.part] += load_of(solved, change);
    for (std::size_t i = 0; i < loads.size(); ++i) loads[i] = without_neutral_work(solved, i, std::move(loads[i]));
    return loads;
}

SolvedAssembly solved_under(const SolvedAssembly& solved, const std::vector<VectorXd>& more, const std::vector<double>& gaps,
                            int threads) {
    SolvedAssembly moved = solved;
    for (std::size_t i = 0; i < more.size(); ++i) {
        moved.problem.parts[i].applied += more[i];
        moved.problem.parts[i].load += more[i];
    }
    for (std::size_t k = 0; k < gaps.size(); ++k)
        if (gaps[k] != 0)
            for (solver::InterfacePoint& p : moved.problem.interfaces[at(solved.interface_of[k])].points) p.gap += gaps[k];
    moved.solution = solver::solve_groups(moved.problem, threads);
    return moved;
}

}  // namespace abut
