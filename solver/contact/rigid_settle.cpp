// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/rigid_settle.hpp"

#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "solver/linear_algebra/dense.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Stiff gaps that close one after the other take a step each. On softer ones most close at once, and from where bodies rest on
/// these it is few steps to where they rest on stiffer ones.
constexpr int max_newton_steps = 20;
constexpr std::array<double, 4> softenings{1e-6, 1e-4, 1e-2, 1};
constexpr double balance_tolerance = 1e-12;  // relative to the loads
constexpr double least_share = 1e-12;        // of a step: below, the energy's rounding hides any descent
constexpr double sufficient_descent = 1e-4;  // Armijo's share of the linear prediction
constexpr double balance_rounding = 2e-16;   // of the terms of a balance of forces
constexpr double energy_rounding = 1e-15;    // of the terms that the energy is the sum of
/// Of the mean stiffness: what holds motions that no pressed row resists. Less after every full step, for a body that has to
/// slide far under a small part of its load; more where the step was too long.
constexpr double first_held = 1e-9, least_held = 1e-16, held_factor = 10;

/// Of the stiffest motion: softer ones could go so far that they leave no digits to the rest.
constexpr double free_pivot = 1e-3;

/// From so many motions on, a row, which two bodies' move, has few entries.
constexpr Index many_motions = 12;

/// G, by the entries of its rows where these are few.
class MotionRows {
public:
    explicit MotionRows(const MatrixXd& modes) : modes_(modes) {
        if (is_sparse()) by_row_ = modes.sparseView();
    }
    VectorXd times(const VectorXd& amplitudes) const {
        return is_sparse() ? VectorXd(by_row_ * amplitudes) : VectorXd(modes_ * amplitudes);
    }
    VectorXd transposed_times(const VectorXd& rows) const {
        return is_sparse() ? VectorXd(by_row_.transpose() * rows) : VectorXd(modes_.transpose() * rows);
    }
    VectorXd sizes_times(const VectorXd& amplitudes) const {
        return is_sparse() ? VectorXd(by_row_.cwiseAbs() * amplitudes) : VectorXd(modes_.cwiseAbs() * amplitudes);
    }
    VectorXd transposed_sizes_times(const VectorXd& rows) const {
        return is_sparse() ? VectorXd(by_row_.cwiseAbs().transpose() * rows) : VectorXd(modes_.cwiseAbs().transpose() * rows);
    }

    /// G'WG with a diagonal W.
    MatrixXd gram(const VectorXd& weight) const {
        MatrixXd gram = MatrixXd::Zero(modes_.cols(), modes_.cols());
        if (is_sparse()) {
            for (Index k = 0; k < by_row_.rows(); ++k)
                for (Entry a(by_row_, k); a && weight[k] != 0; ++a)
                    for (Entry b(by_row_, k); b; ++b) gram(a.col(), b.col()) += a.value() * weight[k] * b.value();
            return gram;
        }
        VectorXd column(modes_.rows());
        for (Index j = 0; j < modes_.cols(); ++j) {
            column = weight.cwiseProduct(modes_.col(j));
            for (Index i = 0; i <= j; ++i) gram(i, j) = gram(j, i) = column.dot(modes_.col(i));
        }
        return gram;
    }

private:
    using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
    using Entry = SparseRows::InnerIterator;
    bool is_sparse() const { return modes_.cols() >= many_motions; }

    const MatrixXd& modes_;
    SparseRows by_row_;
};

VectorXd pressures(const ContactQp& qp, const VectorXd& foundation, const MotionRows& modes, const VectorXd& amplitudes) {
    const VectorXd gap = qp.drawn_gap + modes.times(amplitudes);
    VectorXd l = -foundation.cwiseProduct(gap);
    for (Index k = 0; k < l.size(); ++k)
        if (qp.unilateral[static_cast<std::size_t>(k)]) l[k] = std::max(0.0, l[k]);
    return l;
}

/// With what its terms' rounding may hide.
struct Energy {
    double value, rounding;
};
Energy energy_of(const ContactQp& qp, const VectorXd& foundation, const VectorXd& amplitudes, const VectorXd& l) {
    const double stored = 0.5 * l.cwiseProduct(l).cwiseQuotient(foundation).sum();
    const VectorXd work = qp.mode_load.cwiseProduct(amplitudes);
    return {stored - work.sum(), energy_rounding * (stored + work.cwiseAbs().sum())};
}

VectorXd imbalance(const ContactQp& qp, const MotionRows& modes, const VectorXd& l) {
    return modes.transposed_times(l) + qp.mode_load;
}

/// Goes the largest of 1, 1/2, 1/4, ... of the direction that lowers the energy enough; where rounding hides what it falls by,
/// that halves the imbalance. 0: none, and stays. energy: of `s`.
double move_along(const ContactQp& qp, const VectorXd& foundation, const MotionRows& modes, const VectorXd& residual,
                  const VectorXd& direction, Settled& s, Energy& energy) {
    const Energy before = energy;
    const double slope = residual.dot(direction);
    for (double share = 1; share > least_share; share *= 0.5) {
        VectorXd trial = s.amplitudes + share * direction, l = pressures(qp, foundation, modes, trial);
        const double wanted = sufficient_descent * share * slope;
        energy = energy_of(qp, foundation, trial, l);
        const bool falls = energy.value <= before.value - wanted;
        if (!falls && (wanted > before.rounding || imbalance(qp, modes, l).norm() > 0.5 * residual.norm())) continue;
        s.amplitudes = std::move(trial);
        s.multipliers = std::move(l);
        return share;
    }
    return 0;
}

/// G'KG of a foundation, and a little (`held`) against motions that it does not hold.
MatrixXd held_stiffness(const MotionRows& modes, const VectorXd& foundation, double held) {
    MatrixXd stiffness = modes.gram(foundation);
    stiffness.diagonal().array() += held;
    return stiffness;
}

double force_scale_of(const ContactQp& qp, const MotionRows& modes, const VectorXd& multipliers) {
    if (qp.modes.size() == 0) return qp.load_scale;
    return std::max(qp.load_scale, modes.transposed_sizes_times(multipliers.cwiseAbs()).maxCoeff());
}

/// What the rounding of gaps, which are the small differences of drawn gaps and motions, may leave of the balance: stiff gaps
/// turn it into force.
double imbalance_rounding(const ContactQp& qp, const VectorXd& foundation, const MotionRows& modes, const Settled& s) {
    const VectorXd terms = qp.drawn_gap.cwiseAbs() + modes.sizes_times(s.amplitudes.cwiseAbs());
    const VectorXd force = (s.multipliers.array() != 0).select(foundation.cwiseProduct(terms), 0.0);
    return balance_rounding * modes.transposed_sizes_times(force).norm();
}

/// Newton's steps on a foundation from the amplitudes of `s`.
void settle_on_foundation(const ContactQp& qp, const VectorXd& foundation, const MotionRows& modes, double mean, Settled& s) {
    s.multipliers = pressures(qp, foundation, modes, s.amplitudes);
    double held = first_held;
    Energy energy = energy_of(qp, foundation, s.amplitudes, s.multipliers);
    for (int step = 0; step < max_newton_steps; ++step) {
        const VectorXd residual = imbalance(qp, modes, s.multipliers);
        s.balanced = residual.norm() <= balance_tolerance * force_scale_of(qp, modes, s.multipliers);
        if (mean == 0 || residual.norm() <= imbalance_rounding(qp, foundation, modes, s)) return;
        if (s.balanced) return;
        const VectorXd pressed = (s.multipliers.array() != 0).select(foundation, 0.0);
        const VectorXd direction = PivotedCholesky(held_stiffness(modes, pressed, held * mean)).solve(residual);
        const double share = move_along(qp, foundation, modes, residual, direction, s, energy);
        if (share == 0) return;
        held = share == 1 ? std::max(least_held, held / held_factor) : std::min(first_held, held * held_factor);
    }
}

/// The foundation softer where bodies may lift off.
VectorXd softened(const ContactQp& qp, double factor) {
    VectorXd foundation = qp.foundation;
    for (Index k = 0; k < foundation.size(); ++k)
        if (qp.unilateral[static_cast<std::size_t>(k)]) foundation[k] *= factor;
    return foundation;
}

}  // namespace

double force_scale(const ContactQp& qp, const VectorXd& multipliers) {
    return force_scale_of(qp, MotionRows(qp.modes), multipliers);
}

MatrixXd foundation_stiffness(const ContactQp& qp) {
    return MotionRows(qp.modes).gram(qp.foundation);
}

Settled settle_rigidly(const ContactQp& qp) {
    const Index n = qp.modes.cols();
    Settled s{VectorXd::Zero(n), VectorXd::Zero(qp.gap.size()), MatrixXd::Zero(n, n), n == 0};
    if (qp.gap.size() == 0) return s;
    const MotionRows modes(qp.modes);
    s.stiffness = modes.gram(qp.foundation);
    if (n == 0) {
        s.multipliers = pressures(qp, qp.foundation, modes, s.amplitudes);
        return s;
    }
    const double mean = s.stiffness.trace() / static_cast<double>(n);
    settle_on_foundation(qp, qp.foundation, modes, mean, s);
    if (s.balanced || mean == 0) return s;
    s.amplitudes.setZero();
    for (const double softening : softenings) settle_on_foundation(qp, softened(qp, softening), modes, mean, s);
    return s;
}

std::optional<VectorXd> settle_on(const ContactQp& qp, const std::vector<char>& closed) {
    const Index n = qp.modes.cols();
    if (n == 0) return VectorXd::Zero(n);
    VectorXd foundation = qp.foundation;
    for (Index k = 0; k < foundation.size(); ++k)
        if (!closed[static_cast<std::size_t>(k)]) foundation[k] = 0;
    const PivotedCholesky factor(MotionRows(qp.modes).gram(foundation));
    const VectorXd pivots = factor.pivots();
    if (!factor.succeeded() || !(pivots.minCoeff() > free_pivot * pivots.maxCoeff())) return std::nullopt;
    return factor.solve(qp.mode_load - qp.modes.transpose() * foundation.cwiseProduct(qp.drawn_gap));
}

}  // namespace abut::solver
