// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/kept_states.hpp"

#include <utility>

namespace abut::solver {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double kept_singular = 1e-13;  // reciprocal condition numbers
constexpr double kept_rounding = 1e-14;  // of the terms of an equation
constexpr int most_refinements = 3;

double largest(const VectorXd& v) {
    return v.size() > 0 ? v.cwiseAbs().maxCoeff() : 0;
}

}  // namespace

bool KeptStates::factor(const ContactQp& qp, const ActiveSet& states) {
    const Index n = qp.modes.cols();
    FactoredStates factored(qp, MatrixXd::Zero(n, n), states);
    if (!factored.succeeded() || !(factored.reciprocal_condition() > kept_singular)) return false;
    base_.emplace(Base{std::move(factored), std::vector<std::optional<StatesPoint>>(states.size())});
    return true;
}

std::optional<std::vector<Index>> KeptStates::changes_to(const ContactQp& qp, const ActiveSet& states) {
    if ((!base_ || !base_->factored.is_of(qp)) && !factor(qp, states)) return std::nullopt;
    std::vector<Index> changed;
    for (std::size_t k = 0; k < states.size(); ++k)
        if (states[k] != base_->factored.states()[k]) changed.push_back(static_cast<Index>(k));
    if (const std::size_t most = base_->factored.most_changes(); changed.size() > most || base_->n_responses > 2 * most) {
        if (!factor(qp, states)) return std::nullopt;
        changed.clear();
    }
    const Index rows = qp.gap.size(), n = qp.modes.cols();
    for (Index row : changed)
        if (std::optional<StatesPoint>& response = base_->responses[index_of(row)]; !response) {
            response = base_->factored.answer(VectorXd::Unit(rows, row), VectorXd::Zero(n));
            base_->factored.fill_opening(*response);
            ++base_->n_responses;
        }
    return changed;
}

bool KeptStates::solve(const ShiftedQp& shifted, const ActiveSet& states, ContactState& state) {
    const ContactQp& qp = shifted.qp;
    const std::optional<std::vector<Index>> changes = changes_to(qp, states);
    if (!changes) return false;
    const std::vector<Index>& changed = *changes;
    const FrictionByRow friction = friction_by_row(qp);
    const Index m = static_cast<Index>(changed.size()), rows = shifted.gap.size(), n = qp.modes.cols();
    MatrixXd left(m, m);
    for (Index j = 0; j < m; ++j)
        for (Index i = 0; i < m; ++i)
            left(i, j) = left_of(changed[index_of(i)], states, friction, *base_->responses[index_of(changed[index_of(j)])]);
    const SquareFactor small(std::move(left));
    if (!small.succeeded() || !(small.reciprocal_condition() > kept_singular)) return false;

    const double unit = force_unit(qp);
    const VectorXd load = qp.mode_load / unit;
    std::vector<Index> closed;
    for (std::size_t k = 0; k < states.size(); ++k)
        if (states[k] == row_state::closed) closed.push_back(static_cast<Index>(k));
    const MatrixXd closed_modes = qp.modes(closed, Eigen::all);
    const VectorXd closed_gap = shifted.gap(closed);
    VectorXd forces = VectorXd::Zero(rows), amplitudes = VectorXd::Zero(n), gap = VectorXd::Zero(rows);
    for (int step = 0; step <= most_refinements; ++step) {
        // what the equations lack: of closed rows the gap, of amplitudes the balance
        const VectorXd closing = unit * qp.compliance.product_at(closed, forces), moved = closed_modes * amplitudes;
        const VectorXd open = -(closed_gap + closing + moved);
        const VectorXd unbalanced = -(load + qp.modes.transpose() * forces);
        const double gap_terms = largest(closed_gap) + largest(closing) + largest(moved);
        const double load_terms = largest(load) + largest(qp.modes.cwiseAbs().transpose() * forces.cwiseAbs());
        if (largest(open) <= kept_rounding * gap_terms && largest(unbalanced) <= kept_rounding * load_terms) {
            state.multipliers = unit * forces;
            state.amplitudes = std::move(amplitudes);
            state.closing = qp.compliance * state.multipliers;
            return true;
        }
        if (step == most_refinements) break;
        gap(closed) = open;
        VectorXd of_base = gap;
        for (Index row : changed) of_base[row] = 0;
        StatesPoint more = base_->factored.answer(of_base, unbalanced);
        base_->factored.fill_opening(more, changed);
        VectorXd right(m);
        for (Index i = 0; i < m; ++i)
            right[i] = gap[changed[index_of(i)]] - left_of(changed[index_of(i)], states, friction, more);
        right = small.solve(std::move(right));
        for (Index i = 0; i < m; ++i) {
            const StatesPoint& response = *base_->responses[index_of(changed[index_of(i)])];
            more.forces += right[i] * response.forces;
            more.amplitudes += right[i] * response.amplitudes;
        }
        forces += more.forces;
        amplitudes += more.amplitudes;
        for (Index k = 0; k < rows; ++k)
            if (states[index_of(k)] == row_state::open) forces[k] = 0;
        for (const FrictionRow& f : qp.friction)
            if (const double way = direction_of(states[index_of(f.tangential)]); way != 0)
                forces[f.tangential] = -way * f.coefficient * forces[f.normal];
    }
    return false;
}

}  // namespace abut::solver
