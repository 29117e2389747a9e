// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/contact_qp.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "solver/contact/active_set.hpp"
#include "solver/contact/friction.hpp"
#include "solver/contact/interior_point.hpp"
#include "solver/contact/rigid_settle.hpp"
#include "solver/linear_algebra/nonnegative.hpp"
#include "src/base/ensure.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int max_passes = 20;
constexpr int reduced_passes = 7;                 // then the proximal term stays: less is rounding
constexpr double first_proximal_fraction = 1e-6;  // of the foundation's stiffness; tenfold less each pass
/// The same from a neighbour's answer, of which nothing is to go far: passes, E of the first, and by which it becomes less.
constexpr int near_passes = 40;
constexpr double near_proximal_fraction = 1, near_reduction = 0.3;
/// Of the largest multiplier: rows that carry less are not begun with. The interior point method leaves so much on open ones.
constexpr double least_carried = 1e-10;
constexpr double least_stiffness = 1e-6;        // of the mean one, for motions that the foundation hardly resists
constexpr double feasibility_tolerance = 1e-8;  // relative to the loads: below, the residual is rounding, not a mechanism

double equilibrium_error(const ContactQp& qp, const VectorXd& multipliers) {
    if (qp.modes.cols() == 0) return 0;
    return (qp.modes.transpose() * multipliers + qp.mode_load).cwiseAbs().maxCoeff();
}

bool is_balanced(const ContactQp& qp, const VectorXd& multipliers) {
    return equilibrium_error(qp, multipliers) <= equilibrium_tolerance * force_scale(qp, multipliers);
}

/// E of the first pass: positive definite however the rows lie.
MatrixXd first_proximal(const MatrixXd& stiffness, double fraction) {
    const Index n = stiffness.cols();
    if (n == 0) return stiffness;
    const double mean = stiffness.trace() / static_cast<double>(n);
    return fraction * (stiffness + least_stiffness * mean * MatrixXd::Identity(n, n));
}

/// The primal-dual active set on the problem itself. Where it does not find the answer nothing is changed.
SetSearch solve_exactly(const ShiftedQp& shifted, ClosedFactor& factor, ContactState& state, ContactQpResult& result) {
    const Index n = shifted.qp.modes.cols();
    ContactState exact;
    ActiveSet active = result.active;
    const Proximal none{MatrixXd::Zero(n, n), VectorXd::Zero(n)};
    const SetSearch search = primal_dual(shifted, none, active, factor, exact, result.iterations);
    if (search != SetSearch::found) return search;
    if (!is_balanced(shifted.qp, exact.multipliers)) return SetSearch::singular;
    state = std::move(exact);
    result.active = std::move(active);
    return search;
}

/// The same on one set, which may leave motions free as long as they balance: a single point that carries all.
bool holds_exactly(const ShiftedQp& shifted, const VectorXd& anchor, const ActiveSet& active, ClosedFactor& factor,
                   ContactState& state) {
    const Index n = shifted.qp.modes.cols();
    ContactState exact;
    if (!solve_on(shifted, {MatrixXd::Zero(n, n), anchor}, active, factor, exact) &&
        !solve_least_motion(shifted, anchor, active, factor, exact))
        return false;
    if (next_set(shifted, active, exact) != active || !is_balanced(shifted.qp, exact.multipliers)) return false;
    state = std::move(exact);
    return true;
}

/// Passes with less and less of the proximal term. state: the start's multipliers, and the answer. repeats: the primal-dual
/// active set is known to come back to the same sets, and is left out. may_descend: the descending set is tried where a pass
/// loses its own.
bool run_passes(const ShiftedQp& shifted, const MatrixXd& stiffness, bool repeats, bool may_descend, ClosedFactor& factor,
                ContactState& state, ContactQpResult& result) {
    Proximal proximal{first_proximal(stiffness, first_proximal_fraction), VectorXd::Zero(shifted.qp.modes.cols())};
    for (int pass = 0; pass < max_passes; ++pass) {
        const VectorXd before = state.multipliers;
        const ActiveSet start = result.active;
        if (repeats || primal_dual(shifted, proximal, result.active, factor, state, result.iterations) != SetSearch::found) {
            if (!may_descend) return false;
            repeats = result.used_fallback = true;
            result.active = start;
            state.multipliers = before;
            if (!descend(shifted, proximal, result.active, factor, state, result.iterations)) return false;
        }
        if (holds_exactly(shifted, proximal.anchor, result.active, factor, state)) return true;
        if (is_balanced(shifted.qp, state.multipliers)) return true;
        proximal.anchor = state.amplitudes;
        if (pass + 1 < reduced_passes) proximal.stiffness *= 0.1;
    }
    return false;
}

/// The rows that are closed where these are the multipliers.
ActiveSet closed_by(const ContactQp& qp, const VectorXd& multipliers) {
    ActiveSet active = bilateral_rows(qp);
    const double least = multipliers.size() > 0 ? least_carried * multipliers.cwiseAbs().maxCoeff() : 0;
    for (std::size_t k = 0; k < active.size(); ++k)
        if (multipliers[static_cast<Index>(k)] > least) active[k] = 1;
    return active;
}

/// The motion that no pressures >= 0 can keep in balance; false where some can.
bool find_mechanism(const ContactQp& qp, ContactQpResult& result) {
    const NonnegativeResult balance = nonnegative_least_squares(qp.modes.transpose(), -qp.mode_load, qp.unilateral);
    if (balance.residual.norm() <= feasibility_tolerance * force_scale(qp, balance.x)) return false;
    result.feasible = false;
    result.mechanism = -balance.residual;
    return true;
}

/// closing: C l.
double residual_of(const ContactQp& qp, const ContactConditions& c, const VectorXd& closing) {
    if (c.gap.size() == 0) return 0;
    const ResidualScales scales = residual_scales(qp, c, closing);
    double worst = c.imbalance.size() > 0 ? over_scale(c.imbalance.cwiseAbs().maxCoeff(), scales.force) : 0;
    for (Index k = 0; k < c.gap.size(); ++k) worst = std::max(worst, row_residual(qp, c, scales, k));
    return worst;
}

void conclude(const ShiftedQp& shifted, const VectorXd& settled, ContactState& state, ContactQpResult& result) {
    const ContactQp& qp = shifted.qp;
    result.gap = gap_of(shifted, state);
    const VectorXd imbalance = qp.modes.transpose() * state.multipliers + qp.mode_load;
    result.residual = residual_of(qp, {state.multipliers, result.gap, imbalance}, state.closing);
    result.multipliers = std::move(state.multipliers);
    result.settled = settled;
    result.motion = std::move(state.amplitudes);
}

/// The same where sets leave bodies free, on which no load acts: they stay where they settled, as far as nothing penetrates.
bool solve_leaving_free(const ShiftedQp& shifted, ClosedFactor& factor, ContactState& state, ContactQpResult& result) {
    ContactState exact;
    ActiveSet active = result.active;
    if (primal_dual_or_least_motion(shifted, active, factor, exact, result.iterations) != SetSearch::found) return false;
    if (!is_balanced(shifted.qp, exact.multipliers)) return false;
    state = std::move(exact);
    result.active = std::move(active);
    return true;
}

/// Where sets repeat or leave a motion free: the interior point method, and from the rows that it finds closed the exact
/// answer, or else its own. False: nothing is changed.
bool solve_from_inside(const ShiftedQp& shifted, const VectorXd& start, ClosedFactor& factor, ContactState& state,
                       ContactQpResult& result) {
    InteriorPoint inside = interior_point(shifted, start);
    result.iterations += inside.iterations;
    if (!inside.converged) return false;
    result.used_fallback = true;
    const ActiveSet before = std::exchange(result.active, inside.active);
    if (solve_exactly(shifted, factor, state, result) == SetSearch::found) return true;
    result.active = inside.active;
    if (holds_exactly(shifted, inside.state.amplitudes, result.active, factor, state)) return true;
    if (!is_balanced(shifted.qp, inside.state.multipliers)) {
        result.active = before;
        return false;
    }
    state = std::move(inside.state);
    return true;
}

/// The search from the expected set; the amplitudes from where the bodies would settle on it, or else on all rows. False:
/// nothing is known from it.
bool solve_from_expected(const ContactQp& qp, const std::function<const Settled&()>& settled_on_all, ContactQpResult& result) {
    result.active = closed_by(qp, qp.expected);
    std::optional<VectorXd> settled = settle_on(qp, result.active);
    const bool holds_all = settled.has_value();
    if (!holds_all && qp.near.size() > 0 && solve_from_near(qp, result)) return true;
    if (!holds_all) {
        result.active = closed_by(qp, qp.expected);
        if (!settled_on_all().balanced) return false;
        settled = settled_on_all().amplitudes;
    }
    const ShiftedQp near{qp, qp.gap + qp.modes * *settled};
    ContactState state{qp.expected, VectorXd::Zero(qp.modes.cols()), {}};
    ClosedFactor factor(qp.compliance, qp.expected);
    const SetSearch search = holds_all ? solve_exactly(near, factor, state, result) : SetSearch::singular;
    result.converged =
        search == SetSearch::found || (search == SetSearch::singular && solve_leaving_free(near, factor, state, result));
    if (!result.converged) return false;
    conclude(near, *settled, state, result);
    return true;
}

bool state_on_set(const ContactQp& qp, const ActiveSet& active, ContactState& state) {
    const ShiftedQp as_given{qp, qp.gap};
    const Index n = qp.modes.cols();
    const Proximal none{MatrixXd::Zero(n, n), VectorXd::Zero(n)};
    ClosedFactor factor(qp.compliance, VectorXd::Zero(qp.gap.size()));
    return solve_on(as_given, none, active, factor, state) || solve_least_motion(as_given, none.anchor, active, factor, state);
}

/// Without unilateral rows there is one linear system. False: it does not answer (a motion is free, or C singular).
bool solve_linear(const ContactQp& qp, ContactQpResult& result) {
    const auto is_unilateral = [](char c) { return c != 0; };
    if (qp.gap.size() == 0 || std::any_of(qp.unilateral.begin(), qp.unilateral.end(), is_unilateral)) return false;
    ContactState state;
    if (!state_on_set(qp, result.active, state) || !is_balanced(qp, state.multipliers)) return false;
    conclude({qp, qp.gap}, VectorXd::Zero(qp.modes.cols()), state, result);
    result.converged = true;
    return true;
}

void ensure_shapes(const ContactQp& qp) {
    const Index m = qp.gap.size(), n = qp.mode_load.size();
    ENSURE(qp.compliance.rows() == m && qp.compliance.cols() == m, "the compliance couples all rows");
    ENSURE((qp.modes.rows() == m || n == 0) && qp.modes.cols() == n, "every motion moves all rows, and has a load");
    ENSURE(static_cast<Index>(qp.unilateral.size()) == m && qp.foundation.size() == m && qp.drawn_gap.size() == m,
           "every row has a kind, a foundation and a drawn gap");
    ENSURE(qp.expected.size() == 0 || qp.expected.size() == m, "every row has an expected multiplier, or none");
    ENSURE(qp.near.size() == 0 || (qp.near.size() == n && qp.expected.size() > 0),
           "all amplitudes are expected, with multipliers");
}

}  // namespace

bool solve_from_near(const ContactQp& qp, ContactQpResult& result) {
    const bool has_many = qp.compliance.is_sparse();
    const ShiftedQp near{qp, qp.gap + qp.modes * qp.near};
    result.active = closed_by(qp, qp.expected);
    ContactState state{qp.expected, VectorXd::Zero(qp.modes.cols()), {}};
    ClosedFactor factor(qp.compliance, qp.expected);
    Proximal proximal{first_proximal(foundation_stiffness(qp), near_proximal_fraction), VectorXd::Zero(qp.modes.cols())};
    if (has_many) {
        result.converged = solve_exactly(near, factor, state, result) == SetSearch::found;
        if (!result.converged) result.active = closed_by(qp, qp.expected);
    }
    for (int pass = 0; pass < near_passes && !result.converged; ++pass) {
        const ActiveSet before = result.active;
        // the interior point method takes as long as a few rows that trade places one by one
        if (pivot_by_blocks(near, proximal, !has_many, result.active, factor, state, result.iterations) != SetSearch::found) {
            if (!has_many || !solve_from_inside(near, qp.expected, factor, state, result)) return false;
            result.converged = true;
            break;
        }
        result.converged = is_balanced(qp, state.multipliers) ||
                           (result.active == before && holds_exactly(near, proximal.anchor, before, factor, state));
        proximal.anchor = state.amplitudes;
        proximal.stiffness *= near_reduction;
    }
    if (result.converged) conclude(near, qp.near, state, result);
    return result.converged;
}

bool solve_from_neighbour(const ContactQp& qp, const VectorXd& amplitudes, ClosedFactor& factor, ContactQpResult& result) {
    ensure_shapes(qp);
    ENSURE(amplitudes.size() == qp.modes.cols() && qp.expected.size() == qp.gap.size(), "a neighbour has as many unknowns");
    const ShiftedQp near{qp, qp.gap + qp.modes * amplitudes};
    ContactState state;
    ActiveSet active = closed_by(qp, qp.expected);
    result.iterations = 0;
    result.converged = primal_dual_or_least_motion(near, active, factor, state, result.iterations) == SetSearch::found &&
                       is_balanced(qp, state.multipliers);
    if (!result.converged) return false;
    result.active = std::move(active);
    conclude(near, amplitudes, state, result);
    return true;
}

ContactQpResult solve_contact_qp(const ContactQp& qp) {
    ensure_shapes(qp);
    ContactQpResult result;
    result.active = bilateral_rows(qp);
    if (!qp.gap.allFinite() || !qp.modes.allFinite()) {  // of cells that coordinates hardly tell apart: nothing converges
        result.multipliers = VectorXd::Zero(qp.gap.size());
        result.settled = result.motion = VectorXd::Zero(qp.modes.cols());
        result.gap = qp.gap;
        return result;
    }
    if (!qp.friction.empty()) return solve_with_friction(qp);
    result.multipliers = result.settled = result.motion = result.gap = VectorXd(0);
    if (qp.gap.size() == 0 && qp.modes.cols() == 0) {
        result.converged = true;
        return result;
    }
    if (solve_linear(qp, result)) return result;
    std::optional<Settled> settled;
    const auto settled_on_all = [&]() -> const Settled& {
        if (!settled) settled = settle_rigidly(qp);
        return *settled;
    };
    if (qp.expected.size() > 0 && solve_from_expected(qp, settled_on_all, result)) return result;
    const Settled& start = settled_on_all();
    if (!start.balanced && find_mechanism(qp, result)) return result;

    // amplitudes from where the bodies settle: a clearance, however wide, then leaves no rounding in the elastic answer
    const ShiftedQp near{qp, qp.gap + qp.modes * start.amplitudes};
    ContactState state{start.multipliers, VectorXd::Zero(qp.modes.cols()), {}};
    ClosedFactor factor(qp.compliance, start.multipliers);
    result.active = closed_by(qp, start.multipliers);
    // sets of many contacts that are not found from what is expected seldom are from the settle's
    const bool has_many = qp.compliance.is_sparse();
    const SetSearch search =
        has_many && qp.expected.size() > 0 ? SetSearch::repeated : solve_exactly(near, factor, state, result);
    const auto pass = [&](bool may_descend) {
        result.active = closed_by(qp, start.multipliers);
        state = {start.multipliers, VectorXd::Zero(qp.modes.cols()), {}};
        const bool repeats = may_descend && search == SetSearch::repeated;
        return run_passes(near, start.stiffness, repeats, may_descend, factor, state, result);
    };
    const auto leave_free = [&] {
        result.active = closed_by(qp, start.multipliers);
        return solve_leaving_free(near, factor, state, result);
    };
    result.converged = search == SetSearch::found ||
                       (search == SetSearch::singular && (has_many ? leave_free() : pass(false))) ||
                       solve_from_inside(near, start.multipliers, factor, state, result) || pass(!has_many);
    if (!result.converged) state.closing = qp.compliance * state.multipliers;
    conclude(near, start.amplitudes, state, result);
    return result;
}

double contact_residual(const ContactQp& qp, const ContactConditions& c) {
    if (!qp.friction.empty()) return friction_residual(qp, c);
    return residual_of(qp, c, qp.compliance * c.multipliers);
}

ResidualScales residual_scales(const ContactQp& qp, const ContactConditions& c, const VectorXd& closing) {
    if (c.gap.size() == 0) return {force_scale(qp, c.multipliers), 0, 0};
    const double least = feasibility_tolerance * qp.load_scale, largest = std::max(least, c.multipliers.cwiseAbs().maxCoeff());
    const double of_least = least * qp.compliance.diagonal().maxCoeff();
    return {force_scale(qp, c.multipliers), largest, std::max(of_least, (largest > 0 ? closing : c.gap).cwiseAbs().maxCoeff())};
}

double over_scale(double value, double scale) {
    return scale > 0 ? value / scale : 0;
}

double row_residual(const ContactQp& qp, const ContactConditions& c, const ResidualScales& scales, Index row) {
    if (!qp.unilateral[static_cast<std::size_t>(row)])  // what is prescribed has its own rounding
        return over_scale(std::abs(c.gap[row]), std::max(scales.length, std::abs(qp.gap[row])));
    const double l = over_scale(c.multipliers[row], scales.multiplier), g = over_scale(c.gap[row], scales.length);
    return std::max({-l, -g, std::min(l, g)});
}

bool solve_on_set(const ContactQp& qp, const std::vector<char>& active, VectorXd& multipliers, VectorXd& amplitudes) {
    ensure_shapes(qp);
    ENSURE(active.size() == qp.unilateral.size(), "every row is closed or open");
    ContactState state;
    if (!(qp.friction.empty() ? state_on_set(qp, active, state) : state_with_friction(qp, active, state))) return false;
    multipliers = std::move(state.multipliers);
    amplitudes = std::move(state.amplitudes);
    return true;
}

}  // namespace abut::solver
