// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/friction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solver/contact/friction_pivots.hpp"
#include "solver/contact/friction_states.hpp"
#include "solver/contact/rigid_settle.hpp"
#include "solver/linear_algebra/dense.hpp"
#include "solver/linear_algebra/nonnegative.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double answer_residual = 1e-9;  // of the conditions: what pivots find, ties and all, is no answer above
constexpr double cone_tolerance = 1e-8;   // relative to the loads: below, the residual is rounding, not a mechanism
constexpr double trifle_fraction = 1e-9;  // of the foundation's stiffness: a term that next to no load is left to
constexpr int trifle_passes = 4;
/// Creep: the term, of the foundation's stiffness; what it bears, of the loads and of the pass before, where the bodies slide,
/// where they may, and where they come to rest so slowly that it is reduced; and its passes, of which the first still find the
/// contacts.
constexpr double creep_fraction = 1e-3, creep_load = 1e-6, creep_lasts = 1 - 1e-4, creep_is_slow = 0.9, creep_halves = 0.5;
constexpr int creep_passes = 24, steady_passes = 4;
/// What slides is stopped by rows that come so fast, of how fast it slips. Slower ones are those of round faces that slide.
constexpr double stop_slope = 0.1, stop_rounding = 1e-6;
/// Of the largest elastic closing.
constexpr double far_slip = 10;
/// Mechanisms: how much larger coefficients are looked at, and how closely; of sliding bodies, whose pressures change with it.
constexpr double largest_factor = 1000, factor_accuracy = 1e-5, sliding_accuracy = 5e-5;
constexpr int factors_tried = 16;
/// Coefficients from which on an answer is looked for from a second start, and by how much of the largest force it differs.
constexpr double large_coefficient = 0.5, differs = 1e-6;
/// Above those of any pair of materials; work against slip that is a trifle to steep friction, of the elastic energy.
constexpr double moderate_coefficient = 5, trifle_of_slip = 1e-4;

VectorXd imbalance_of(const ContactQp& qp, const VectorXd& multipliers) {
    return qp.modes.transpose() * multipliers + qp.mode_load;
}

bool is_in_balance(const ContactQp& qp, const VectorXd& multipliers) {
    constexpr double tolerance = 1e-10;  // relative to the loads
    if (qp.modes.cols() == 0) return true;
    return imbalance_of(qp, multipliers).cwiseAbs().maxCoeff() <= tolerance * force_scale(qp, multipliers);
}

Proximal no_term(Index n) {
    return {MatrixXd::Zero(n, n), VectorXd::Zero(n)};
}

/// Positive definite however the rows lie: a fraction of the foundation's stiffness.
Proximal term_of(const MatrixXd& stiffness, double fraction) {
    constexpr double least = 1e-6;
    const Index n = stiffness.cols();
    Proximal proximal = no_term(n);
    if (n == 0) return proximal;
    const double mean = stiffness.trace() / static_cast<double>(n);
    proximal.stiffness = fraction * (stiffness + least * mean * MatrixXd::Identity(n, n));
    return proximal;
}

void write_answer(const ShiftedQp& shifted, const VectorXd& settled, ContactState& state, ContactQpResult& result) {
    result.gap = gap_of(shifted, state);
    result.residual =
        friction_residual(shifted.qp, {state.multipliers, result.gap, imbalance_of(shifted.qp, state.multipliers)});
    result.multipliers = std::move(state.multipliers);
    result.settled = settled;
    result.motion = std::move(state.amplitudes);
}

/// Amplitudes measured from where a pass has left the bodies: what nothing holds stays there.
ShiftedQp moved_to(const ShiftedQp& shifted, const VectorXd& amplitudes) {
    return {shifted.qp, amplitudes.size() > 0 ? VectorXd(shifted.gap + shifted.qp.modes * amplitudes) : shifted.gap};
}

/// The search without a proximal term, from the states in `result` and the amplitudes in `state`, if any; where it does not
/// find the answer nothing is changed.
bool search_exactly(const ShiftedQp& shifted, ContactState& state, ContactQpResult& result) {
    ContactState exact;
    ActiveSet states = result.active;
    const ShiftedQp near = moved_to(shifted, state.amplitudes);
    if (search_states(near, no_term(near.qp.modes.cols()), states, exact, result.iterations) != SetSearch::found ||
        !is_in_balance(near.qp, exact.multipliers))
        return false;
    if (state.amplitudes.size() > 0) exact.amplitudes += state.amplitudes;
    state = std::move(exact);
    result.active = std::move(states);
    return true;
}

double residual_of(const ShiftedQp& shifted, const ContactState& state) {
    return friction_residual(shifted.qp,
                             {state.multipliers, gap_of(shifted, state), imbalance_of(shifted.qp, state.multipliers)});
}

/// Does a state meet all conditions but for the rounding of ties?
bool meets_conditions(const ShiftedQp& shifted, const ContactState& state) {
    return residual_of(shifted, state) <= answer_residual && is_in_balance(shifted.qp, state.multipliers);
}

/// The state under a proximal term, from the one given and the states in `result`; false: none was found.
bool solve_pass(const ShiftedQp& shifted, const Proximal& proximal, ContactState& state, ContactQpResult& result) {
    ActiveSet states = result.active;
    ContactState there;
    if (search_states(shifted, proximal, states, there, result.iterations) == SetSearch::found) {
        result.active = std::move(states);
        state = std::move(there);
        return true;
    }
    result.used_fallback = true;
    return pivot_states(shifted, proximal, result.active, state, result.iterations);
}

/// The answer on a pass's states without the term, from where it has left the bodies.
std::optional<ContactState> without_term(const ShiftedQp& shifted, const ContactState& state, const ActiveSet& states) {
    const ShiftedQp near = moved_to(shifted, state.amplitudes);
    ContactState exact;
    if (!solve_states(near, no_term(near.qp.modes.cols()), states, exact)) return std::nullopt;
    exact.amplitudes += state.amplitudes;
    return exact;
}

/// The answer by pivots from a state and the states in `result`, under a term that is a trifle: what it still bears of what
/// contacts hold is less with each pass; but for rounding where nothing resists, as between faces that slip on both sides.
/// False: it is not found.
bool pivot_to_answer(const ShiftedQp& shifted, const MatrixXd& stiffness, ContactState& state, ContactQpResult& result) {
    result.used_fallback = true;
    Proximal term = term_of(stiffness, trifle_fraction);
    for (int pass = 0; pass < trifle_passes; ++pass) {
        term.anchor = state.amplitudes;
        if (!pivot_states(shifted, term, result.active, state, result.iterations)) return false;
        if (search_exactly(shifted, state, result)) return true;
        std::optional<ContactState> exact = without_term(shifted, state, result.active);
        if (exact && meets_conditions(shifted, *exact)) {
            state = std::move(*exact);
            return true;
        }
        if (meets_conditions(shifted, state) || (!exact && residual_of(shifted, state) <= answer_residual)) return true;
    }
    return false;
}

/// Bodies that slide on and on: how they move in a pass of creep, and by which factor friction would have to be larger to bear
/// in it what the term does.
struct Sliding {
    VectorXd motion;
    double factor;
};

/// How often the last motion fits into the way to what stops it; 0: nothing does. The first row that it closes tells.
double way_to_stop(const ShiftedQp& shifted, const VectorXd& motion, const ContactState& state, const ActiveSet& states) {
    const VectorXd gap = gap_of(shifted, state), rate = shifted.qp.modes * motion;
    std::vector<char> is_tangential(states.size(), 0);
    double slip = 0, way = std::numeric_limits<double>::infinity(), slope = 0;
    for (const FrictionRow& f : shifted.qp.friction) {
        is_tangential[static_cast<std::size_t>(f.tangential)] = 1;
        if (states[static_cast<std::size_t>(f.normal)] != row_state::open) slip = std::max(slip, std::abs(rate[f.tangential]));
    }
    for (std::size_t k = 0; k < states.size(); ++k) {
        const auto row = static_cast<Index>(k);
        if (is_tangential[k] || states[k] != row_state::open || !(-rate[row] > stop_rounding * slip)) continue;
        if (gap[row] > -rate[row] * way) continue;
        way = gap[row] / -rate[row];
        slope = -rate[row];
    }
    return slope >= stop_slope * slip && std::isfinite(way) ? way : 0;
}

/// What creep ends with: bodies that rest, or slide; neither where no state was found, or where what moves does not slip (what
/// rolls), or moves on too slowly to tell.
struct Creep {
    bool rests = false;
    std::optional<Sliding> sliding{};
};

Creep sliding_in(const ContactQp& qp, const ContactState& state, const VectorXd& motion) {
    double friction = 0;
    for (const FrictionRow& f : qp.friction)
        friction -= state.multipliers[f.tangential] * qp.modes.row(f.tangential).dot(motion);
    const double left = imbalance_of(qp, state.multipliers).dot(motion);
    if (!(left > 0 && left < largest_factor * friction)) return {};
    return {false, Sliding{motion, 1 + left / friction}};
}

/// Which rows are pressed, whether they stick or slip.
std::vector<char> pressed_in(const ActiveSet& states) {
    std::vector<char> pressed(states.size());
    std::transform(states.begin(), states.end(), pressed.begin(), [](char state) { return state != row_state::open; });
    return pressed;
}

/// Bodies held back by a term that forgets how far they came, from pass to pass: where there is rest they come to it at once;
/// where the term bears as much in the end, they slide. So they do where it bears hardly less because the contact moves on
/// along a round face; on rows that stay the same, soft parts take their time. What slides towards something is taken there.
/// state: where to begin, and how it ends; no multipliers: no state was found.
Creep creep(const ShiftedQp& shifted, const MatrixXd& stiffness, ContactState& state, ContactQpResult& result) {
    const ContactQp& qp = shifted.qp;
    Proximal term = term_of(stiffness, creep_fraction);
    term.anchor = state.amplitudes;
    double borne = 0;
    int steady = 0;
    for (int pass = 0; pass < creep_passes; ++pass) {
        const std::vector<char> pressed_before = pressed_in(result.active);
        if (!solve_pass(shifted, term, state, result)) {
            state.multipliers.resize(0);
            return {};
        }
        if (std::optional<ContactState> exact = without_term(shifted, state, result.active);
            exact && next_states(shifted, result.active, *exact) == result.active && is_in_balance(qp, exact->multipliers)) {
            state = std::move(*exact);
            return {true, {}};
        }
        const VectorXd motion = state.amplitudes - term.anchor;
        const double borne_before = borne;
        borne = imbalance_of(qp, state.multipliers).norm();
        if (borne <= creep_load * force_scale(qp, state.multipliers)) return {true, {}};
        const bool is_slow = pass > 0 && borne > creep_is_slow * borne_before;
        const bool goes_on = is_slow && (borne >= creep_lasts * borne_before || pressed_before != pressed_in(result.active));
        const double way = goes_on ? way_to_stop(shifted, motion, state, result.active) : 0;
        steady = goes_on && way <= 1 ? steady + 1 : 0;
        if (steady >= steady_passes) return sliding_in(qp, state, motion);
        if (pass > 0 && borne > creep_halves * borne_before && !goes_on) term.stiffness *= 0.1;
        term.anchor = state.amplitudes + (way > 1 ? way - 1 : 0) * motion;
    }
    return {};
}

ContactQp with_friction_times(ContactQp qp, double factor) {
    for (FrictionRow& f : qp.friction) f.coefficient *= factor;
    return qp;
}

/// By which factor coefficients would have to be larger to hold bodies that slide from a state on; 0: not found. Their
/// pressures change with the coefficients: what friction lacks in each motion is added, until the bodies rest.
double factor_that_stops(const ShiftedQp& shifted, const MatrixXd& stiffness, const ContactState& from, const ActiveSet& states,
                         const Sliding& first) {
    double slides_at = 1, held_at = 0, factor = first.factor;
    bool held_before = false;
    for (int k = 0; k < factors_tried && factor <= largest_factor; ++k) {
        const ContactQp qp = with_friction_times(shifted.qp, factor);
        ContactQpResult tried;
        tried.active = states;
        ContactState state = from;
        const auto [rests, sliding] = creep({qp, shifted.gap}, stiffness, state, tried);
        if (!rests && !sliding && held_at == 0) break;
        if (sliding && sliding->factor < 1 + factor_accuracy) return factor * sliding->factor;
        (rests ? held_at : slides_at) = factor;  // what is not known does not hold
        if (held_at > 0 && held_at <= (1 + 1.01 * sliding_accuracy) * slides_at) break;
        factor = sliding ? factor * sliding->factor : factor / (1 + sliding_accuracy);
        // what lacks while bodies slide may be more than what lacks for their rest
        if (held_at > 0 && (factor <= slides_at || factor >= held_at || (rests && held_before)))
            factor = std::sqrt(slides_at * held_at);
        held_before = rests;
    }
    return held_at;
}

/// Forces within the cones of friction, all coefficients times a factor, that balance the loads as far as they can: by the
/// cones' edges.
NonnegativeResult balance_in_cones(const ContactQp& qp, double factor) {
    std::vector<VectorXd> edges;
    std::vector<char> bounded, is_friction(qp.unilateral.size(), 0);
    const auto append = [&](const VectorXd& edge, char bound) {
        edges.push_back(edge);
        bounded.push_back(bound);
    };
    for (const FrictionRow& f : qp.friction) {
        const VectorXd n = qp.modes.row(f.normal).transpose(), t = qp.modes.row(f.tangential).transpose();
        is_friction[static_cast<std::size_t>(f.normal)] = is_friction[static_cast<std::size_t>(f.tangential)] = 1;
        append(n + factor * f.coefficient * t, 1);
        append(n - factor * f.coefficient * t, 1);
    }
    for (std::size_t k = 0; k < is_friction.size(); ++k)
        if (!is_friction[k]) append(qp.modes.row(static_cast<Index>(k)).transpose(), qp.unilateral[k]);
    MatrixXd a(qp.modes.cols(), static_cast<Index>(edges.size()));
    for (std::size_t k = 0; k < edges.size(); ++k) a.col(static_cast<Index>(k)) = edges[k];
    return nonnegative_least_squares(a, -qp.mode_load, bounded);
}

bool can_balance(const ContactQp& qp, const NonnegativeResult& balance) {
    return balance.residual.norm() <= cone_tolerance * qp.load_scale;
}

/// The residual is a motion that lifts off as it slides, at right angles to the cones' edges. What slides does not lift:
/// without the share that opens pressed rows or moves what is held.
VectorXd sliding_motion(const ContactQp& qp, const NonnegativeResult& balance) {
    constexpr double notable = 1e-3;
    const VectorXd motion = -balance.residual;
    std::vector<Index> pressed;
    std::vector<char> has_friction(qp.unilateral.size(), 0);
    auto n_edges = static_cast<Index>(2 * qp.friction.size());
    for (std::size_t k = 0; k < qp.friction.size(); ++k) {
        has_friction[static_cast<std::size_t>(qp.friction[k].normal)] =
            has_friction[static_cast<std::size_t>(qp.friction[k].tangential)] = 1;
        if (balance.x[static_cast<Index>(2 * k)] != 0 || balance.x[static_cast<Index>(2 * k + 1)] != 0)
            pressed.push_back(qp.friction[k].normal);
    }
    for (std::size_t k = 0; k < has_friction.size(); ++k)
        if (!has_friction[k] && (balance.x[n_edges++] != 0 || !qp.unilateral[k])) pressed.push_back(static_cast<Index>(k));
    if (pressed.empty()) return motion;
    const MatrixXd rows = qp.modes(pressed, Eigen::all);
    const VectorXd sliding = motion - least_squares(rows, rows * motion);
    return sliding.norm() > notable * motion.norm() && sliding.dot(qp.mode_load) > 0 ? sliding : motion;
}

/// By which factor coefficients would have to be larger to hold; 0: none does.
double least_holding_factor(const ContactQp& qp) {
    double low = 1, high = largest_factor;
    if (!can_balance(qp, balance_in_cones(qp, high))) return 0;
    while (high > (1 + factor_accuracy) * low) {
        const double middle = std::sqrt(low * high);
        (can_balance(qp, balance_in_cones(qp, middle)) ? high : low) = middle;
    }
    return high;
}

/// Is there a motion that no forces within the cones of friction can hold?
bool finds_motion(const ContactQp& qp, ContactQpResult& result) {
    if (qp.modes.cols() == 0) return false;
    const NonnegativeResult balance = balance_in_cones(qp, 1);
    if (can_balance(qp, balance)) return false;
    result.feasible = false;
    result.mechanism = sliding_motion(qp, balance);
    if (qp.asks_holding_factor) result.holding_factor = least_holding_factor(qp);
    return true;
}

/// The rows but for those of slip: of pressure, and bilateral ones.
std::vector<Index> normal_rows(const ContactQp& qp) {
    std::vector<char> is_tangential(qp.unilateral.size(), 0);
    for (const FrictionRow& f : qp.friction) is_tangential[static_cast<std::size_t>(f.tangential)] = 1;
    std::vector<Index> rows;
    for (std::size_t k = 0; k < is_tangential.size(); ++k)
        if (!is_tangential[k]) rows.push_back(static_cast<Index>(k));
    return rows;
}

/// How far bodies are led.
double led_by(const ContactQp& qp) {
    double way = 0;
    for (const Index k : normal_rows(qp))
        if (!qp.unilateral[static_cast<std::size_t>(k)]) way = std::max(way, std::abs(qp.gap[k]));
    return way;
}

/// Slips beyond are none of bodies that only give way.
double elastic_slip(const ContactState& state) {
    return far_slip * state.closing.cwiseAbs().maxCoeff();
}

/// Has a search left bodies much farther from where it began than they give way, or are led? Where several answers are
/// possible, or what is linear holds what has slid along a round face, that is none of bodies that come to rest on their way.
bool has_gone_far(const ShiftedQp& shifted, const ContactState& state, const ActiveSet& states) {
    const VectorXd way = shifted.qp.modes * state.amplitudes;
    double slip = 0;
    for (const FrictionRow& f : shifted.qp.friction)
        if (states[static_cast<std::size_t>(f.normal)] != row_state::open) slip = std::max(slip, std::abs(way[f.tangential]));
    return slip > std::max(elastic_slip(state), led_by(shifted.qp));
}

/// From the expected states.
bool answer_from_expected(const ContactQp& qp, ContactQpResult& result) {
    result.active = states_of(qp, qp.expected);
    const std::optional<VectorXd> settled = settle_on(qp, result.active);
    const VectorXd there = settled.value_or(VectorXd::Zero(qp.modes.cols()));
    const ShiftedQp near{qp, qp.gap + qp.modes * there};
    ContactState state;
    result.converged = search_exactly(near, state, result);
    if (!result.converged) {
        state = {qp.expected, VectorXd::Zero(qp.modes.cols()), qp.compliance * qp.expected};
        result.converged =
            pivot_to_answer(near, foundation_stiffness(qp), state, result) && !has_gone_far(near, state, result.active);
    }
    if (result.converged) write_answer(near, there, state, result);
    return result.converged;
}

/// Bodies at rest on the foundation, everything that is pressed sticking.
struct AtRest {
    explicit AtRest(const ContactQp& qp) : start(settle_rigidly(qp)), near{qp, qp.gap + qp.modes * start.amplitudes} {
        VectorXd pressures = start.multipliers;
        for (const FrictionRow& f : qp.friction) pressures[f.tangential] = 0;
        sticks = states_of(qp, pressures);
        state = {pressures, VectorXd::Zero(qp.modes.cols()), qp.compliance * pressures};
    }
    Settled start;
    ShiftedQp near;
    ContactState state;
    ActiveSet sticks;
};

ContactQpResult solve_from_anywhere(const ContactQp& qp) {
    ContactQpResult result;
    result.multipliers = result.settled = result.motion = result.gap = VectorXd(0);
    const bool is_pressed = qp.expected.size() > 0 && !qp.expected.isZero(0);
    if (is_pressed && answer_from_expected(qp, result)) return result;
    const AtRest at_rest(qp);
    const Settled& start = at_rest.start;
    const ShiftedQp& near = at_rest.near;
    ContactState state;
    const auto begin_at_rest = [&] {
        state = at_rest.state;
        result.active = at_rest.sticks;
    };
    const auto pivots_find_it = [&] {
        begin_at_rest();
        return pivot_to_answer(near, start.stiffness, state, result);
    };
    begin_at_rest();
    result.converged = search_exactly(near, state, result);
    if (!result.converged && qp.modes.cols() > 0) {
        if (finds_motion(qp, result)) return result;
        begin_at_rest();
        if (const std::optional<Sliding> sliding = creep(near, start.stiffness, state, result).sliding) {
            // what is led far is tilted by where it sticks as it begins, and creeps back for long: that is no motion of its own
            const ContactState slid = state;
            const ActiveSet slides = result.active;
            result.converged = led_by(qp) > elastic_slip(slid) && pivots_find_it() && !has_gone_far(near, state, result.active);
            if (result.converged) {
                write_answer(near, start.amplitudes, state, result);
                return result;
            }
            state = slid;
            result.active = slides;
            result.mechanism = sliding->motion;
            if (qp.asks_holding_factor)
                result.holding_factor = factor_that_stops(near, start.stiffness, state, result.active, *sliding);
            write_answer(near, start.amplitudes, state, result);
            return result;
        }
        result.converged = state.multipliers.size() > 0 && search_exactly(near, state, result);
    }
    if (!result.converged) result.converged = pivots_find_it();
    if (!result.converged) state = {start.multipliers, VectorXd::Zero(qp.modes.cols()), qp.compliance * start.multipliers};
    write_answer(near, start.amplitudes, state, result);
    return result;
}

bool has_answer(const ContactQpResult& result) {
    return result.converged && result.mechanism.size() == 0;
}

ContactQp with_friction_up_to(ContactQp qp, double most) {
    for (FrictionRow& f : qp.friction) f.coefficient = std::min(f.coefficient, most);
    return qp;
}

/// The work done against slip by less friction than rows have, or that of rough faces, of the elastic energy; 0: a trifle.
double share_of_slip(const ContactQp& qp, const ContactQpResult& r) {
    double work = 0;
    for (const FrictionRow& f : qp.friction)
        if (f.coefficient > r.most_friction || f.coefficient >= rough_coefficient)
            work += std::abs(r.multipliers[f.tangential] * r.gap[f.tangential]);
    const double energy = 0.5 * r.multipliers.dot(qp.compliance * r.multipliers);
    return work > trifle_of_slip * energy && energy > 0 ? work / energy : 0;
}

/// Steep friction from that of a smaller coefficient, with which it shares most states. Where that lets next to nothing slip it
/// is the answer: pressures of next to nothing would bear tractions else, slip and all. So it is where none is found from
/// there. Nothing: it does not hold what the loads move.
std::optional<ContactQpResult> solve_from_less(const ContactQp& qp, double most_friction) {
    ContactQp moderate = with_friction_up_to(qp, most_friction);
    moderate.asks_holding_factor = false;
    ContactQpResult near = solve_from_anywhere(moderate);
    if (!has_answer(near)) return std::nullopt;
    near.most_friction = most_friction;
    near.slip_of_steep = share_of_slip(qp, near);
    if (near.slip_of_steep == 0) return near;
    const ShiftedQp settled{qp, qp.gap + qp.modes * near.settled};
    ContactState state{near.multipliers, near.motion, qp.compliance * near.multipliers};
    ContactQpResult result;
    result.active = states_of(qp, near.multipliers);
    result.converged = search_exactly(settled, state, result);
    result.iterations += near.iterations;
    near.iterations = result.iterations;
    if (!result.converged) return near;
    write_answer(settled, near.settled, state, result);
    result.slip_of_steep = share_of_slip(qp, result);
    return result.slip_of_steep < near.slip_of_steep ? result : near;
}

}  // namespace

ContactQpResult solve_with_friction(const ContactQp& qp) {
    double steepest = 0;
    for (const FrictionRow& f : qp.friction) steepest = std::max(steepest, f.coefficient);
    std::optional<ContactQpResult> best;
    for (double most = moderate_coefficient; most < steepest; most *= 10) {
        std::optional<ContactQpResult> result = solve_from_less(qp, most);
        if (result && (!best || result->slip_of_steep < best->slip_of_steep)) best = std::move(result);
        if (best && best->slip_of_steep == 0) break;
    }
    return best ? std::move(*best) : solve_from_anywhere(qp);
}

ContactQpResult solve_held_with_friction(const ContactQp& qp) {
    ContactQpResult result;
    const AtRest at_rest(qp);
    ContactState state = at_rest.state;
    result.active = at_rest.sticks;
    result.converged = search_exactly(at_rest.near, state, result);
    if (!result.converged) {
        state = at_rest.state;
        result.active = at_rest.sticks;
        result.converged = pivot_states(at_rest.near, no_term(qp.modes.cols()), result.active, state, result.iterations) &&
                           meets_conditions(at_rest.near, state);
    }
    write_answer(at_rest.near, at_rest.start.amplitudes, state, result);
    return result;
}

/// The other end to begin at: all that is pressed slips, the way that the bodies moved as they settled.
bool has_another_answer(const ContactQp& qp, const ContactQpResult& result) {
    const auto is_large = [](const FrictionRow& f) {
        return f.coefficient >= large_coefficient && f.coefficient < rough_coefficient;
    };
    if (std::none_of(qp.friction.begin(), qp.friction.end(), is_large)) return false;
    const ShiftedQp near{qp, qp.gap + qp.modes * result.settled};
    ContactQpResult other;
    other.active = result.active;
    for (const FrictionRow& f : qp.friction) {
        char& state = other.active[static_cast<std::size_t>(f.tangential)];
        if (state != row_state::open) state = near.gap[f.tangential] < 0 ? row_state::slips_backward : row_state::slips_forward;
    }
    ContactState state;
    if (!search_exactly(near, state, other)) return false;
    const double largest = result.multipliers.cwiseAbs().maxCoeff();
    return (state.multipliers - result.multipliers).cwiseAbs().maxCoeff() > differs * largest;
}

double friction_residual(const ContactQp& qp, const ContactConditions& c) {
    const ResidualScales scales = residual_scales(qp, c, qp.compliance * c.multipliers);
    double worst = c.imbalance.size() > 0 ? over_scale(c.imbalance.cwiseAbs().maxCoeff(), scales.force) : 0;
    for (const Index k : normal_rows(qp)) worst = std::max(worst, row_residual(qp, c, scales, k));
    for (const FrictionRow& f : qp.friction) {
        const double pressure = std::max(0.0, over_scale(c.multipliers[f.normal], scales.multiplier));
        const double bound = f.coefficient * pressure, t = over_scale(c.multipliers[f.tangential], scales.multiplier);
        const double slip = over_scale(c.gap[f.tangential], scales.length);
        const double left = pressure == 0 ? 0 : slip > 0 ? t + bound : bound - t;  // of the way to the slip's own bound
        worst = std::max({worst, std::abs(t) - bound, std::min(std::abs(slip), left)});
    }
    return worst;
}

bool state_with_friction(const ContactQp& qp, const ActiveSet& states, ContactState& state) {
    return solve_states({qp, qp.gap}, no_term(qp.modes.cols()), states, state);
}

}  // namespace abut::solver
