// SPDX-License-Identifier: GPL-3.0-or-later
// Steps: rows of interfaces and constraints -> per part, forward solves of its rows -> C, g, G, h -> neutral motions left out
// -> the contact QP -> displacements.
#include "solver/contact/assembly_solve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "solver/contact/assembly_rows.hpp"
#include "solver/contact/condensation.hpp"
#include "solver/contact/friction.hpp"
#include "solver/contact/friction_path.hpp"
#include "solver/contact/loose_motions.hpp"
#include "solver/contact/neutral_motions.hpp"
#include "solver/contact/rigid_settle.hpp"
#include "solver/linear_algebra/dense.hpp"
#include "solver/linear_algebra/nonnegative.hpp"
#include "solver/linear_algebra/parallel_for.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Conditions that the first displacements meet to this are met to rounding: a step of refinement would cost another solution
/// of every part for digits that the stiffness matrix does not have.
constexpr double refined_residual = 1e-12;
/// Of an interface's own foundation: what bodies are held by along it at the start. Little, so that they come to rest on their
/// faces, not on their flanks.
constexpr double tangential_foundation = 1e-2;

class Laps {
public:
    /// Seconds since the lap before.
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(now - std::exchange(begin_, now)).count();
    }

private:
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

VectorXd foundation_of(const AssemblyProblem& problem, const AssemblyRows& all) {
    VectorXd foundation = VectorXd::Zero(all.rows.n);
    double stiffest = 0;
    for (std::size_t i = 0; i < problem.interfaces.size(); ++i)
        for (int k = 0; k < n_rows(problem.interfaces[i]); ++k) {
            const Index row = all.first_row[i] + k;
            foundation[row] = problem.foundation[i] * all.rows.weight[row];
            stiffest = std::max(stiffest, foundation[row]);
        }
    for (Index row = 0; row < foundation.size(); ++row)
        if (!all.rows.unilateral[static_cast<std::size_t>(row)]) foundation[row] = stiffest > 0 ? stiffest : 1.0;
    for (const FrictionRow& f : all.friction) foundation[f.tangential] = tangential_foundation * foundation[f.normal];
    return foundation;
}

std::vector<FrictionRow> friction_rows(const AssemblyProblem& problem, const std::vector<int>& first_row) {
    std::vector<FrictionRow> friction;
    for (std::size_t i = 0; i < problem.interfaces.size(); ++i) {
        const Interface& face = problem.interfaces[i];
        if (!face.friction) continue;
        ENSURE(i > 0 && face.bilateral && *face.friction > 0 && n_rows(problem.interfaces[i - 1]) == n_rows(face),
               "an interface of friction follows that of its pressure");
        const double coefficient = std::min(*face.friction, rough_coefficient);
        for (int k = 0; k < n_rows(face); ++k) friction.push_back({first_row[i - 1] + k, first_row[i] + k, coefficient});
    }
    return friction;
}

/// Slips count from the state before.
void take_slips_before(const AssemblyProblem& problem, AssemblyRows& all) {
    if (all.friction.empty() || problem.before.empty()) return;
    ENSURE(problem.before.size() == problem.parts.size(), "every part has a displacement before, or none has");
    VectorXd moved = VectorXd::Zero(all.rows.n);
    for (std::size_t i = 0; i < problem.parts.size(); ++i) moved += opening_of(all.rows, i, problem.before[i].displacement);
    for (const FrictionRow& f : all.friction) all.rows.gap0[f.tangential] -= moved[f.tangential];
}

SolveSeconds& operator+=(SolveSeconds& sum, const SolveSeconds& more) {
    sum.rows += more.rows;
    sum.condensation += more.condensation;
    sum.contact += more.contact;
    sum.displacements += more.displacements;
    return sum;
}

/// What is known of the multipliers, where something is.
VectorXd expected_multipliers(const AssemblyProblem& problem, const AssemblyRows& all) {
    const auto knows = [](const Interface& face) { return !face.expected.empty(); };
    if (std::none_of(problem.interfaces.begin(), problem.interfaces.end(), knows)) return VectorXd(0);
    VectorXd expected = VectorXd::Zero(all.rows.n);
    for (std::size_t i = 0; i < problem.interfaces.size(); ++i)
        std::copy(problem.interfaces[i].expected.begin(), problem.interfaces[i].expected.end(),
                  expected.begin() + all.first_row[i]);
    return expected;
}

/// Loads, and displacements without the rigid motions.
void recover_displacements(const AssemblyProblem& problem, const Rows& rows, const VectorXd& multipliers, int threads,
                           AssemblySolution& solution) {
    const std::size_t n = problem.parts.size();
    solution.contact_load.resize(n);
    solution.load.resize(n);
    solution.displacement.resize(n);
    parallel_for(static_cast<int>(n), threads, [&](int k) {
        const auto i = static_cast<std::size_t>(k);
        set_loads(problem, rows, multipliers, i, solution);
        solution.displacement[i] = solve(problem.parts[i], solution.load[i]);
    });
}

/// What the refinement changes. The settled amplitudes stay: all else is small against them where there is clearance.
struct ContactAnswer {
    VectorXd forces;  // multipliers of the scaled rows
    VectorXd settled, motion;
};

/// What displacements (without rigid motions) and forces leave of the gaps and of the balance.
struct Remainder {
    VectorXd gap, load;
};
Remainder remainder_of(const AssemblyProblem& problem, const Rows& rows, const ContactQp& qp, const MatrixXd& held,
                       const ContactAnswer& answer, const AssemblySolution& solution) {
    const std::vector<Index> offset = mode_offsets(problem.parts);
    VectorXd opening = VectorXd::Zero(rows.n), load = VectorXd::Zero(offset.back());
    for (std::size_t i = 0; i < problem.parts.size(); ++i) {
        opening += opening_of(rows, i, solution.displacement[i]);
        load.segment(offset[i], offset[i + 1] - offset[i]) = problem.parts[i].modes.transpose() * solution.load[i];
    }
    const Index soft = rows.softness.size();
    opening.head(soft) += rows.softness.cwiseProduct(answer.forces.cwiseQuotient(rows.weight).head(soft));
    const VectorXd settled_gap = qp.drawn_gap + qp.modes * answer.settled;
    return {settled_gap + opening.cwiseQuotient(rows.weight) + qp.modes * answer.motion, held.transpose() * load};
}

/// Displacements under the contact forces. Where their residual is more than rounding, a step of iterative refinement: what
/// they leave of closed gaps and of equilibrium is the right-hand side of a correction. It takes out the rounding of C and of
/// the pinned solutions, where the active set holds every motion. On a set that is not the answer's it makes things worse, and
/// is taken back.
void recover_refined(const AssemblyProblem& problem, const Rows& rows, const ContactQp& qp, const MatrixXd& held,
                     const std::vector<char>& active, int threads, ContactAnswer& answer, AssemblySolution& solution) {
    const auto recover = [&] {
        recover_displacements(problem, rows, answer.forces.cwiseQuotient(rows.weight), threads, solution);
        Remainder left = remainder_of(problem, rows, qp, held, answer, solution);
        solution.residual = contact_residual(qp, {answer.forces, left.gap, left.load});
        return left;
    };
    Remainder left = recover();
    if (solution.residual <= refined_residual) return;
    ContactQp correction = qp;
    correction.gap = std::move(left.gap);
    correction.mode_load = std::move(left.load);
    VectorXd forces, motion;
    if (!solve_on_set(correction, active, forces, motion)) return;
    const ContactAnswer before = answer;
    const double residual = solution.residual;
    answer.forces += forces;
    answer.motion += motion;
    recover();
    if (solution.residual <= residual) return;
    answer = before;
    recover();
}

}  // namespace

MatrixXd times_few(const MatrixXd& modes, const MatrixXd& combinations) {
    const Eigen::SparseMatrix<double> few = combinations.sparseView();
    if (few.nonZeros() == combinations.size()) return modes * combinations;
    return modes * few;
}

std::optional<VectorXd> balanced(const ContactQp& qp, const MatrixXd& levers, const VectorXd& forces) {
    constexpr double rounding = 1e-13, most_change = 0.02;
    MatrixXd motions(levers.rows(), qp.modes.cols() + levers.cols());
    motions << qp.modes, levers;
    VectorXd imbalance = VectorXd::Zero(motions.cols());
    imbalance.tail(levers.cols()) = levers.transpose() * forces;
    if (imbalance.cwiseAbs().maxCoeff() <= rounding * forces.cwiseAbs().sum()) return forces;
    VectorXd size = forces.cwiseAbs();
    for (const FrictionRow& f : qp.friction) size[f.normal] = size[f.tangential] = 0;  // their bounds stay as they are
    std::vector<Index> pressed;
    for (Index k = 0; k < size.size(); ++k)
        if (size[k] != 0) pressed.push_back(k);
    const MatrixXd of_pressed = motions(pressed, Eigen::all), weighted = size(pressed).asDiagonal() * of_pressed;
    const VectorXd amplitudes = least_squares(of_pressed.transpose() * weighted, imbalance);
    const VectorXd change = (size.array() != 0).select(-motions * amplitudes, 0.0);
    const VectorXd by = size.cwiseProduct(change),
                   most = (most_change * size).cwiseMax(neutral_work_fraction * size.maxCoeff());
    if (!(by.cwiseAbs().array() <= most.array()).all()) return std::nullopt;
    return forces + by;
}

namespace {

ContactQp under_motions(ContactQp qp, const MatrixXd& held) {
    qp.modes = times_few(qp.modes, held);
    qp.mode_load = held.transpose() * qp.mode_load;
    return qp;
}

}  // namespace

HeldAnswer::HeldAnswer(ContactQp of_all, MatrixXd motions)
    : qp(under_motions(std::move(of_all), motions)), held(std::move(motions)), result(solve_contact_qp(qp)) {
    for (FrictionRow& f : qp.friction) f.coefficient = std::min(f.coefficient, result.most_friction);
}

HeldAnswer::HeldAnswer(ContactQp of_all, MatrixXd motions, const VectorXd& start)
    : qp(under_motions(std::move(of_all), motions)), held(std::move(motions)) {
    const VectorXd lengths = held.colwise().squaredNorm();  // of motions that are orthogonal
    qp.near = (held.transpose() * start).cwiseQuotient(lengths);
    solve_from_near(qp, result);
}

HeldAnswer solve_held(const ContactQp& qp, const MotionSplit& split, const MatrixXd& levers, const VectorXd& start) {
    MatrixXd more(split.resisted.rows(), split.resisted.cols() + split.balanced.cols());
    more << split.resisted, split.balanced;
    // few contacts are found as soon from where bodies settle, on which those rest that carry nothing
    if (qp.compliance.is_sparse() && levers.cols() > 0 && start.size() > 0 && qp.expected.size() > 0 && qp.friction.empty()) {
        HeldAnswer from_start(qp, more, start);
        if (from_start.has_answer()) return from_start;
    }
    HeldAnswer answer(qp, split.resisted);
    if (levers.cols() == 0 || !answer.has_answer() || balanced(answer.qp, levers, answer.result.multipliers)) return answer;
    ContactQp again = qp;
    again.expected = answer.result.multipliers;
    again.near = VectorXd::Zero(more.cols());
    again.near.head(split.resisted.cols()) = answer.result.amplitudes();
    HeldAnswer all(std::move(again), std::move(more));
    all.result.iterations += answer.result.iterations;
    return all.has_answer() ? all : answer;
}

AssemblyRows assembly_rows(const AssemblyProblem& problem, int threads) {
    AssemblyRows all;
    all.rows = interface_rows(problem.parts, problem.interfaces, all.first_row, threads);
    if (problem.begins_touching) begin_touching(problem.parts, problem.interfaces, all.first_row, all.rows);
    for (const MeanConstraint& c : problem.constraints)
        append_mean_constraint(all.rows, problem.parts[static_cast<std::size_t>(c.part)], c.part, c.integrals, c.area,
                               c.coefficient, c.size, c.value);
    all.friction = friction_rows(problem, all.first_row);
    take_slips_before(problem, all);
    all.foundation = foundation_of(problem, all);
    all.expected = expected_multipliers(problem, all);
    return all;
}

AssemblyRows rows_among(const AssemblyRows& all, const std::vector<char>& taken) {
    ENSURE(taken.size() == at(all.rows.n), "a row is taken or not");
    const std::vector<Index> kept = members(taken);
    std::vector<int> number(taken.size(), -1);
    for (std::size_t k = 0; k < kept.size(); ++k) number[static_cast<std::size_t>(kept[k])] = static_cast<int>(k);
    AssemblyRows own;
    own.rows.n = static_cast<int>(kept.size());
    for (const Turning& t : all.rows.turning) {
        const auto own_arms = std::lower_bound(kept.begin(), kept.end(), t.arm.size()) - kept.begin();
        own.rows.turning.push_back({t.rotation, t.arm(std::vector<Index>(kept.begin(), kept.begin() + own_arms))});
    }
    own.rows.gap0 = all.rows.gap0(kept);
    own.rows.weight = all.rows.weight(kept);
    for (const Index row : kept) own.rows.unilateral.push_back(all.rows.unilateral[static_cast<std::size_t>(row)]);
    for (const std::vector<RowEntry>& entries : all.rows.by_part) {
        own.rows.by_part.emplace_back();
        for (const RowEntry& e : entries)
            if (number[at(e.row)] >= 0) own.rows.by_part.back().push_back({number[at(e.row)], e.coefficient, e.value});
    }
    for (const FrictionRow& f : all.friction)
        if (number[at(f.normal)] >= 0) own.friction.push_back({number[at(f.normal)], number[at(f.tangential)], f.coefficient});
    own.foundation = all.foundation(kept);
    if (all.expected.size() > 0 && !all.expected.isZero(0)) own.expected = all.expected(kept);
    return own;
}

namespace {

/// Amplitudes part by part.
std::vector<VectorXd> by_part(const std::vector<PartSystem>& parts, const VectorXd& amplitudes) {
    const std::vector<Index> offset = mode_offsets(parts);
    std::vector<VectorXd> own;
    for (std::size_t i = 0; i < parts.size(); ++i) own.emplace_back(amplitudes.segment(offset[i], offset[i + 1] - offset[i]));
    return own;
}
/// All in a row; empty where a part lacks its own.
VectorXd in_a_row(const std::vector<PartSystem>& parts, const std::vector<VectorXd>& own) {
    ENSURE(own.empty() || own.size() == parts.size(), "amplitudes are by part");
    const std::vector<Index> offset = mode_offsets(parts);
    VectorXd amplitudes(offset.back());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (own.empty() || own[i].size() != offset[i + 1] - offset[i]) return VectorXd(0);
        amplitudes.segment(offset[i], own[i].size()) = own[i];
    }
    return amplitudes;
}

/// A solution under some rows, before neutral motions are taken.
struct Attempt {
    RowsSolution answered;
    MatrixXd neutral{};
    bool is_driven = false;   ///< the mechanism is none of the rows'
    bool is_balanced = true;  ///< in the neutral motions in which contact forces have levers, too
    std::optional<OnWay> on_way{};
};

/// What friction came to on the way, by interface; of faces that nothing presses nothing. multipliers: by row, or none.
void fill_friction(const AssemblyProblem& problem, const AssemblyRows& all, const VectorXd& multipliers,
                   const std::optional<OnWay>& way, AssemblySolution& solution) {
    solution.friction.assign(problem.interfaces.size(), {});
    if (!way) return;
    solution.increments = way->increments;
    solution.is_way_broken = way->is_broken || problem.is_way_before_broken;
    if (multipliers.size() == 0) return;
    const VectorXd root_of_weight = all.rows.weight.cwiseSqrt(), pressures = multipliers.cwiseProduct(root_of_weight),
                   errors = way->error.cwiseQuotient(root_of_weight);  // what their rows' norms are L2 norms of, about
    for (std::size_t i = 0; i < problem.interfaces.size(); ++i) {
        const Interface& face = problem.interfaces[i];
        if (!face.friction) continue;
        const int n = n_rows(face), normal = all.first_row[i - 1], tangential = all.first_row[i];
        FrictionOnWay& own = solution.friction[i];
        if (const double pressure = pressures.segment(normal, n).norm(); pressure > 0)
            own.error = std::max(errors.segment(normal, n).norm(),
                                 errors.segment(tangential, n).norm() / std::min(1.0, *face.friction)) /
                        pressure;
        own.work = way->work.segment(tangential, n).sum();
        own.work_error = way->work_error.segment(tangential, n).sum();
    }
}

/// Do loads act on motions that others of the rows resist, those that are not among the chosen ones?
bool acts_beside(const MotionSplit& split, const VectorXd& load) {
    constexpr double rounding = 1e-9;
    VectorXd left = load;
    for (const MatrixXd* motions : {&split.resisted, &split.neutral}) left -= *motions * (motions->transpose() * load);
    return left.norm() > rounding * load.norm();
}

/// As drops_imbalance says.
void drop_imbalance(ContactQp& qp) {
    if (qp.modes.cols() == 0 || !qp.friction.empty()) return;
    const NonnegativeResult balance = nonnegative_least_squares(qp.modes.transpose(), -qp.mode_load, qp.unilateral);
    if (balance.residual.norm() <= neutral_work_fraction * qp.load_scale) qp.mode_load += balance.residual;
}

/// start: amplitudes, as of `solve_held`.
Attempt solve_under(const AssemblyProblem& problem, const AssemblyRows& all, const Resistance& resistance,
                    const VectorXd& start, int threads) {
    Attempt attempt;
    AssemblySolution& solution = attempt.answered.solution;
    Laps laps;
    const Rows& rows = all.rows;
    ContactQp qp = condense(problem.parts, rows, problem.load_scale, threads);
    scale_rows(qp, rows.weight);
    qp.foundation = all.foundation;
    qp.expected = all.expected;
    qp.friction = all.friction;
    if (problem.drops_imbalance) drop_imbalance(qp);
    solution.seconds.condensation = laps.lap();

    const MotionSplit split = split_motions(problem, resistance, qp.modes);
    attempt.neutral = split.neutral;
    find_driven_neutral_motion(problem, resistance, split.neutral, qp.mode_load, qp.load_scale, solution);
    attempt.is_driven = !solution.mechanism.empty();
    if (attempt.is_driven) return attempt;
    attempt.is_balanced = !acts_beside(split, qp.mode_load);
    if (!attempt.is_balanced) return attempt;
    const MatrixXd levers = times_few(qp.modes, split.balanced);
    std::optional<FrictionPath> path;
    if (!qp.friction.empty())
        path = follow_path(qp, path_start(problem, all, qp.modes), unheld_amplitudes(problem.parts, threads), rows.weight,
                           split, levers, problem.path_tolerance);
    if (path && problem.path_tolerance) attempt.on_way = std::move(path->way);
    const HeldAnswer held = path ? std::move(path->end) : solve_held(qp, split, levers, start);
    solution.iterations = path ? path->iterations : held.result.iterations;
    solution.is_one_of_several = attempt.on_way && held.has_answer() && has_another_answer(held.qp, held.result);
    solution.converged = held.result.converged;
    solution.used_fallback = held.result.used_fallback;
    solution.seconds.contact = laps.lap();
    if (!held.result.feasible) {
        solution.mechanism = part_motions(problem.parts, held.held * held.result.mechanism);
        solution.holding_factor = held.result.holding_factor;
        return attempt;
    }
    ContactAnswer answer{held.result.multipliers, held.result.settled, held.result.motion};
    if (held.result.mechanism.size() > 0) {
        solution.sliding = part_motions(problem.parts, held.held * held.result.mechanism);
        solution.holding_factor = held.result.holding_factor;
        recover_displacements(problem, rows, answer.forces.cwiseQuotient(rows.weight), threads, solution);
    } else {
        recover_refined(problem, rows, held.qp, held.held, held.result.active, threads, answer, solution);
        solution.residual = std::max(solution.residual, held.result.slip_of_steep);
    }
    if (levers.cols() > 0) {
        const std::optional<VectorXd> forces = balanced(held.qp, levers, answer.forces);
        attempt.is_balanced = forces.has_value();
        if (forces && *forces != answer.forces) {
            answer.forces = *forces;
            recover_displacements(problem, rows, answer.forces.cwiseQuotient(rows.weight), threads, solution);
        }
        if (!forces)  // the search under these motions, too, found nothing: what is left of their balance is said
            solution.residual = std::max(solution.residual, (levers.transpose() * answer.forces).cwiseAbs().maxCoeff() /
                                                                force_scale(held.qp, answer.forces));
    }
    VectorXd amplitudes = held.held * (answer.settled + answer.motion);
    if (path) amplitudes += path->moved;
    add_rigid_motions(problem, amplitudes, solution);
    if (held.held.cols() > split.resisted.cols()) solution.amplitudes = by_part(problem.parts, amplitudes);
    attempt.answered.multipliers = answer.forces.cwiseQuotient(rows.weight);
    solution.seconds.displacements = laps.lap();
    return attempt;
}

/// Of many rows, those that may close or were closed before, faces of friction as a whole: C is made of these alone, and the
/// gaps of the others are looked at under the displacements. What lies between faces that are not taken is not searched for
/// with friction, where bodies that nothing presses would make up most of it. Bearings of 80 rollers have 6800 rows, of which
/// 1800 take part; all of them would make a dense C of 600 MB.
class RowChoice {
public:
    RowChoice(const AssemblyProblem& problem, const AssemblyRows& all) : problem_(problem), all_(all) {
        const bool are_few = all.rows.n < few_rows || all.rows.softness.size() > 0;
        taken_.assign(at(all.rows.n), are_few ? 1 : 0);
        if (are_few) return;
        for (int row = 0; row < all.rows.n; ++row) taken_[at(row)] = !all.rows.unilateral[at(row)];
        for (const FrictionRow& f : all.friction) taken_[at(f.tangential)] = 0;
        knows_some_ = all.expected.size() > 0 && !all.expected.isZero(0);
        take_with_neighbours(knows_some_ ? all.expected : settled_forces());
        if (!problem.before.empty()) take_with_neighbours(closed_under(displacements_before(), closed_before));
    }

    bool is_all() const { return std::find(taken_.begin(), taken_.end(), 0) == taken_.end(); }
    /// Without an answer under these rows: those on which rigid bodies settle, too, with nothing expected; at last all.
    void widen() {
        if (std::exchange(knows_some_, false))
            take_with_neighbours(settled_forces());
        else
            std::fill(taken_.begin(), taken_.end(), 1);
        expected_ = is_all() ? VectorXd(0) : VectorXd::Zero(all_.rows.n);
    }

    /// The rows taken alone.
    AssemblyRows chosen() const {
        AssemblyRows own = rows_among(all_, taken_);
        if (expected_.size() > 0) own.expected = expected_.isZero(0) ? VectorXd(0) : VectorXd(expected_(members(taken_)));
        return own;
    }

    /// The multipliers of the chosen rows among all.
    VectorXd spread(const VectorXd& multipliers) const {
        VectorXd spread = VectorXd::Zero(all_.rows.n);
        Index next = 0;
        for (std::size_t row = 0; row < taken_.size(); ++row)
            if (taken_[row]) spread[static_cast<Index>(row)] = multipliers[next++];
        return spread;
    }

    /// Takes the rows, with their neighbours, that penetrate under the displacements of a solution. False: none does.
    bool take_penetrating(const RowsSolution& under) {
        const VectorXd penetrating = closed_under(under.solution.displacement, -gap_rounding);
        if (penetrating.isZero(0)) return false;
        expected_ = spread(under.multipliers);
        take_with_neighbours(penetrating);
        return true;
    }

private:
    /// Not zero: rows that are not taken yet, whose gaps are smaller than this under displacements, of the largest opening.
    VectorXd closed_under(const std::vector<VectorXd>& displacement, double least) const {
        VectorXd opening = VectorXd::Zero(all_.rows.n);
        for (std::size_t i = 0; i < problem_.parts.size(); ++i) opening += opening_of(all_.rows, i, displacement[i]);
        const VectorXd gap = all_.rows.gap0 + opening, w = all_.rows.weight;
        const double rounding = least * opening.cwiseQuotient(w).cwiseAbs().maxCoeff();
        VectorXd closed = VectorXd::Zero(gap.size());
        for (Index row = 0; row < gap.size(); ++row)
            closed[row] = !taken_[static_cast<std::size_t>(row)] && all_.rows.unilateral[static_cast<std::size_t>(row)] &&
                          gap[row] < rounding * w[row];
        return closed;
    }
    std::vector<VectorXd> displacements_before() const {
        std::vector<VectorXd> displacement;
        for (const StateBefore& before : problem_.before) displacement.push_back(before.displacement);
        return displacement;
    }
    /// Where rigid bodies would settle.
    VectorXd settled_forces() const {
        ContactQp qp = rigid_problem(problem_.parts, all_.rows, problem_.load_scale);
        scale_rows(qp, all_.rows.weight);
        qp.foundation = all_.foundation;
        return settle_rigidly(qp).multipliers;
    }

    /// Rows that are not zero in `forces`, and those beside; with friction all of their faces.
    void take_with_neighbours(const VectorXd& forces) {
        for (std::size_t f = 0; f < all_.first_row.size(); ++f) {
            const int begin = all_.first_row[f], n = n_rows(problem_.interfaces[f]), end = begin + n;
            if (problem_.interfaces[f].friction) continue;
            if (f + 1 < all_.first_row.size() && problem_.interfaces[f + 1].friction) {
                if (!forces.segment(begin, n).isZero(0)) std::fill(taken_.begin() + begin, taken_.begin() + end + n, 1);
                continue;
            }
            for (int row = begin; row < end; ++row)
                if (forces[row] != 0)
                    std::fill(taken_.begin() + std::max(begin, row - beside), taken_.begin() + std::min(end, row + beside + 1),
                              1);
        }
    }

    static constexpr int few_rows = 500;  // all of them cost less than a second look
    static constexpr int beside = 2;
    static constexpr double gap_rounding = 1e-14;  // of the largest opening
    static constexpr double closed_before = 1e-3;  // likewise: what other knots leave of a closed gap; more rows do no harm

    const AssemblyProblem& problem_;
    const AssemblyRows& all_;
    std::vector<char> taken_;
    bool knows_some_ = false;
    VectorXd expected_{};  // of a solution under fewer rows
};

}  // namespace

RowsSolution solve_rows(const AssemblyProblem& problem, const AssemblyRows& all, const Resistance& resistance, int threads) {
    RowChoice choice(problem, all);
    SolveSeconds spent;
    VectorXd start = in_a_row(problem.parts, problem.near);
    for (int iterations = 0;;) {
        const bool is_all = choice.is_all();
        Attempt attempt = is_all ? solve_under(problem, all, resistance, start, threads)
                                 : solve_under(problem, choice.chosen(), resistance, start, threads);
        AssemblySolution& solution = attempt.answered.solution;
        iterations += solution.iterations;
        spent += solution.seconds;
        start = in_a_row(problem.parts, solution.amplitudes);
        const bool has_answer = solution.mechanism.empty() && solution.converged && attempt.is_balanced;
        if (!is_all && !attempt.is_driven) {
            if (!has_answer) choice.widen();
            if (!has_answer || choice.take_penetrating(attempt.answered)) continue;
            attempt.answered.multipliers = choice.spread(attempt.answered.multipliers);
            if (attempt.on_way)
                for (VectorXd* v : {&attempt.on_way->error, &attempt.on_way->work, &attempt.on_way->work_error})
                    *v = choice.spread(*v);
        }
        if (!all.friction.empty()) fill_friction(problem, all, attempt.answered.multipliers, attempt.on_way, solution);
        solution.n_multipliers = all.rows.n;
        solution.contact_problems = std::count(all.rows.unilateral.begin(), all.rows.unilateral.end(), 1) > 0 ? 1 : 0;
        solution.iterations = iterations;
        Laps laps;
        if (solution.mechanism.empty()) take_least_motion(problem, attempt.neutral, threads, solution);
        if (solution.mechanism.empty() && solution.converged)
            take_least_loose_motion(problem, all, attempt.answered.multipliers, attempt.neutral, threads, solution);
        solution.seconds = spent;
        solution.seconds.displacements += laps.lap();
        return std::move(attempt.answered);
    }
}

void set_loads(const AssemblyProblem& problem, const Rows& rows, const VectorXd& multipliers, std::size_t part,
               AssemblySolution& solution) {
    const Index n = 2 * problem.parts[part].n();
    VectorXd contact_only = multipliers;
    contact_only.tail(static_cast<Index>(problem.constraints.size())).setZero();
    solution.contact_load[part] = load_of(rows, part, contact_only, static_cast<int>(n));
    solution.load[part] = problem.parts[part].load + load_of(rows, part, multipliers, static_cast<int>(n));
}

void split_multipliers(const AssemblyProblem& problem, const AssemblyRows& all, const VectorXd& multipliers,
                       AssemblySolution& solution) {
    ENSURE(multipliers.size() == all.rows.n && all.first_row.size() == problem.interfaces.size(),
           "multipliers are by row of these interfaces");
    for (std::size_t f = 0; f < problem.interfaces.size(); ++f)
        solution.pressure.push_back(
            all_coefficients(problem.interfaces[f], multipliers.segment(all.first_row[f], n_rows(problem.interfaces[f]))));
    const auto n = static_cast<Index>(problem.constraints.size());
    solution.constraint_force.assign(multipliers.end() - n, multipliers.end());
}

AssemblySolution solve_assembly(const AssemblyProblem& problem, int threads) {
    Laps laps;
    const AssemblyRows all = assembly_rows(problem, threads);
    const double of_rows = laps.lap();
    const Resistance resistance = candidate_resistance(problem);  // now: the points are still at hand in the cache
    const double of_resistance = laps.lap();
    auto [solution, multipliers] = solve_rows(problem, all, resistance, threads);
    solution.seconds.rows = of_rows;
    solution.seconds.contact += of_resistance;
    if (solution.mechanism.empty()) split_multipliers(problem, all, multipliers, solution);
    return std::move(solution);
}

}  // namespace abut::solver
