// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact_qp.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <set>

#include "solver/nonnegative.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Set = std::vector<char>;

constexpr int max_pdas_iterations = 30;
constexpr int max_proximal_passes = 7;
constexpr int max_anchor_returns = 20;            // of the monotone method, on one set
constexpr double first_proximal_fraction = 1e-6;  // of the Winkler stiffness; tenfold less each pass
constexpr double equilibrium_tolerance = 1e-10;   // relative to the loads
constexpr double feasibility_tolerance = 1e-8;    // relative to the loads: below, the residual is rounding, not a mechanism

struct State {
    VectorXd multipliers, amplitudes;
};

std::vector<Index> members(const Set& set) {
    std::vector<Index> list;
    for (std::size_t k = 0; k < set.size(); ++k)
        if (set[k]) list.push_back(static_cast<Index>(k));
    return list;
}

/// Stationary point with the gaps of `active` closed and all other multipliers zero; false where C is singular on the set.
bool solve_on(const ContactQp& qp, const Set& active, double proximal, const VectorXd& anchor, State& state) {
    const std::vector<Index> a = members(active);
    const Index n = qp.modes.cols();
    state.multipliers = VectorXd::Zero(qp.gap.size());
    state.amplitudes = anchor;
    const MatrixXd g = qp.modes(a, Eigen::all);
    MatrixXd schur = proximal * MatrixXd::Identity(n, n);
    VectorXd rhs = qp.mode_load + proximal * anchor;
    MatrixXd w;
    VectorXd z;
    if (!a.empty()) {
        const Eigen::LLT<MatrixXd> factor(qp.compliance(a, a));
        if (factor.info() != Eigen::Success) return false;
        w = factor.solve(g);
        z = factor.solve(qp.gap(a));
        schur += g.transpose() * w;
        rhs -= g.transpose() * z;
    }
    if (n > 0) {
        const Eigen::LDLT<MatrixXd> factor(schur);
        const VectorXd d = factor.vectorD().cwiseAbs();
        if (factor.info() != Eigen::Success || d.minCoeff() <= 1e-15 * d.maxCoeff()) return false;
        state.amplitudes = factor.solve(rhs);
    }
    if (!a.empty()) state.multipliers(a) = -z - (n > 0 ? VectorXd(w * state.amplitudes) : VectorXd::Zero(z.size()));
    return true;
}

VectorXd gap_of(const ContactQp& qp, const State& s) {
    return qp.gap + qp.compliance * s.multipliers + qp.modes * s.amplitudes;
}

/// Below this a gap is closed: rounding of the terms that it is the sum of.
double gap_rounding(const ContactQp& qp, const State& s) {
    if (qp.gap.size() == 0) return 0;
    const double terms = qp.gap.cwiseAbs().maxCoeff() +
                         (qp.compliance.diagonal().cwiseAbs().maxCoeff()) * s.multipliers.cwiseAbs().sum() +
                         (qp.modes.size() > 0 ? qp.modes.cwiseAbs().maxCoeff() * s.amplitudes.cwiseAbs().sum() : 0.0);
    return 1e-14 * terms;
}

double equilibrium_error(const ContactQp& qp, const State& s) {
    if (qp.modes.cols() == 0) return 0;
    return (qp.modes.transpose() * s.multipliers + qp.mode_load).cwiseAbs().maxCoeff();
}

/// Forces that equilibrium is measured against: the loads, or the contact forces where there are none (a press fit).
double force_scale(const ContactQp& qp, const VectorXd& multipliers) {
    if (qp.modes.size() == 0) return qp.load_scale;
    return std::max(qp.load_scale, (qp.modes.cwiseAbs().transpose() * multipliers.cwiseAbs()).maxCoeff());
}

Set bilateral_rows(const ContactQp& qp) {
    Set set(qp.unilateral.size());
    std::transform(qp.unilateral.begin(), qp.unilateral.end(), set.begin(), [](char u) { return static_cast<char>(!u); });
    return set;
}

/// Pressures of rigid bodies on a Winkler foundation: damped Newton on the rigid amplitudes.
struct Settled {
    VectorXd multipliers;
    double stiffness = 0;  // mean stiffness against the rigid motions
};

Settled settle(const ContactQp& qp) {
    const Index n = qp.modes.cols();
    VectorXd a = VectorXd::Zero(n);
    const auto pressures = [&](const VectorXd& amplitude) {
        const VectorXd gap = qp.drawn_gap + qp.modes * amplitude;
        VectorXd l = -qp.foundation.cwiseProduct(gap);
        for (Index k = 0; k < l.size(); ++k)
            if (qp.unilateral[static_cast<std::size_t>(k)]) l[k] = std::max(0.0, l[k]);
        return l;
    };
    const auto energy = [&](const VectorXd& amplitude) {
        const VectorXd l = pressures(amplitude);
        return 0.5 * l.cwiseProduct(l).cwiseQuotient(qp.foundation).sum() - qp.mode_load.dot(amplitude);
    };
    const MatrixXd all = qp.modes.transpose() * qp.foundation.asDiagonal() * qp.modes;
    const double mean = n > 0 ? all.trace() / static_cast<double>(n) : 0.0;
    for (int step = 0; step < 100 && n > 0; ++step) {
        const VectorXd l = pressures(a);
        const VectorXd residual = qp.modes.transpose() * l + qp.mode_load;
        if (residual.norm() <= 1e-12 * force_scale(qp, l)) break;
        MatrixXd hessian = 1e-9 * mean * MatrixXd::Identity(n, n);
        for (Index k = 0; k < l.size(); ++k)
            if (l[k] != 0) hessian += qp.foundation[k] * qp.modes.row(k).transpose() * qp.modes.row(k);
        const VectorXd direction = hessian.ldlt().solve(residual);
        const double before = energy(a);
        double reach = 1;
        while (reach > 1e-12 && energy(a + reach * direction) > before - 1e-4 * reach * residual.dot(direction)) reach *= 0.5;
        if (reach <= 1e-12) break;
        a += reach * direction;
    }
    return {pressures(a), mean};
}

/// Active set from the primal-dual step: closed where pressed, closing where penetrated.
Set next_set(const ContactQp& qp, const Set& active, const State& s, const VectorXd& gap, double rounding) {
    Set next(active.size());
    for (std::size_t k = 0; k < active.size(); ++k) {
        const auto i = static_cast<Index>(k);
        next[k] = !qp.unilateral[k] || (active[k] ? s.multipliers[i] > 0 : gap[i] < -rounding);
    }
    return next;
}

/// One run of the primal-dual active set; false on a repeated or lost set.
bool primal_dual(const ContactQp& qp, double proximal, const VectorXd& anchor, Set& active, State& state, int& iterations) {
    std::set<Set> seen;
    for (int step = 0; step < max_pdas_iterations; ++step) {
        ++iterations;
        if (!seen.insert(active).second || !solve_on(qp, active, proximal, anchor, state)) return false;
        const Set next = next_set(qp, active, state, gap_of(qp, state), gap_rounding(qp, state));
        if (next == active) return true;
        active = next;
    }
    return false;
}

bool proximal_passes(const ContactQp& qp, double stiffness, Set& active, State& state, int& iterations) {
    VectorXd anchor = VectorXd::Zero(qp.modes.cols());
    if (qp.modes.cols() == 0) return primal_dual(qp, 0, anchor, active, state, iterations);
    double proximal = first_proximal_fraction * stiffness;
    for (int pass = 0; pass < max_proximal_passes; ++pass, proximal *= 0.1) {
        if (!primal_dual(qp, proximal, anchor, active, state, iterations)) return false;
        if (equilibrium_error(qp, state) <= equilibrium_tolerance * force_scale(qp, state.multipliers)) break;
        anchor = state.amplitudes;
    }
    // the exact problem on the set found, where that set holds every motion
    State exact;
    if (solve_on(qp, active, 0, anchor, exact)) {
        const VectorXd gap = gap_of(qp, exact);
        if (next_set(qp, active, exact, gap, gap_rounding(qp, exact)) == active) state = exact;
    }
    return equilibrium_error(qp, state) <= equilibrium_tolerance * force_scale(qp, state.multipliers);
}

/// The monotone primal active set (Nocedal and Wright, alg. 16.3) from feasible multipliers: the energy falls with every step,
/// so no set comes back.
bool monotone(const ContactQp& qp, const VectorXd& feasible, double stiffness, Set& active, State& state, int& iterations) {
    VectorXd l = feasible;
    for (std::size_t k = 0; k < active.size(); ++k) active[k] = !qp.unilateral[k] || l[static_cast<Index>(k)] > 0;
    const double proximal = 1e-12 * stiffness;
    VectorXd anchor = VectorXd::Zero(qp.modes.cols());
    const int limit = 50 + 10 * static_cast<int>(l.size());
    int returns = 0;
    for (int step = 0; step < limit; ++step) {
        ++iterations;
        if (!solve_on(qp, active, proximal, anchor, state)) return false;
        anchor = state.amplitudes;
        double reach = 1;
        Index blocking = -1;
        for (Index k : members(active)) {
            if (!qp.unilateral[static_cast<std::size_t>(k)] || state.multipliers[k] >= 0) continue;
            const double r = l[k] / (l[k] - state.multipliers[k]);
            if (r < reach) {
                reach = r;
                blocking = k;
            }
        }
        l += reach * (state.multipliers - l);
        if (blocking >= 0) {
            l[blocking] = 0;
            active[static_cast<std::size_t>(blocking)] = 0;
            continue;
        }
        const VectorXd gap = gap_of(qp, state);
        const double rounding = gap_rounding(qp, state);
        Index worst = -1;
        for (Index k = 0; k < gap.size(); ++k)
            if (!active[static_cast<std::size_t>(k)] && gap[k] < -rounding && (worst < 0 || gap[k] < gap[worst])) worst = k;
        if (worst < 0) {
            // a set that was empty on the way leaves a far anchor: the steps that follow, on the same set, bring it back
            if (equilibrium_error(qp, state) <= feasibility_tolerance * force_scale(qp, state.multipliers)) return true;
            if (++returns > max_anchor_returns) return false;
            continue;
        }
        active[static_cast<std::size_t>(worst)] = 1;
    }
    return false;
}

}  // namespace

ContactQpResult solve_contact_qp(const ContactQp& qp) {
    ContactQpResult result;
    result.active = bilateral_rows(qp);
    if (qp.gap.size() == 0 && qp.modes.cols() == 0) {
        result.multipliers = result.amplitudes = result.gap = VectorXd(0);
        result.converged = true;
        return result;
    }
    VectorXd feasible = VectorXd::Zero(qp.gap.size());
    if (qp.modes.cols() > 0) {
        const NonnegativeResult balance = nonnegative_least_squares(qp.modes.transpose(), -qp.mode_load, qp.unilateral);
        feasible = balance.x;
        if (balance.residual.norm() > feasibility_tolerance * force_scale(qp, balance.x)) {
            result.feasible = false;
            result.mechanism = -balance.residual;
            return result;
        }
    }
    const Settled start = settle(qp);
    for (std::size_t k = 0; k < result.active.size(); ++k)
        if (start.multipliers[static_cast<Index>(k)] > 0) result.active[k] = 1;

    State state;
    result.converged = proximal_passes(qp, start.stiffness, result.active, state, result.iterations);
    if (!result.converged) {
        result.used_fallback = true;
        result.converged = monotone(qp, feasible, start.stiffness, result.active, state, result.iterations);
    }
    result.multipliers = state.multipliers;
    result.amplitudes = state.amplitudes;
    result.gap = gap_of(qp, state);
    return result;
}

bool solve_on_set(const ContactQp& qp, const std::vector<char>& active, VectorXd& multipliers, VectorXd& amplitudes) {
    State state;
    if (!solve_on(qp, active, 0, VectorXd::Zero(qp.modes.cols()), state)) return false;
    multipliers = state.multipliers;
    amplitudes = state.amplitudes;
    return true;
}

}  // namespace abut::solver
