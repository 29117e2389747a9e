// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/active_set.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <set>

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int max_primal_dual_steps = 24;    // with the few steps of what follows, thirty in all
constexpr double singular_fraction = 1e-15;  // of the largest pivot: the closed rows leave a motion free
constexpr double free_fraction = 1e-10;      // of the largest stiffness against a motion: below, it counts as free
constexpr double closed_fraction = 1e-8;     // of the largest elastic closing: gaps of redundant rows, by rounding
constexpr double term_rounding = 1e-14;      // of the terms of a gap

std::vector<Index> members(const ActiveSet& set) {
    std::vector<Index> list;
    for (std::size_t k = 0; k < set.size(); ++k)
        if (set[k]) list.push_back(static_cast<Index>(k));
    return list;
}

bool is_unilateral(const ContactQp& qp, Index row) {
    return qp.unilateral[static_cast<std::size_t>(row)] != 0;
}

/// The closed rows condensed to the amplitudes, measured from an anchor; L is the factor of C there.
struct Condensed {
    MatrixXd stiffness;  // G'C^-1 G
    VectorXd load;       // h - G'C^-1 g
    MatrixXd w;          // L^-1 G
    VectorXd z;          // L^-1 g
};

/// False where C is indefinite on the set.
bool condense(const ContactQp& qp, const VectorXd& anchor, const ActiveSet& active, ClosedFactor& factor, Condensed& c) {
    if (!factor.move_to(active)) return false;
    const std::vector<Index>& closed = factor.rows();
    const Index n = qp.modes.cols();
    MatrixXd columns(static_cast<Index>(closed.size()), n + 1);
    columns.leftCols(n) = qp.modes(closed, Eigen::all);
    columns.col(n) = qp.gap(closed) + columns.leftCols(n) * anchor;
    factor.solve_lower(columns);
    c.w = columns.leftCols(n);
    c.z = columns.col(n);
    c.stiffness = c.w.transpose() * c.w;
    c.load = qp.mode_load - c.w.transpose() * c.z;
    return true;
}

VectorXd multipliers_of(const ContactQp& qp, const Condensed& c, const ClosedFactor& factor, const VectorXd& motion) {
    MatrixXd forces = -c.z - c.w * motion;
    factor.solve_transposed(forces);
    VectorXd l = VectorXd::Zero(qp.gap.size());
    l(factor.rows()) = forces.col(0);
    return l;
}

/// Rows that are closed with the others: the gaps there, too, must not ask for more.
bool closes_what_is_left_out(const ContactQp& qp, const ClosedFactor& factor, const ContactState& state) {
    if (factor.left_out().empty()) return true;
    const double length = VectorXd(qp.compliance * state.multipliers).cwiseAbs().maxCoeff();
    return gap_of(qp, state)(factor.left_out()).cwiseAbs().maxCoeff() <= closed_fraction * length;
}

/// What `descend` lowers: 1/2 l'Cl + g'l + anchor'(G'l + h) + 1/2 (G'l + h)' E^-1 (G'l + h).
class ProximalEnergy {
public:
    ProximalEnergy(const ContactQp& qp, const Proximal& proximal) : qp_(qp), proximal_(proximal), factor_(proximal.stiffness) {}
    double operator()(const VectorXd& l) const {
        const VectorXd load = qp_.modes.transpose() * l + qp_.mode_load;
        const double held = load.size() > 0 ? load.dot(proximal_.anchor + 0.5 * VectorXd(factor_.solve(load))) : 0.0;
        return l.dot(0.5 * (qp_.compliance * l) + qp_.gap) + held;
    }

private:
    const ContactQp& qp_;
    const Proximal& proximal_;
    Eigen::LLT<MatrixXd> factor_;
};

/// Where the way from l to target first makes a unilateral multiplier negative.
struct Block {
    double reach = 1;
    Index row = -1;
};
Block first_block(const ContactQp& qp, const ActiveSet& active, const VectorXd& l, const VectorXd& target) {
    Block block;
    for (Index k : members(active)) {
        if (!is_unilateral(qp, k) || target[k] >= 0) continue;
        const double reach = l[k] / (l[k] - target[k]);
        if (reach < block.reach || block.row < 0) block = {std::min(reach, 1.0), k};
    }
    return block;
}

/// l >= 0 as far as required; rows that are zero leave the set.
void project(const ContactQp& qp, VectorXd& l, ActiveSet& active) {
    for (std::size_t k = 0; k < active.size(); ++k) {
        if (!qp.unilateral[k]) continue;
        double& value = l[static_cast<Index>(k)];
        value = std::max(0.0, value);
        active[k] = value > 0;
    }
}

/// Open rows that penetrate join the set: all of them, or the deepest. False: there are none.
bool close_penetrated(const ContactQp& qp, const ContactState& state, bool all, ActiveSet& active) {
    const VectorXd gap = gap_of(qp, state);
    const VectorXd rounding = gap_rounding(qp, state);
    Index deepest = -1;
    for (Index k = 0; k < gap.size(); ++k) {
        if (active[static_cast<std::size_t>(k)] || gap[k] >= -rounding[k]) continue;
        if (deepest < 0 || gap[k] < gap[deepest]) deepest = k;
        if (all) active[static_cast<std::size_t>(k)] = 1;
    }
    if (deepest < 0) return false;
    active[static_cast<std::size_t>(deepest)] = 1;
    return true;
}

}  // namespace

ActiveSet bilateral_rows(const ContactQp& qp) {
    ActiveSet set(qp.unilateral.size());
    std::transform(qp.unilateral.begin(), qp.unilateral.end(), set.begin(), [](char u) { return static_cast<char>(!u); });
    return set;
}

bool solve_on(const ContactQp& qp, const Proximal& proximal, const ActiveSet& active, ClosedFactor& factor,
              ContactState& state) {
    Condensed c;
    if (!condense(qp, proximal.anchor, active, factor, c)) return false;
    const Index n = qp.modes.cols();
    VectorXd motion = VectorXd::Zero(n);
    if (n > 0) {
        const Eigen::LDLT<MatrixXd> held(c.stiffness + proximal.stiffness);
        const VectorXd d = held.vectorD().cwiseAbs();
        if (held.info() != Eigen::Success || d.minCoeff() <= singular_fraction * d.maxCoeff()) return false;
        motion = held.solve(c.load);
    }
    state = {multipliers_of(qp, c, factor, motion), proximal.anchor + motion};
    return closes_what_is_left_out(qp, factor, state);
}

bool solve_least_motion(const ContactQp& qp, const VectorXd& anchor, const ActiveSet& active, ClosedFactor& factor,
                        ContactState& state) {
    Condensed c;
    const Index n = qp.modes.cols();
    if (n == 0 || !condense(qp, anchor, active, factor, c)) return false;
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(c.stiffness);
    const VectorXd& stiffness = eigen.eigenvalues();
    if (!(stiffness[n - 1] > 0)) return false;
    VectorXd motion = eigen.eigenvectors().transpose() * c.load;
    for (Index k = 0; k < n; ++k) motion[k] = stiffness[k] > free_fraction * stiffness[n - 1] ? motion[k] / stiffness[k] : 0.0;
    motion = eigen.eigenvectors() * motion;
    state = {multipliers_of(qp, c, factor, motion), anchor + motion};
    return closes_what_is_left_out(qp, factor, state);
}

VectorXd gap_of(const ContactQp& qp, const ContactState& s) {
    return qp.gap + qp.compliance * s.multipliers + qp.modes * s.amplitudes;
}

VectorXd gap_rounding(const ContactQp& qp, const ContactState& s) {
    VectorXd terms = qp.gap.cwiseAbs();
    if (terms.size() == 0) return terms;
    terms.array() += qp.compliance.diagonal().cwiseAbs().maxCoeff() * s.multipliers.cwiseAbs().sum();
    if (qp.modes.cols() > 0) terms += qp.modes.cwiseAbs() * s.amplitudes.cwiseAbs();
    return term_rounding * terms;
}

ActiveSet next_set(const ContactQp& qp, const ActiveSet& active, const ContactState& s) {
    const VectorXd gap = gap_of(qp, s);
    const VectorXd rounding = gap_rounding(qp, s);
    ActiveSet next(active.size());
    for (std::size_t k = 0; k < active.size(); ++k) {
        const auto i = static_cast<Index>(k);
        next[k] = !qp.unilateral[k] || (active[k] ? s.multipliers[i] > 0 : gap[i] < -rounding[i]);
    }
    return next;
}

SetSearch primal_dual(const ContactQp& qp, const Proximal& proximal, ActiveSet& active, ClosedFactor& factor,
                      ContactState& state, int& iterations) {
    std::set<ActiveSet> seen;
    for (int step = 0; step < max_primal_dual_steps; ++step) {
        if (!seen.insert(active).second) return SetSearch::repeated;
        ++iterations;
        if (!solve_on(qp, proximal, active, factor, state)) return SetSearch::singular;
        ActiveSet next = next_set(qp, active, state);
        if (next == active) return SetSearch::found;
        active = std::move(next);
    }
    return SetSearch::repeated;
}

bool descend(const ContactQp& qp, const Proximal& proximal, ActiveSet& active, ClosedFactor& factor, ContactState& state,
             int& iterations) {
    const ProximalEnergy energy(qp, proximal);
    VectorXd l = state.multipliers;
    project(qp, l, active);
    double lowest = energy(l);
    bool fell = true;  // since rows were added last
    const int limit = 50 + 10 * static_cast<int>(l.size());
    for (int step = 0; step < limit; ++step) {
        ++iterations;
        if (!solve_on(qp, proximal, active, factor, state)) return false;
        const Block block = first_block(qp, active, l, state.multipliers);
        VectorXd trial = state.multipliers;
        ActiveSet trial_set = active;
        if (block.row >= 0) project(qp, trial, trial_set);
        const double value = energy(trial);
        if (block.row < 0 || value < lowest) {
            fell = fell || value < lowest;
            l = std::move(trial);
            active = std::move(trial_set);
            lowest = std::min(value, lowest);
            if (block.row >= 0) continue;
            // several rows at once where the last ones lowered the energy; one by one there is always a descent
            if (!close_penetrated(qp, state, fell, active)) return true;
            fell = false;
            continue;
        }
        l += block.reach * (state.multipliers - l);
        l[block.row] = 0;
        active[static_cast<std::size_t>(block.row)] = 0;
        fell = fell || block.reach > 0;
        lowest = std::min(lowest, energy(l));
    }
    return false;
}

}  // namespace abut::solver
