// SPDX-License-Identifier: GPL-3.0-or-later
// Small displacements balance forces where parts are drawn. What that leaves out, to the second order, is put on the parts as a
// load here, and the answer to it, by the same factors and contacts, is how far the first answer is off: a column near its
// buckling load, a string that is pulled, a cart whose wheels roll, a body that leans on a spring.
//
// A straight column has no displacement to grow: it is pushed aside, and its bending is to be less in the answer to what that
// leaves out.
//
// Where friction at its limit leaves open how far parts go, and how they share it, which is told, nothing is said of how that
// changes.
//
// Most scenes call for none of this, which their motions, mean stresses and shapes show beforehand.
#include "src/analysis/second_order.hpp"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "solver/splines/local_spline.hpp"
#include "solver/terms/finite_motion.hpp"
#include "src/analysis/motions_at_limit.hpp"
#include "src/analysis/moved_forces.hpp"
#include "src/analysis/placed_pairs.hpp"
#include "src/analysis/placement.hpp"
#include "src/analysis/second_order_loads.hpp"
#include "src/base/index.hpp"
#include "src/io/number_text.hpp"
#include "src/results/findings.hpp"
#include "src/results/result_units.hpp"
#include "src/solution/contact_measures.hpp"

namespace abut {

namespace {

using Eigen::VectorXd;

/// Changes below these, of the target, are not told: strain itself, which linear elasticity leaves out, makes others.
constexpr double noted_change = 2, strains_share = 5;
/// A displacement counts beside the largest one.
constexpr double least_displacement = 0.01;
/// A translation, rotation or bending counts beside all that a part moves by.
constexpr double least_share = 0.05;
/// Wrenches that turn or go along with parts, of the largest force on the part, below which none is looked at further.
constexpr double noted_wrench = 1e-4;
/// Gaps that motions along normals leave out, of the largest motion, below which none is looked at further.
constexpr double noted_gap = 1e-3;
/// A column's share of its least buckling load, and a bending in thicknesses, below which none is looked at further.
constexpr double noted_column = 0.02, noted_bending = 0.15;
/// A column's share of that load from which on it is pushed aside: one, but for how roughly shapes are known.
constexpr double doubtful_column = 0.5;
/// Lengths over widths of parts that may be columns.
constexpr double least_slenderness = 5;

double largest_force(const SolvedAssembly& solved) {
    double largest = solved.problem.load_scale;
    for (std::size_t k = 0; k < solved.contacts.size(); ++k)
        if (solved.interface_of[k] >= 0) largest = std::max(largest, pressing_force(solved, k));
    return largest;
}

double largest_force_on(const SolvedAssembly& solved, std::size_t part) {
    double largest = solved.problem.part_load[part];
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        const std::array<int, 2>& parts = solved.contacts[k].face.part;
        if (solved.interface_of[k] >= 0 && (at(parts[0]) == part || at(parts[1]) == part))
            largest = std::max(largest, pressing_force(solved, k));
    }
    return largest;
}

/// By part: does it move by enough beside the part that moves farthest?
std::vector<char> moves_that_count(const SolvedAssembly& solved) {
    std::vector<double> moved;
    for (const VectorXd& u : solved.solution.displacement) moved.push_back(u.lpNorm<Eigen::Infinity>());
    const double largest = *std::max_element(moved.begin(), moved.end());
    std::vector<char> counts;
    for (const double own : moved) counts.push_back(own > least_displacement * largest);
    return counts;
}

/// Does a part bend, or is it strained, by a share of its mean width that counts?
bool bends_far(const SolvedAssembly& solved, std::size_t i) {
    const PartOnGrid& grid = solved.grids[i];
    return !grid.is_rigid && fitted_motion_of(solved, i).bending() > noted_bending * grid.area / grid.size;
}

/// The second moments of a part's area about its centre; the first axis is across where it is long.
Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes_of(const PartOnGrid& grid) {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(geometry::second_moments(grid.local, grid.center));
}

/// Length over width of a part, squared: of a bar as long and as large, or with such second moments of area, if that is more.
double slenderness_squared(const PartOnGrid& grid) {
    const Eigen::Vector2d moments = axes_of(grid).eigenvalues();
    return std::max(moments[1] / moments[0], std::pow(grid.size * grid.size / grid.area, 2));
}

bool has_answer(const SolvedAssembly& solved) {
    return solved.solution.mechanism.empty() && solved.solution.converged;
}

/// What bars bend with: E, or E / (1 - nu^2) in plane strain.
double bending_modulus(const solver::Elasticity& d) {
    return d.d11 - d.d12 * d.d12 / d.d11;
}

/// A slender part's share of the least buckling load, that of a bar as slender, clamped at one end: pi^2 E I / 4 L^2.
double column_share(const SolvedAssembly& solved, std::size_t i) {
    const PartOnGrid& grid = solved.grids[i];
    const double squared = grid.is_rigid ? 0 : slenderness_squared(grid);
    if (squared < least_slenderness * least_slenderness) return 0;
    const solver::PartInput& input = solved.problem.parts[i].input;
    const Eigen::Matrix2d stress = stress_integral(input, solved.solution.displacement[i]) / (grid.area * grid.input.thickness);
    constexpr double of_column = 48 / (std::numbers::pi * std::numbers::pi);
    return of_column * stress.norm() / bending_modulus(input.elasticity) * squared;
}

/// By part that is solved.
std::vector<double> column_shares(const SolvedAssembly& solved) {
    std::vector<double> shares;
    for (std::size_t i = 0; i < solved.grids.size(); ++i) shares.push_back(column_share(solved, i));
    return shares;
}

bool is_neutral(const SolvedAssembly& solved, std::size_t i) {
    const auto is_own = [&](const solver::PartMotion& m) { return at(m.part) == i; };
    return std::any_of(solved.solution.neutral.begin(), solved.solution.neutral.end(), is_own);
}

double largest_motion(const SolvedAssembly& solved, std::size_t contact) {
    double largest = 0;
    for (const int part : solved.contacts[contact].face.part)
        largest = std::max(largest, solved.solution.displacement[at(part)].lpNorm<Eigen::Infinity>());
    return largest;
}

/// May forces that are balanced where parts have moved and bent to change the answer?
bool calls_for_second_order(const Scene& scene, const SolvedAssembly& solved, const std::vector<double>& gaps,
                            const std::vector<double>& columns) {
    for (std::size_t k = 0; k < gaps.size(); ++k)
        if (gaps[k] != 0 && std::abs(gaps[k]) > noted_gap * largest_motion(solved, k)) return true;
    const std::vector<char> counts = moves_that_count(solved);
    const auto is_noted = [&](std::size_t part, double force, double moment) {
        return counts[part] && !is_neutral(solved, part) &&
               std::max(force, std::abs(moment) / solved.grids[part].size) > noted_wrench * largest_force_on(solved, part);
    };
    for (std::size_t i = 0; i < solved.grids.size(); ++i)
        if (bends_far(solved, i) || columns[i] > noted_column || is_noted(i, 0, moment_as_part_turns(solved, i))) return true;
    const std::vector<ContactChange> changes = changes_as_contacts_move(scene, solved);
    return std::any_of(changes.begin(), changes.end(),
                       [&](const ContactChange& change) { return is_noted(change.part, change.force.norm(), change.moment); });
}

/// The largest mean strain of a part, by its energy.
double strain_of(const SolvedAssembly& solved) {
    double largest = 0;
    for (std::size_t i = 0; i < solved.grids.size(); ++i) {
        const PartOnGrid& grid = solved.grids[i];
        if (grid.is_rigid) continue;
        const double energy = std::abs(solver::strain_energy(solved.problem.parts[i], solved.solution.displacement[i]));
        largest = std::max(largest,
                           std::sqrt(2 * energy / (bending_modulus(grid.input.elasticity) * grid.area * grid.input.thickness)));
    }
    return largest;
}

/// Integrals of products of two displacements (2n) over a part: coefficients weigh more where the grid is fine.
struct MeanProducts {
    double uu = 0, uv = 0, vv = 0;
};

MeanProducts mean_products(const solver::PartInput& input, const VectorXd& u, const VectorXd& v) {
    MeanProducts sum;
    for_all_cells(input, [&](const solver::CellRule& rule) {
        const solver::LocalSpline<2> u_here(input.space, rule.element, [&](int f) { return u.segment<2>(2 * f); }),
            v_here(input.space, rule.element, [&](int f) { return v.segment<2>(2 * f); });
        for (std::size_t k = 0; k < rule.points.size(); ++k) {
            const Vec2 a = u_here.value(rule.points[k]), b = v_here.value(rule.points[k]);
            sum.uu += rule.weights[k] * a.squaredNorm();
            sum.uv += rule.weights[k] * a.dot(b);
            sum.vv += rule.weights[k] * b.squaredNorm();
        }
    });
    return sum;
}

/// How a part's displacement changes, as a share of it: the sum of all orders, as far as the second one tells. 1 and more of
/// `growing`: there is no end of it.
struct Change {
    double share = 0, growing = 0;
};

/// Of a displacement of size u, and what the second order adds to it, of size v, in the same direction or against it.
Change change_by(double u, double v, double along) {
    const double growing = along / u;
    return {growing < 1 ? v / u / (1 - growing) : v / u, growing};
}

/// The force on a part, in assembly coordinates, that the answer leaves out; zero where it is none that counts.
Vec2 force_left_out(const SolvedAssembly& solved, const SolvedAssembly& moved, std::size_t i) {
    const PartOnGrid& grid = solved.grids[i];
    const VectorXd more = moved.problem.parts[i].applied - solved.problem.parts[i].applied;
    const Vec2 force = solver::resultant_of(grid.input.space, more).force;
    return force.norm() > noted_wrench * largest_force_on(solved, i) ? grid.frame.vector_to_global(force) : Vec2(0, 0);
}

/// The largest of the changes of a part's translation, its rotation, and its bending: what grows may be a small share of all
/// that it moves by, across the way that most of this goes. What edges hold bends as a whole.
Change change_of(const SolvedAssembly& solved, const SolvedAssembly& moved, std::size_t i) {
    const VectorXd &u = solved.solution.displacement[i], v = moved.solution.displacement[i] - u;
    const double least = least_share * u.lpNorm<Eigen::Infinity>();
    const FittedMotion of_u = fitted_motion_of(solved, i), of_v = fitted_motion(solved.grids[i], v);
    Change most;
    const auto take = [&](const Change& change) {
        if (std::max(change.share, change.growing) > std::max(most.share, most.growing)) most = change;
    };
    const bool is_held = is_held_by_edges(solved, i);
    if (!is_held && !is_neutral(solved, i)) {
        for (const Vec2& way : {of_v.motion.translation, force_left_out(solved, moved, i)}) {
            if (way.norm() == 0) continue;
            const double along = of_u.motion.translation.dot(way.normalized()),
                         on = of_v.motion.translation.dot(way.normalized());
            if (std::abs(along) > least) take(change_by(std::abs(along), std::abs(on), std::copysign(on, on * along)));
        }
        const double turned = of_u.motion.rotation, more = of_v.motion.rotation;
        if (std::abs(turned) * solved.grids[i].size > 2 * least)
            take(change_by(std::abs(turned), std::abs(more), std::copysign(more, more * turned)));
    }
    if (!solved.grids[i].is_rigid && (is_held || of_u.bending() > least)) {
        const solver::PartInput& input = solved.grids[i].input;
        const MeanProducts p = is_held ? mean_products(input, u, v) : mean_products(input, of_u.rest, of_v.rest);
        if (p.uu > 0) take(change_by(1, std::sqrt(p.vv / p.uu), p.uv / p.uu));
    }
    if (!bends_far(solved, i)) return most;
    const solver::PartSystem& part = solved.problem.parts[i];
    const double energy = solver::strain_energy(part, u),
                 stretching = energy > 0 ? std::max(0.0, stretching_work(part.input, u, v) / (2 * energy)) : 0;
    most.share = std::max(most.share, stretching / (1 + stretching));
    return most;
}

/// How a part's bending grows, which a small push brings about across where it is long, from one order to the next: its share
/// of its buckling load as it is held; nothing where the push moves it far.
std::optional<double> growth_of_bending(const Scene& scene, const SolvedAssembly& solved, std::size_t i, int threads) {
    constexpr double push = 1e-4;  // of the largest force
    const Vec2 aside = push * largest_force(solved) * axes_of(solved.grids[i]).eigenvectors().col(0);
    std::vector<VectorXd> more;
    for (const solver::PartSystem& part : solved.problem.parts) more.push_back(VectorXd::Zero(part.load.size()));
    more[i] = even_load(solved.grids[i], aside);
    const SolvedAssembly pushed = solved_under(solved, more, {}, threads);
    if (!has_answer(pushed)) return std::nullopt;
    const std::vector<VectorXd> before = second_order_loads(scene, solved), after = second_order_loads(scene, pushed);
    for (std::size_t k = 0; k < more.size(); ++k) more[k] += after[k] - before[k];
    const SolvedAssembly grown = solved_under(solved, more, {}, threads);
    if (!has_answer(grown)) return std::nullopt;
    const VectorXd bending = pushed.solution.displacement[i] - solved.solution.displacement[i],
                   growth = grown.solution.displacement[i] - pushed.solution.displacement[i];
    return growth.dot(bending) / bending.squaredNorm();
}

/// noted: shares below are not told.
void tell_displacements(const Scene& scene, const Outcome& out, const SolvedAssembly& moved, const std::vector<double>& columns,
                        double noted, int threads, Result& result) {
    std::vector<Finding> findings;
    const std::vector<char> counts = moves_that_count(out.solved);
    for (std::size_t i = 0; i < out.solved.grids.size(); ++i) {
        Change change = counts[i] ? change_of(out.solved, moved, i) : Change();
        if (change.growing < 1 && columns[i] > doubtful_column)
            if (const auto growth = growth_of_bending(scene, out.solved, i, threads); growth && *growth >= 1)
                change = {*growth, *growth};
        if (change.share <= noted && change.growing < 1) continue;
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

/// The sum of contacts' forces on each part, as they are or turned where friction does not keep their direction open.
std::vector<Vec2> forces_by_part(const SolvedAssembly& solved, const std::vector<MovedForce>& lines, bool are_turned) {
    std::vector<Vec2> sum(solved.grids.size(), Vec2(0, 0));
    for (const MovedForce& line : lines) {
        const solver::Interface& face = solved.contacts[line.contact].face;
        const Vec2& force = are_turned && !line.any_direction ? line.turned : line.force;
        sum[at(face.part[0])] += force;
        sum[at(face.part[1])] -= force;
    }
    return sum;
}

/// By stretches under pressure: two faces of a corner that press one place are one, whichever of them bears how much; and by
/// parts, on which forces that turn add up to others. is_at_limit: friction, where some parts go.
void tell_forces(const Scene& scene, const Outcome& out, const SolvedAssembly& moved, double noted, bool is_at_limit,
                 Result& result) {
    const std::vector<MovedForce> before = moved_forces(scene, out.solved), after = moved_forces(scene, moved);
    const double largest = largest_force(out.solved);
    std::map<std::string, Finding> findings;  // a contact may press in several stretches
    const auto note = [&](double change, const std::string& who, const std::string& changes) {
        if (change <= noted * largest) return;
        const std::string text = changes + " by about " + percent_text(change / largest) +
                                 " of the largest one once forces are balanced where parts have moved and bent to";
        Finding& worst = findings[who];
        if (change > worst.measure) worst = {change, who, text + ", which the answer leaves out", text};
    };
    const auto is_same = [](const MovedForce& a, const MovedForce& b) { return a.contact == b.contact; };
    if (std::equal(before.begin(), before.end(), after.begin(), after.end(), is_same))  // else corners are joined otherwise
        for (std::size_t k = 0; k < before.size(); ++k) {
            const std::string contact = "contact " + contact_number(before[k].contact);
            const Vec2 change = after[k].force - before[k].force, &normal = before[k].normal;
            const bool is_open = is_at_limit && before[k].any_direction && normal.norm() > 0;
            note(is_open ? std::abs(change.dot(normal)) : change.norm(), contact, "the force of " + contact + " changes");
        }
    const std::vector<Vec2> was = forces_by_part(out.solved, before, false), is = forces_by_part(out.solved, after, true);
    constexpr double counts = 0.1;  // of the largest force: what balances on a part by itself has no direction
    for (std::size_t i = 0; i < was.size(); ++i) {
        if (was[i].norm() <= counts * largest) continue;
        const std::string part = "part " + scene.parts[at(out.solved.grids[i].part)].name;
        note(std::abs(is[i].norm() - was[i].norm()), part, "the forces of contacts on " + part + " change");
    }
    tell(values_of(findings), "turned_force", result);
}

}  // namespace

void warn_of_second_order(const Scene& scene, const Outcome& out, int threads, Result& result) {
    const SolvedAssembly& solved = out.solved;
    const auto has_structure = [](const solver::PartSystem& p) { return p.input.structure != nullptr; };
    if (std::any_of(solved.problem.parts.begin(), solved.problem.parts.end(), has_structure)) return;
    if (largest_force(solved) == 0) return;
    const std::vector<double> gaps = gaps_left_out(scene, solved);
    const std::vector<double> columns = column_shares(solved);
    if (!calls_for_second_order(scene, solved, gaps, columns)) return;
    const SolvedAssembly moved = solved_under(solved, second_order_loads(scene, solved), gaps, threads);
    if (!has_answer(moved)) {
        tell({{0, "",
               "what forces that are balanced where parts have moved and bent to would change is not known: no answer was "
               "found there",
               "no answer was found where parts have moved and bent to"}},
             "displacement", result);
        return;
    }
    const double noted = noted_change * out.target + strains_share * strain_of(solved);
    const bool is_at_limit = any_at_limit(scene, solved);
    if (!is_at_limit) tell_displacements(scene, out, moved, columns, noted, threads, result);
    const auto is_told = [](const Reason& r) { return r.kind == "turned_force"; };
    if (std::none_of(result.reasons.begin(), result.reasons.end(), is_told))
        tell_forces(scene, out, moved, noted, is_at_limit, result);
}

}  // namespace abut
