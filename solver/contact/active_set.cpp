// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/active_set.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "solver/linear_algebra/dense.hpp"
#include "solver/linear_algebra/nonnegative.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int max_primal_dual_steps = 18;      // with those of the interior point method, thirty in all
constexpr int max_pivots = 300, patience = 4;  // in all; while no fewer rows are wrong, before rows change alone
constexpr double singular_fraction = 1e-15;    // of the largest pivot: the closed rows leave a motion free
constexpr double free_fraction = 1e-10;        // of the largest stiffness against a motion: below, it counts as free
constexpr double closed_fraction = 1e-8;       // of the largest elastic closing: gaps of redundant rows, by rounding
constexpr double clear_fraction = 1e-6;        // of the deepest penetration: what free motions leave it by, besides
constexpr double term_rounding = 1e-14;        // of the terms of a gap

bool is_unilateral(const ContactQp& qp, Index row) {
    return qp.unilateral[static_cast<std::size_t>(row)] != 0;
}

/// The closed rows condensed to the amplitudes, measured from an anchor.
struct Condensed {
    MatrixXd stiffness;  // G'C^-1 G
    VectorXd load;       // h - G'C^-1 g
};

/// False where C is indefinite on the set.
bool condense(const ShiftedQp& shifted, const VectorXd& anchor, const ActiveSet& active, ClosedFactor& factor, Condensed& c) {
    if (!factor.move_to(active)) return false;
    const Index n = shifted.qp.modes.cols();
    const MatrixXd products = factor.inverse_form(shifted.qp.modes, shifted.gap, anchor);
    c.stiffness = products.topLeftCorner(n, n);
    c.load = shifted.qp.mode_load - products.col(n).head(n);
    return true;
}

ContactState state_of(const ContactQp& qp, const ClosedFactor& factor, const VectorXd& anchor, const VectorXd& motion) {
    VectorXd l = VectorXd::Zero(qp.gap.size());
    l(factor.rows()) = -factor.solve(qp.modes, motion);
    VectorXd closing = qp.compliance * l;
    return {std::move(l), anchor + motion, std::move(closing)};
}

/// Rows that are closed with the others: the gaps there, too, must not ask for more.
bool closes_what_is_left_out(const ShiftedQp& shifted, const ClosedFactor& factor, const ContactState& state) {
    if (factor.left_out().empty()) return true;
    const double length = state.closing.cwiseAbs().maxCoeff();
    return gap_of(shifted, state)(factor.left_out()).cwiseAbs().maxCoeff() <= closed_fraction * length;
}

/// What `descend` lowers: 1/2 l'Cl + g'l + anchor'(G'l + h) + 1/2 (G'l + h)' E^-1 (G'l + h).
class ProximalEnergy {
public:
    ProximalEnergy(const ShiftedQp& shifted, const Proximal& proximal)
        : shifted_(shifted), proximal_(proximal), factor_(proximal.stiffness) {}
    double operator()(const VectorXd& l) const {
        const VectorXd load = shifted_.qp.modes.transpose() * l + shifted_.qp.mode_load;
        const double held = load.size() > 0 ? load.dot(proximal_.anchor + 0.5 * factor_.solve(load)) : 0.0;
        return l.dot(0.5 * (shifted_.qp.compliance * l) + shifted_.gap) + held;
    }

private:
    const ShiftedQp& shifted_;
    const Proximal& proximal_;
    Cholesky factor_;
};

/// Where the way from l to target first makes a unilateral multiplier negative.
struct Block {
    double share = 1;  ///< of the way
    Index row = -1;
};
Block first_block(const ContactQp& qp, const ActiveSet& active, const VectorXd& l, const VectorXd& target) {
    Block block;
    for (Index k : members(active)) {
        if (!is_unilateral(qp, k) || target[k] >= 0) continue;
        const double share = l[k] / (l[k] - target[k]);
        if (share < block.share || block.row < 0) block = {std::min(share, 1.0), k};
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
bool close_penetrated(const ShiftedQp& shifted, const ContactState& state, bool all, ActiveSet& active) {
    const VectorXd gap = gap_of(shifted, state);
    const VectorXd rounding = gap_rounding(shifted, state);
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

/// The amplitudes' own problem; false where a motion is free.
bool solve_motion(const MatrixXd& stiffness, const VectorXd& load, VectorXd& motion) {
    motion = VectorXd::Zero(load.size());
    if (load.size() == 0) return true;
    const PivotedCholesky held(stiffness);
    const VectorXd d = held.pivots().cwiseAbs();
    if (!held.succeeded() || d.minCoeff() <= singular_fraction * d.maxCoeff()) return false;
    motion = held.solve(load);
    return true;
}

/// The same where free motions stay; false where all are free. free: a basis of them (n x free motions).
bool solve_held_motion(const MatrixXd& stiffness, const VectorXd& load, VectorXd& motion, MatrixXd& free) {
    const Index n = load.size();
    if (n == 0) return false;
    const auto [values, motions] = symmetric_eigen(stiffness);
    if (!(values[n - 1] > 0)) return false;
    const Index n_free = (values.array() <= free_fraction * values[n - 1]).count();
    free = motions.leftCols(n_free);
    const auto held = motions.rightCols(n - n_free);
    motion = held * (held.transpose() * load).cwiseQuotient(values.tail(n - n_free));
    return true;
}

/// Moves along free motions until no open row penetrates, as little as that takes; where none of them does that, nothing.
void clear_open_rows(const ShiftedQp& shifted, const MatrixXd& free, const ActiveSet& active, ContactState& state) {
    std::vector<Index> open;
    for (std::size_t k = 0; k < active.size(); ++k)
        if (!active[k]) open.push_back(static_cast<Index>(k));
    if (free.cols() == 0) return;
    const VectorXd gap = gap_of(shifted, state)(open);
    if (const auto least = least_distance(shifted.qp.modes(open, Eigen::all) * free, -gap))
        state.amplitudes += (1 + clear_fraction) * (free * *least);
}

/// solve: the amplitudes from their condensed stiffness and load.
template <class Solve>
bool solve_set(const ShiftedQp& shifted, const VectorXd& anchor, const ActiveSet& active, const Solve& solve,
               ClosedFactor& factor, ContactState& state) {
    Condensed c;
    VectorXd motion;
    if (!condense(shifted, anchor, active, factor, c) || !solve(c, motion)) return false;
    state = state_of(shifted.qp, factor, anchor, motion);
    return closes_what_is_left_out(shifted, factor, state);
}

std::size_t n_changed(const ActiveSet& active, const ActiveSet& next) {
    std::size_t n = 0;
    for (std::size_t k = 0; k < active.size(); ++k) n += next[k] != active[k] ? 1 : 0;
    return n;
}

/// solve: of a set, into the state; false where the set has no solution. Of many rows a step of the interior point method takes
/// as long as several of these, of which only those count that change no fewer rows than all before.
template <class Solve>
SetSearch search_sets(const ShiftedQp& shifted, const Solve& solve, ActiveSet& active, const ContactState& state,
                      int& iterations) {
    std::set<ActiveSet> seen;
    const bool counts_all = !shifted.qp.compliance.is_sparse();
    std::size_t fewest = active.size() + 1;
    for (int step = 0; step < max_primal_dual_steps;) {
        if (!seen.insert(active).second) return SetSearch::repeated;
        ++iterations;
        if (!solve()) return SetSearch::singular;
        ActiveSet next = next_set(shifted, active, state);
        const std::size_t changed = n_changed(active, next);
        if (changed == 0) return SetSearch::found;
        if (counts_all || changed >= fewest) ++step;
        fewest = std::min(fewest, changed);
        active = std::move(next);
    }
    return SetSearch::repeated;
}

}  // namespace

std::vector<Index> members(const ActiveSet& set) {
    std::vector<Index> list;
    for (std::size_t k = 0; k < set.size(); ++k)
        if (set[k]) list.push_back(static_cast<Index>(k));
    return list;
}

ActiveSet bilateral_rows(const ContactQp& qp) {
    ActiveSet set(qp.unilateral.size());
    std::transform(qp.unilateral.begin(), qp.unilateral.end(), set.begin(), [](char u) { return static_cast<char>(!u); });
    return set;
}

bool solve_on(const ShiftedQp& shifted, const Proximal& proximal, const ActiveSet& active, ClosedFactor& factor,
              ContactState& state) {
    const auto solve = [&](const Condensed& c, VectorXd& motion) {
        return solve_motion(c.stiffness + proximal.stiffness, c.load, motion);
    };
    return solve_set(shifted, proximal.anchor, active, solve, factor, state);
}

bool solve_least_motion(const ShiftedQp& shifted, const VectorXd& anchor, const ActiveSet& active, ClosedFactor& factor,
                        ContactState& state) {
    MatrixXd free;
    const auto solve = [&](const Condensed& c, VectorXd& motion) {
        return solve_held_motion(c.stiffness, c.load, motion, free);
    };
    return solve_set(shifted, anchor, active, solve, factor, state);
}

VectorXd gap_of(const ShiftedQp& shifted, const ContactState& s) {
    return shifted.gap + s.closing + shifted.qp.modes * s.amplitudes;
}

VectorXd gap_rounding(const ShiftedQp& shifted, const ContactState& s) {
    const ContactQp& qp = shifted.qp;
    VectorXd terms = shifted.gap.cwiseAbs();
    if (terms.size() == 0) return terms;
    terms.array() += qp.compliance.diagonal().cwiseAbs().maxCoeff() * s.multipliers.cwiseAbs().sum();
    if (qp.modes.cols() > 0) terms += qp.modes.cwiseAbs() * s.amplitudes.cwiseAbs();
    return term_rounding * terms;
}

ActiveSet next_set(const ShiftedQp& shifted, const ActiveSet& active, const ContactState& s) {
    const VectorXd gap = gap_of(shifted, s);
    const VectorXd rounding = gap_rounding(shifted, s);
    ActiveSet next(active.size());
    for (std::size_t k = 0; k < active.size(); ++k) {
        const auto i = static_cast<Index>(k);
        next[k] = !shifted.qp.unilateral[k] || (active[k] ? s.multipliers[i] > 0 : gap[i] < -rounding[i]);
    }
    return next;
}

SetSearch primal_dual(const ShiftedQp& shifted, const Proximal& proximal, ActiveSet& active, ClosedFactor& factor,
                      ContactState& state, int& iterations) {
    return search_sets(
        shifted, [&] { return solve_on(shifted, proximal, active, factor, state); }, active, state, iterations);
}

SetSearch pivot_by_blocks(const ShiftedQp& shifted, const Proximal& proximal, bool one_by_one, ActiveSet& active,
                          ClosedFactor& factor, ContactState& state, int& iterations) {
    ActiveSet best;  // of the fewest rows that want to change, with the last of them changed
    std::size_t fewest = active.size() + 1;
    int left = patience;
    for (int step = 0; step < max_pivots; ++step) {
        ++iterations;
        if (!solve_on(shifted, proximal, active, factor, state)) return SetSearch::singular;
        ActiveSet next = next_set(shifted, active, state);
        std::vector<std::size_t> wrong;
        for (std::size_t k = 0; k < active.size(); ++k)
            if (next[k] != active[k]) wrong.push_back(k);
        if (wrong.empty()) return SetSearch::found;
        if (wrong.size() < fewest) {
            fewest = wrong.size();
            left = patience;
            best = active;
            best[wrong.back()] = next[wrong.back()];
        }
        --left;
        if (left > 0)
            active = std::move(next);
        else if (!one_by_one)
            return SetSearch::repeated;
        else if (left == 0)
            active = best;
        else
            active[wrong.back()] = next[wrong.back()];
    }
    return SetSearch::repeated;
}

SetSearch primal_dual_or_least_motion(const ShiftedQp& shifted, ActiveSet& active, ClosedFactor& factor, ContactState& state,
                                      int& iterations) {
    const VectorXd here = VectorXd::Zero(shifted.qp.modes.cols());
    const auto solve = [&] {
        MatrixXd free(here.size(), 0);
        const auto amplitudes = [&](const Condensed& c, VectorXd& motion) {
            return solve_motion(c.stiffness, c.load, motion) || solve_held_motion(c.stiffness, c.load, motion, free);
        };
        if (!solve_set(shifted, here, active, amplitudes, factor, state)) return false;
        clear_open_rows(shifted, free, active, state);
        return true;
    };
    return search_sets(shifted, solve, active, state, iterations);
}

bool descend(const ShiftedQp& shifted, const Proximal& proximal, ActiveSet& active, ClosedFactor& factor, ContactState& state,
             int& iterations) {
    const ContactQp& qp = shifted.qp;
    const ProximalEnergy energy(shifted, proximal);
    VectorXd l = state.multipliers;
    project(qp, l, active);
    double lowest = energy(l);
    bool fell = true;  // since rows were added last
    const int limit = 50 + 10 * static_cast<int>(l.size());
    for (int step = 0; step < limit; ++step) {
        ++iterations;
        if (!solve_on(shifted, proximal, active, factor, state)) return false;
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
            if (!close_penetrated(shifted, state, fell, active)) return true;
            fell = false;
            continue;
        }
        l += block.share * (state.multipliers - l);
        l[block.row] = 0;
        active[static_cast<std::size_t>(block.row)] = 0;
        fell = fell || block.share > 0;
        lowest = std::min(lowest, energy(l));
    }
    return false;
}

}  // namespace abut::solver
