// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/friction_states.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solver/contact/friction_system.hpp"
#include "solver/contact/kept_states.hpp"
#include "solver/linear_algebra/dense.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int most_newton_steps = 60;  // 33 are the most that 5300 rows were seen to take
constexpr int most_steps_astray = 10;  // nearer to no solution: beyond, one in two hundred finds back
constexpr double least_step = 1.0 / 64;
constexpr double consistent = 1e-10;  // of the terms: what a singular system leaves is rounding
constexpr double at_bound = 1e-12;    // of the largest multiplier: a traction so near to its bound is there
constexpr double dependent = 1e-8;    // of the longest row of motions: less is rounding of what others hold

std::optional<VectorXd> solved(const MatrixXd& a, const VectorXd& b) {
    if (std::optional<VectorXd> x = solve_square(a, b); x && x->allFinite()) return x;
    VectorXd x = least_squares(a, b);
    const double terms = (a.cwiseAbs() * x.cwiseAbs() + b.cwiseAbs()).maxCoeff();
    const bool is_consistent = (a * x - b).cwiseAbs().maxCoeff() <= consistent * terms;  // false of what is no number, too
    return is_consistent ? std::optional(x) : std::nullopt;
}

}  // namespace

ActiveSet states_of(const ContactQp& qp, const VectorXd& multipliers) {
    ActiveSet states = bilateral_rows(qp);
    for (std::size_t k = 0; k < states.size(); ++k)
        if (multipliers[static_cast<Index>(k)] > 0) states[k] = row_state::closed;
    const double rounding = at_bound * (multipliers.size() > 0 ? multipliers.cwiseAbs().maxCoeff() : 0.0);
    for (const FrictionRow& f : qp.friction) {
        char& state = states[index_of(f.tangential)];
        const double traction = multipliers[f.tangential], bound = f.coefficient * multipliers[f.normal];
        state = states[index_of(f.normal)];
        if (state == row_state::closed && std::abs(traction) >= bound - rounding)
            state = traction < 0 ? row_state::slips_forward : row_state::slips_backward;
    }
    return states;
}

HeldMotions::HeldMotions(const ContactQp& qp)
    : modes_(qp.modes),
      basis_(MatrixXd::Zero(qp.modes.cols(), qp.modes.cols())),
      rounding_(qp.modes.size() > 0 ? dependent * qp.modes.rowwise().norm().maxCoeff() : 0) {}

bool HeldMotions::hold(Index row) {
    if (are_all()) return false;
    const VectorXd motion = free_part(modes_.row(row).transpose());
    if (!(motion.norm() > rounding_)) return false;
    basis_.col(n_++) = motion.normalized();
    return true;
}

VectorXd HeldMotions::free_part(const VectorXd& motion) const {
    const auto held = basis_.leftCols(n_);
    const VectorXd once = motion - held * (held.transpose() * motion);
    return once - held * (held.transpose() * once);  // what rounding left
}

HeldMotions held_motions(const ContactQp& qp, const ActiveSet& states) {
    HeldMotions held(qp);
    for (std::size_t k = 0; k < states.size() && !held.are_all(); ++k)
        if (states[k] == row_state::closed) held.hold(static_cast<Index>(k));
    return held;
}

namespace {

/// Do the loads, with these forces of the rows, act on motions that are not held, by more than rounding?
bool acts_on_free(const ContactQp& qp, const HeldMotions& held, const VectorXd& forces) {
    if (held.are_all()) return false;
    const VectorXd of_rows = qp.modes.transpose() * forces;
    const double terms = (qp.mode_load.cwiseAbs() + qp.modes.cwiseAbs().transpose() * forces.cwiseAbs()).maxCoeff();
    return held.free_part(qp.mode_load + of_rows).cwiseAbs().maxCoeff() > consistent * terms;
}

}  // namespace

bool solve_states(const ShiftedQp& shifted, const Proximal& proximal, const ActiveSet& states, ContactState& state) {
    const ContactQp& qp = shifted.qp;
    const bool is_exact = proximal.stiffness.isZero(0);
    if (is_exact && qp.kept && qp.kept->solve(shifted, states, state)) return true;
    const Unknowns u = unknowns_of(qp, states);
    const double unit = force_unit(qp);
    const std::optional<HeldMotions> held = is_exact ? std::optional(held_motions(qp, states)) : std::nullopt;
    const MatrixXd modes = held ? MatrixXd(qp.modes * held->basis()) : qp.modes;
    const Index m = static_cast<Index>(u.rows.size()), n = modes.cols();
    const VectorXd load = qp.mode_load + proximal.stiffness * proximal.anchor;
    VectorXd right(m + n);
    right.head(m) = -shifted.gap(u.rows);
    right.tail(n) = -(held ? VectorXd(held->basis().transpose() * load) : load) / unit;
    const MatrixXd stiffness = is_exact ? MatrixXd::Zero(n, n) : proximal.stiffness;
    const std::optional<VectorXd> x = solved(matrix_of(qp, modes, stiffness, u, unit), right);
    if (!x) return false;
    state.multipliers = VectorXd::Zero(shifted.gap.size());
    state.multipliers(u.rows) = unit * x->head(m);
    for (const Unknowns::Slip& s : u.slips) state.multipliers[s.tangential] = s.factor * unit * (*x)[s.column];
    state.amplitudes = held ? VectorXd(held->basis() * x->tail(n)) : VectorXd(x->tail(n));
    if (held && acts_on_free(qp, *held, state.multipliers)) return false;
    state.closing = qp.compliance * state.multipliers;
    return true;
}

ActiveSet next_states(const ShiftedQp& shifted, const ActiveSet& states, const ContactState& s) {
    ActiveSet next = next_set(shifted, states, s);
    const VectorXd gap = gap_of(shifted, s), rounding = gap_rounding(shifted, s);
    const double trifle = at_bound * s.multipliers.cwiseAbs().maxCoeff();
    for (const FrictionRow& f : shifted.qp.friction) {
        const char before = states[index_of(f.tangential)];
        char& state = next[index_of(f.tangential)];
        const double traction = s.multipliers[f.tangential], bound = f.coefficient * s.multipliers[f.normal];
        state = next[index_of(f.normal)];
        if (state == row_state::open) continue;
        if (before == row_state::closed && std::abs(traction) > bound + trifle)
            state = traction < 0 ? row_state::slips_forward : row_state::slips_backward;
        else if (const double way = direction_of(before); way != 0 && way * gap[f.tangential] >= -rounding[f.tangential])
            state = before;
    }
    return next;
}

namespace {

/// What the multipliers of a point lack of what its gaps ask for: of each row its own compliance tells which force closes a
/// gap. Natural residuals; zero at a solution alone.
class Lack {
public:
    explicit Lack(const ShiftedQp& shifted) : qp_(shifted.qp), compliance_(shifted.qp.compliance.diagonal()) {
        const double least = std::numeric_limits<double>::epsilon() * compliance_.maxCoeff();
        compliance_ = compliance_.cwiseMax(least);
    }

    /// The states that a point asks for; of one that a step ends at those of next_states, which knows its rounding.
    ActiveSet states(const VectorXd& multipliers, const VectorXd& gap) const {
        const VectorXd wanted = multipliers - gap.cwiseQuotient(compliance_);
        ActiveSet states = bilateral_rows(qp_);
        for (std::size_t k = 0; k < states.size(); ++k)
            if (qp_.unilateral[k] && wanted[static_cast<Index>(k)] > 0) states[k] = row_state::closed;
        for (const FrictionRow& f : qp_.friction) {
            const double traction = wanted[f.tangential], bound = f.coefficient * wanted[f.normal];
            char& state = states[index_of(f.tangential)] = states[index_of(f.normal)];
            if (state == row_state::closed && std::abs(traction) > bound)
                state = traction < 0 ? row_state::slips_forward : row_state::slips_backward;
        }
        return states;
    }

    /// Bodies that slip everywhere are free to roll or slide. Where they would be, what is least beyond its bound sticks: round
    /// bodies between others are held by a single row at its bound. True: something has been held.
    bool hold_free_motions(const VectorXd& multipliers, const VectorXd& gap, ActiveSet& states) const {
        HeldMotions held = held_motions(qp_, states);
        if (held.are_all()) return false;
        const VectorXd wanted = multipliers - gap.cwiseQuotient(compliance_);
        std::vector<std::pair<double, Index>> slipping;
        for (const FrictionRow& f : qp_.friction)
            if (direction_of(states[index_of(f.tangential)]) != 0)
                slipping.emplace_back(std::abs(wanted[f.tangential]) / (f.coefficient * wanted[f.normal]), f.tangential);
        std::sort(slipping.begin(), slipping.end());
        bool any = false;
        for (const auto& [beyond, row] : slipping) {
            if (held.are_all()) break;
            if (!held.hold(row)) continue;
            states[index_of(row)] = row_state::closed;
            any = true;
        }
        return any;
    }

    /// The sum of the residuals' squares, as energies.
    double energy(const VectorXd& multipliers, const VectorXd& gap) const {
        const VectorXd wanted = multipliers - gap.cwiseQuotient(compliance_);
        VectorXd lack = multipliers - wanted;
        for (std::size_t k = 0; k < qp_.unilateral.size(); ++k) {
            const auto row = static_cast<Index>(k);
            if (qp_.unilateral[k]) lack[row] = multipliers[row] - std::max(0.0, wanted[row]);
        }
        for (const FrictionRow& f : qp_.friction) {
            const double bound = f.coefficient * std::max(0.0, wanted[f.normal]);
            lack[f.tangential] = multipliers[f.tangential] - std::clamp(wanted[f.tangential], -bound, bound);
        }
        return lack.cwiseAbs2().dot(compliance_);
    }

private:
    const ContactQp& qp_;
    VectorXd compliance_;
};

}  // namespace

SetSearch search_states(const ShiftedQp& shifted, const Proximal& proximal, ActiveSet& states, ContactState& state,
                        int& iterations) {
    const Lack lack(shifted);
    const bool is_exact = shifted.qp.modes.cols() > 0 && proximal.stiffness.isZero(0);
    VectorXd multipliers, gap;  // of the point that a step begins from
    double energy = std::numeric_limits<double>::infinity(), least = energy;
    int steps_since_least = 0;
    for (int step = 0; step < most_newton_steps; ++step) {
        ++iterations;
        if (!solve_states(shifted, proximal, states, state)) return SetSearch::singular;
        if (next_states(shifted, states, state) == states) return SetSearch::found;
        const VectorXd gap_there = gap_of(shifted, state);
        const double whole = lack.energy(state.multipliers, gap_there);
        steps_since_least = whole < least ? 0 : steps_since_least + 1;
        if (steps_since_least > most_steps_astray) return SetSearch::repeated;
        least = std::min(least, whole);
        if (step == 0 || whole < energy) {
            multipliers = state.multipliers;
            gap = gap_there;
            energy = whole;
        } else {
            const VectorXd way = state.multipliers - multipliers, opens = gap_there - gap;
            double share = 1;
            energy = whole;
            for (double part = 0.5; part >= least_step; part *= 0.5)
                if (const double e = lack.energy(multipliers + part * way, gap + part * opens); e < energy) {
                    share = part;
                    energy = e;
                }
            multipliers += share * way;
            gap += share * opens;
        }
        const ActiveSet before = std::exchange(states, lack.states(multipliers, gap));
        if (is_exact && lack.hold_free_motions(multipliers, gap, states) && states == before) return SetSearch::singular;
    }
    return SetSearch::repeated;
}

}  // namespace abut::solver
