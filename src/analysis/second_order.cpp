// SPDX-License-Identifier: GPL-3.0-or-later
// Small displacements balance forces where parts are drawn. What that leaves out, to the second order, is put on the parts as a
// load here, and the answer to it, by the same factors and contacts, is how far the first answer is off: a column near its
// buckling load, a string that is pulled, a cart whose wheels roll, a body that leans on a spring.
//
// Parts: finite_motion_load, for contact forces that stay at the same points of both bodies and keep their lines. What contact
// forces do otherwise (moved_forces) is a wrench on either body.
//
// Most scenes call for none of this, which their motions, mean stresses and shapes show beforehand.
#include "src/analysis/second_order.hpp"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/contact/independent_groups.hpp"
#include "solver/terms/finite_motion.hpp"
#include "src/analysis/moved_forces.hpp"
#include "src/analysis/placement.hpp"
#include "src/base/index.hpp"
#include "src/io/number_text.hpp"
#include "src/results/findings.hpp"
#include "src/results/result_units.hpp"
#include "src/solution/contact_measures.hpp"

namespace abut {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using geometry::cross, geometry::left_of;

/// Changes below these, of the target, are not told: strain itself, which linear elasticity leaves out, makes others.
constexpr double noted_change = 2, strains_share = 5;
/// A displacement counts beside the largest one.
constexpr double least_displacement = 0.05;
/// Wrenches that turn or go along with parts, of the largest force, below which none is looked at further.
constexpr double noted_wrench = 1e-4;
/// A column's share of its least buckling load, and a bending in thicknesses, below which none is looked at further.
constexpr double noted_column = 0.02, noted_bending = 0.15;
/// Lengths over widths of parts that may be columns.
constexpr double least_slenderness = 5;

/// A force, and its moment about a part's centre, in the part's frame.
struct Wrench {
    Vec2 force{0, 0};
    double moment = 0;
};

/// The coefficients (2n x 3) of the rigid motions along x and y and about a part's centre.
MatrixXd unit_motions(const PartOnGrid& grid) {
    using solver::RigidMotion;
    return solver::coefficients_of(grid.input.space, {RigidMotion{{1, 0}, 0, grid.center}, RigidMotion{{0, 1}, 0, grid.center},
                                                      RigidMotion{{0, 0}, 1, grid.center}});
}

/// The load (2n) that works in rigid motions what the wrench does, evenly over the part's functions.
VectorXd load_of(const PartOnGrid& grid, const Wrench& wrench) {
    const MatrixXd motions = unit_motions(grid);
    const Eigen::Vector3d works(wrench.force.x(), wrench.force.y(), wrench.moment);
    return motions * (motions.transpose() * motions).ldlt().solve(works);
}

/// Do held edges keep the part where it is? How it gives way there is strain.
bool is_held_by_edges(const SolvedAssembly& solved, std::size_t i) {
    return !solved.problem.parts[i].supports.empty();
}

/// The part's motion as a whole, in assembly coordinates.
solver::RigidMotion motion_of(const SolvedAssembly& solved, std::size_t i) {
    const PartOnGrid& grid = solved.grids[i];
    if (is_held_by_edges(solved, i) || grid.input.axis) return rigid_motion_of(solved, i);
    return fitted_motion_of(solved, i).motion;
}

/// What the contacts' forces do more on each part as they move away from its points and turn.
std::vector<Wrench> changes_of_contacts(const Scene& scene, const SolvedAssembly& solved) {
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

/// The sum of place times force over a rigid part's loads, contacts' included: what its stress integral's trace would be.
double virial_of(const PartOnGrid& grid, const VectorXd& load) {
    VectorXd aside = load;  // turned left: its moment is the sum
    for (Index f = 0; f + 1 < aside.size(); f += 2) aside.segment<2>(f) = left_of(Vec2(load.segment<2>(f)));
    const solver::Resultant turned = resultant_of(grid.input.space, aside);
    return turned.moment - cross(grid.center, turned.force);
}

/// Loads that keep their directions have other moments on a part that turns.
double moment_as_it_turns(const SolvedAssembly& solved, std::size_t i) {
    const PartOnGrid& grid = solved.grids[i];
    const double rotation = motion_of(solved, i).rotation;
    if (rotation == 0) return 0;
    return -rotation * (grid.is_rigid
                            ? virial_of(grid, solved.solution.load[i])
                            : stress_integral(solved.problem.parts[i].input, solved.solution.displacement[i]).trace());
}

double largest_force(const SolvedAssembly& solved) {
    double largest = solved.problem.load_scale;
    for (std::size_t k = 0; k < solved.contacts.size(); ++k)
        if (solved.interface_of[k] >= 0) largest = std::max(largest, pressing_force(solved, k));
    return largest;
}

/// Does a part bend, or is it strained, by a share of its mean width that counts?
bool bends_far(const SolvedAssembly& solved, std::size_t i) {
    const PartOnGrid& grid = solved.grids[i];
    return fitted_motion_of(solved, i).rest > noted_bending * grid.area / grid.size;
}

/// Length over width of a part, squared: of a bar as long and as large, or with such second moments of area, if that is more.
double slenderness_squared(const PartOnGrid& grid) {
    Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
    for_all_cells(grid.input, [&](const solver::CellRule& rule) {
        for (std::size_t k = 0; k < rule.points.size(); ++k) {
            const Vec2 arm = rule.points[k] - grid.center;
            moments += rule.weights[k] * arm * arm.transpose();
        }
    });
    const Eigen::Vector2d principal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(moments).eigenvalues();
    return std::max(principal[1] / principal[0], std::pow(grid.size * grid.size / grid.area, 2));
}

/// Is a part so slender and loaded, or bent by so much, that its own balance may change? The least buckling load is that of a
/// bar as slender, clamped at one end: pi^2 E I / 4 L^2.
bool may_bend_otherwise(const SolvedAssembly& solved, std::size_t i) {
    const PartOnGrid& grid = solved.grids[i];
    if (grid.is_rigid) return false;
    if (bends_far(solved, i)) return true;
    const double squared = slenderness_squared(grid);
    if (squared < least_slenderness * least_slenderness) return false;
    const solver::PartInput& input = solved.problem.parts[i].input;
    const Eigen::Matrix2d stress = stress_integral(input, solved.solution.displacement[i]) / (grid.area * grid.input.thickness);
    constexpr double of_column = 48 / (std::numbers::pi * std::numbers::pi);
    return of_column * stress.norm() / input.elasticity.d11 * squared > noted_column;
}

bool is_neutral(const SolvedAssembly& solved, std::size_t i) {
    const auto is_own = [&](const solver::PartMotion& m) { return at(m.part) == i; };
    return std::any_of(solved.solution.neutral.begin(), solved.solution.neutral.end(), is_own);
}

/// May forces that are balanced where parts have moved and bent to change the answer?
bool calls_for_second_order(const SolvedAssembly& solved, const std::vector<Wrench>& changes) {
    const double largest = largest_force(solved);
    for (std::size_t i = 0; i < solved.grids.size(); ++i) {
        if (may_bend_otherwise(solved, i)) return true;
        if (is_neutral(solved, i)) continue;
        const Wrench& w = changes[i];
        const double moment = std::abs(w.moment) + std::abs(moment_as_it_turns(solved, i));
        if (std::max(w.force.norm(), moment / solved.grids[i].size) > noted_wrench * largest) return true;
    }
    return false;
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

/// The assembly with what its answer leaves out as a further load, solved.
SolvedAssembly balanced_where_moved(const SolvedAssembly& solved, const std::vector<Wrench>& changes, int threads) {
    SolvedAssembly moved = solved;
    for (std::size_t i = 0; i < solved.grids.size(); ++i) {
        const PartOnGrid& grid = solved.grids[i];
        const solver::PartSystem& part = solved.problem.parts[i];
        Wrench wrench = changes[i];
        if (grid.is_rigid) wrench.moment += moment_as_it_turns(solved, i);
        VectorXd more = load_of(grid, wrench);
        if (!grid.is_rigid) more += solver::finite_motion_load(part.input, solved.solution.displacement[i]);
        more = without_neutral_work(solved, i, std::move(more));
        moved.problem.parts[i].applied += more;
        moved.problem.parts[i].load += more;
    }
    moved.solution = solver::solve_groups(moved.problem, threads);
    return moved;
}

/// The largest mean strain of a part, by its energy.
double strain_of(const SolvedAssembly& solved) {
    double largest = 0;
    for (std::size_t i = 0; i < solved.grids.size(); ++i) {
        const PartOnGrid& grid = solved.grids[i];
        if (grid.is_rigid) continue;
        const double energy = std::abs(solver::strain_energy(solved.problem.parts[i], solved.solution.displacement[i]));
        largest = std::max(largest, std::sqrt(2 * energy / (grid.input.elasticity.d11 * grid.area * grid.input.thickness)));
    }
    return largest;
}

/// How a part's displacement changes, as a share of it: the sum of all orders, as far as the second one tells. 1 and more of
/// `growing`: there is no end of it.
struct Change {
    double share = 0, growing = 0;
};

Change change_of(const SolvedAssembly& solved, const SolvedAssembly& moved, std::size_t i) {
    const VectorXd &u = solved.solution.displacement[i], v = moved.solution.displacement[i] - u;
    double largest = 0;
    for (const VectorXd& other : solved.solution.displacement) largest = std::max(largest, other.lpNorm<Eigen::Infinity>());
    const double own = u.lpNorm<Eigen::Infinity>();
    if (own <= least_displacement * largest || is_neutral(solved, i)) return {};
    Change change{v.norm() / u.norm(), v.dot(u) / u.squaredNorm()};
    if (change.growing < 1) change.share /= 1 - change.growing;
    const solver::PartSystem& part = solved.problem.parts[i];
    if (solved.grids[i].is_rigid || !bends_far(solved, i)) return change;
    const double energy = solver::strain_energy(part, u),
                 stretching = energy > 0 ? std::max(0.0, stretching_work(part.input, u, v) / (2 * energy)) : 0;
    change.share = std::max(change.share, stretching / (1 + stretching));
    return change;
}

/// noted: shares below are not told.
void tell_displacements(const Scene& scene, const Outcome& out, const SolvedAssembly& moved, double noted, Result& result) {
    std::vector<Finding> findings;
    for (std::size_t i = 0; i < out.solved.grids.size(); ++i) {
        const Change change = change_of(out.solved, moved, i);
        if (change.share <= noted) continue;
        const std::string& name = scene.parts[at(out.solved.grids[i].part)].name;
        const std::string text =
            change.growing >= 1
                ? "part " + name + " may tip over or buckle: nothing seems to balance its forces where it has moved and bent to"
                : "displacements of part " + name + " change by about " + percent_text(change.share) +
                      " once forces are balanced where it has moved and bent to";
        findings.push_back(
            {change.growing >= 1 ? 1 + change.share : change.share, name,
             text + (change.growing >= 1 ? "; the answer is that of small displacements" : ", which the answer leaves out"),
             text});
    }
    tell(std::move(findings), "displacement", result);
}

/// By stretches under pressure: two faces of a corner that press one place are one, whichever of them bears how much.
void tell_forces(const Scene& scene, const Outcome& out, const SolvedAssembly& moved, double noted, Result& result) {
    const std::vector<solver::RigidMotion> none(out.solved.grids.size());
    const std::vector<MovedForce> before = moved_forces(scene, out.solved, none), after = moved_forces(scene, moved, none);
    const double largest = largest_force(out.solved);
    std::vector<Finding> findings;
    for (std::size_t k = 0; k < std::min(before.size(), after.size()); ++k) {
        const double share = (after[k].force - before[k].force).norm() / largest;
        if (share <= noted) continue;
        const std::string number = contact_number(before[k].contact);
        const std::string text = "the force of contact " + number + " changes by about " + percent_text(share) +
                                 " of the largest one once forces are balanced where parts have moved and bent to";
        findings.push_back({share, "contact " + number, text + ", which the answer leaves out", text});
    }
    tell(std::move(findings), "turned_force", result);
}

}  // namespace

void warn_of_second_order(const Scene& scene, const Outcome& out, int threads, Result& result) {
    const SolvedAssembly& solved = out.solved;
    const auto has_structure = [](const solver::PartSystem& p) { return p.input.structure != nullptr; };
    if (std::any_of(solved.problem.parts.begin(), solved.problem.parts.end(), has_structure)) return;
    const std::vector<Wrench> changes = changes_of_contacts(scene, solved);
    if (largest_force(solved) == 0 || !calls_for_second_order(solved, changes)) return;
    const SolvedAssembly moved = balanced_where_moved(solved, changes, threads);
    if (!moved.solution.mechanism.empty() || !moved.solution.converged) {
        tell({{0, "",
               "what forces that are balanced where parts have moved and bent to would change is not known: no answer was "
               "found there",
               "no answer was found where parts have moved and bent to"}},
             "displacement", result);
        return;
    }
    const double noted = noted_change * out.target + strains_share * strain_of(solved);
    tell_displacements(scene, out, moved, noted, result);
    const auto is_told = [](const Reason& r) { return r.kind == "turned_force"; };
    if (std::none_of(result.reasons.begin(), result.reasons.end(), is_told)) tell_forces(scene, out, moved, noted, result);
}

}  // namespace abut
