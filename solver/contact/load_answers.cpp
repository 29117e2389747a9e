// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/load_answers.hpp"

#include <algorithm>
#include <utility>

#include "solver/contact/condensation.hpp"
#include "solver/contact/friction_path.hpp"
#include "solver/linear_algebra/dense.hpp"
#include "solver/linear_algebra/parallel_for.hpp"
#include "src/base/ensure.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double carried_fraction = 1e-10;  // of the largest force: below, a row's is rounding

void ensure_parts(const AssemblyProblem& problem, const std::vector<VectorXd>& by_part) {
    ENSURE(by_part.size() == problem.parts.size(), "loads and measures have a vector for every part");
    for (std::size_t i = 0; i < by_part.size(); ++i)
        ENSURE(by_part[i].size() == 0 || by_part[i].size() == 2 * problem.parts[i].n(),
               "loads and measures have two numbers for every function");
}

/// The contact problem of all rows and motions.
ContactQp whole_problem(const AssemblyProblem& problem, const AssemblyRows& rows, int threads) {
    ContactQp qp = condense(problem.parts, rows.rows, problem.load_scale, threads);
    scale_rows(qp, rows.rows.weight);
    qp.foundation = rows.foundation;
    qp.expected = rows.expected;
    qp.friction = rows.friction;
    return qp;
}

}  // namespace

LoadAnswers::LoadAnswers(const AssemblyProblem& problem, std::vector<UnitLoad> loads,
                         const std::vector<DisplacementMeasure>& measures, int threads)
    : problem_(problem),
      loads_(std::move(loads)),
      rows_(assembly_rows(problem, threads)),
      resistance_(candidate_resistance(problem)),
      qp_(whole_problem(problem, rows_, threads)),
      modes_(qp_.modes),
      load_scale_(qp_.load_scale),
      gap_(qp_.gap),
      mode_load_(qp_.mode_load) {
    for (const UnitLoad& load : loads_) ensure_parts(problem, load.on_part);
    for (const DisplacementMeasure& measure : measures) ensure_parts(problem, measure);
    split_ = split_motions(problem, resistance_, modes_);
    levers_ = times_few(modes_, split_.balanced);
    qp_.modes = times_few(modes_, split_.resisted);
    respond_to_loads(threads);
    respond_to_measures(measures, threads);
}

void LoadAnswers::respond_to_loads(int threads) {
    const auto n_loads = static_cast<Index>(loads_.size());
    const std::vector<Index> offset = mode_offsets(problem_.parts);
    gaps_ = MatrixXd::Zero(rows_.rows.n, n_loads);
    mode_loads_ = unheld_of_loads_ = MatrixXd::Zero(offset.back(), n_loads);
    if (!rows_.friction.empty()) unheld_ = unheld_amplitudes(problem_.parts, threads);
    parallel_for(static_cast<int>(n_loads), threads, [&](int j) {
        std::vector<VectorXd> displacement(problem_.parts.size());
        for (std::size_t i = 0; i < problem_.parts.size(); ++i) {
            const VectorXd& load = loads_[static_cast<std::size_t>(j)].on_part[i];
            if (load.size() == 0) continue;
            const PartSystem& part = problem_.parts[i];
            displacement[i] = response(part, load);
            gaps_.col(j) += opening_of(rows_.rows, i, displacement[i]);
            mode_loads_.col(j).segment(offset[i], part.modes.cols()) = part.modes.transpose() * load;
        }
        if (!rows_.friction.empty()) unheld_of_loads_.col(j) = least_amplitudes(problem_.parts, displacement);
    });
    gaps_ = rows_.rows.weight.cwiseInverse().asDiagonal() * gaps_;
}

void LoadAnswers::respond_to_measures(const std::vector<DisplacementMeasure>& measures, int threads) {
    const NeutralMeasure neutral = neutral_measure(problem_, split_.neutral, threads);
    neutral_gram_ = neutral.gram;
    const auto n_asked = static_cast<Index>(measures.size()), n = n_asked + split_.neutral.cols();
    const auto n_loads = static_cast<Index>(loads_.size());
    const std::vector<Index> offset = mode_offsets(problem_.parts);
    measure_ = VectorXd::Zero(n);
    measures_of_loads_ = MatrixXd::Zero(n, n_loads);
    measures_of_rows_ = MatrixXd::Zero(n, rows_.rows.n);
    measures_of_modes_ = MatrixXd::Zero(n, offset.back());
    if (n == 0) return;
    const auto of_neutral = [&](std::size_t i, Index motion) -> VectorXd {
        if (neutral.integrals[i].size() == 0) return VectorXd(0);
        return neutral.integrals[i] * split_.neutral.col(motion).segment(offset[i], offset[i + 1] - offset[i]);
    };
    std::vector<VectorXd> always(problem_.parts.size());
    for (std::size_t i = 0; i < always.size(); ++i) always[i] = solve(problem_.parts[i], problem_.parts[i].load);
    parallel_for(static_cast<int>(n), threads, [&](int k) {
        for (std::size_t i = 0; i < problem_.parts.size(); ++i) {
            const PartSystem& part = problem_.parts[i];
            const VectorXd weight = k < n_asked ? measures[static_cast<std::size_t>(k)][i] : of_neutral(i, k - n_asked);
            if (weight.size() == 0 || weight.isZero(0)) continue;
            const VectorXd answer = response(part, weight);  // the stiffness is symmetric: weight' K^-1 f = answer' f
            measure_[k] += weight.dot(always[i]);
            for (Index j = 0; j < n_loads; ++j)
                if (const VectorXd& load = loads_[static_cast<std::size_t>(j)].on_part[i]; load.size() > 0)
                    measures_of_loads_(k, j) += answer.dot(load);
            if (rows_.rows.n > 0) measures_of_rows_.row(k) += opening_of(rows_.rows, i, answer);
            if (part.modes.cols() > 0)
                measures_of_modes_.row(k).segment(offset[i], part.modes.cols()) += weight.transpose() * part.modes;
        }
    });
}

LoadAnswers::Found LoadAnswers::search_anew(const VectorXd& mode_load, const VectorXd& factors) const {
    ContactQp all = qp_;
    all.modes = modes_;
    all.mode_load = mode_load;
    std::optional<FrictionPath> path;
    if (!all.friction.empty() && problem_.path_tolerance)
        path = follow_path(all, path_start(problem_, rows_, modes_), unheld_ + unheld_of_loads_ * factors, rows_.rows.weight,
                           split_, levers_, *problem_.path_tolerance);
    HeldAnswer held = path ? std::move(path->end) : solve_held(all, split_, levers_);
    if (held.result.mechanism.size() > 0) return {held.result, held.held * held.result.mechanism};
    if (levers_.cols() > 0)
        if (const std::optional<VectorXd> forces = balanced(held.qp, levers_, held.result.multipliers))
            held.result.multipliers = *forces;
    VectorXd amplitudes = held.held * held.result.amplitudes();
    if (path) amplitudes += path->moved;
    return {held.result, amplitudes};
}

LoadAnswers::Found LoadAnswers::search(const VectorXd& mode_load, const VectorXd& factors) {
    if (!rows_.friction.empty()) return search_anew(mode_load, factors);
    if (ContactQpResult result; factor_ && solve_from_neighbour(qp_, resisted_amplitudes_, *factor_, result)) {
        const std::optional<VectorXd> forces =
            levers_.cols() > 0 ? balanced(qp_, levers_, result.multipliers) : std::optional(result.multipliers);
        if (forces) {
            result.multipliers = *forces;
            return {result, split_.resisted * result.amplitudes()};
        }
    }
    return search_anew(mode_load, factors);
}

LoadAnswer LoadAnswers::answer(const VectorXd& factors) {
    ENSURE(factors.size() == static_cast<Index>(loads_.size()), "every load has a factor");
    LoadAnswer answer;
    qp_.gap = gap_ + gaps_ * factors;
    const VectorXd mode_load = mode_load_ + mode_loads_ * factors;
    qp_.mode_load = split_.resisted.transpose() * mode_load;
    qp_.load_scale = load_scale_;
    for (std::size_t j = 0; j < loads_.size(); ++j)
        qp_.load_scale = std::max(qp_.load_scale, std::abs(factors[static_cast<Index>(j)]) * loads_[j].scale);
    AssemblySolution driven;
    find_driven_neutral_motion(problem_, resistance_, split_.neutral, mode_load, qp_.load_scale, driven);
    answer.mechanism = std::move(driven.mechanism);
    if (!answer.mechanism.empty()) return answer;
    const Found found = search(mode_load, factors);
    answer.iterations = found.result.iterations;
    answer.converged = found.result.converged;
    if (found.result.mechanism.size() > 0) answer.mechanism = part_motions(problem_.parts, found.amplitudes);
    if (!answer.mechanism.empty() || !answer.converged) return answer;
    qp_.expected = found.result.multipliers;
    // rows that carry nothing but rounding would come and go
    const double carried = carried_fraction * qp_.expected.lpNorm<Eigen::Infinity>();
    qp_.expected = (qp_.expected.array().abs() > carried).select(qp_.expected, 0.0);
    resisted_amplitudes_ = split_.resisted.transpose() * found.amplitudes;
    if (!factor_) factor_ = std::make_unique<ClosedFactor>(qp_.compliance, qp_.expected);
    answer.multipliers = found.result.multipliers.cwiseQuotient(rows_.rows.weight);
    answer.amplitudes = found.amplitudes;
    AssemblySolution told;
    split_multipliers(problem_, rows_, answer.multipliers, told);
    answer.pressure = std::move(told.pressure);
    answer.constraint_force = std::move(told.constraint_force);
    answer.measured = measured(factors, answer);
    return answer;
}

/// With the neutral motions of least displacement, which it takes into the answer's amplitudes.
VectorXd LoadAnswers::measured(const VectorXd& factors, LoadAnswer& answer) const {
    const Index n_neutral = split_.neutral.cols(), n_asked = measure_.size() - n_neutral;
    VectorXd values = measure_ + measures_of_loads_ * factors + measures_of_rows_ * answer.multipliers +
                      measures_of_modes_ * answer.amplitudes;
    if (n_neutral == 0) return values;
    const VectorXd least = split_.neutral * PivotedCholesky(neutral_gram_).solve(-values.tail(n_neutral));
    answer.amplitudes += least;
    return values.head(n_asked) + measures_of_modes_.topRows(n_asked) * least;
}

std::vector<VectorXd> LoadAnswers::displacements(const VectorXd& factors, const LoadAnswer& answer, int threads) const {
    ENSURE(factors.size() == static_cast<Index>(loads_.size()) && answer.multipliers.size() == rows_.rows.n,
           "an answer is of these rows, and every load has a factor");
    const std::vector<Index> offset = mode_offsets(problem_.parts);
    std::vector<VectorXd> displacement(problem_.parts.size());
    parallel_for(static_cast<int>(displacement.size()), threads, [&](int k) {
        const auto i = static_cast<std::size_t>(k);
        const PartSystem& part = problem_.parts[i];
        VectorXd load = part.load + load_of(rows_.rows, i, answer.multipliers, 2 * part.n());
        for (std::size_t j = 0; j < loads_.size(); ++j)
            if (loads_[j].on_part[i].size() > 0) load += factors[static_cast<Index>(j)] * loads_[j].on_part[i];
        displacement[i] = solve(part, load) + part.modes * answer.amplitudes.segment(offset[i], part.modes.cols());
    });
    return displacement;
}

}  // namespace abut::solver
