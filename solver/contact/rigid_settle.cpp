// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/rigid_settle.hpp"

#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "solver/linear_algebra/dense.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Stiff gaps that close one after the other take a step each: as many as there are motions, and some more. On softer ones most
/// close at once, and from where bodies rest on these it is few steps to where they rest on stiffer ones.
constexpr Index few_newton_steps = 20;
constexpr std::array<double, 4> softenings{1e-6, 1e-4, 1e-2, 1};
constexpr double balance_tolerance = 1e-12;  // relative to the loads
constexpr double balance_rounding = 2e-16;   // of the terms of a balance of forces
constexpr double energy_rounding = 1e-15;    // of the terms that the energy is the sum of
/// Of the mean stiffness: what holds motions that no pressed row resists. Less after every full step, for a body that has to
/// slide far under a small part of its load; more where the step was too long.
constexpr double first_held = 1e-9, least_held = 1e-16, held_factor = 10;

/// Of the stiffest motion: softer ones are free; and where loads work in those that are softer than this, they go so far that
/// they leave no digits to the rest.
constexpr double free_pivot = 1e-9, soft_pivot = 1e-3;

/// From so many motions on rows may have few entries: where each is of one body. Where most of them are of many bodies,
/// products of whole rows are faster.
constexpr Index many_motions = 12;
constexpr double few_entries = 0.25;

/// G, by the entries of its rows where these are few.
class MotionRows {
public:
    explicit MotionRows(const MatrixXd& modes) : modes_(modes) {
        if (modes.cols() < many_motions) return;
        by_row_ = modes.sparseView();
        is_sparse_ = static_cast<double>(by_row_.nonZeros()) <= few_entries * static_cast<double>(modes.size());
    }
    VectorXd times(const VectorXd& amplitudes) const {
        return is_sparse_ ? VectorXd(by_row_ * amplitudes) : VectorXd(modes_ * amplitudes);
    }
    VectorXd transposed_times(const VectorXd& rows) const {
        return is_sparse_ ? VectorXd(by_row_.transpose() * rows) : VectorXd(modes_.transpose() * rows);
    }
    VectorXd sizes_times(const VectorXd& amplitudes) const {
        return is_sparse_ ? VectorXd(by_row_.cwiseAbs() * amplitudes) : VectorXd(modes_.cwiseAbs() * amplitudes);
    }
    VectorXd transposed_sizes_times(const VectorXd& rows) const {
        return is_sparse_ ? VectorXd(by_row_.cwiseAbs().transpose() * rows) : VectorXd(modes_.cwiseAbs().transpose() * rows);
    }

    /// G'WG with a diagonal W.
    MatrixXd gram(const VectorXd& weight) const {
        MatrixXd gram = MatrixXd::Zero(modes_.cols(), modes_.cols());
        if (is_sparse_) {
            for (Index k = 0; k < by_row_.rows(); ++k)
                for (Entry a(by_row_, k); a && weight[k] != 0; ++a)
                    for (Entry b(by_row_, k); b; ++b) gram(a.col(), b.col()) += a.value() * weight[k] * b.value();
            return gram;
        }
        if (modes_.cols() >= many_motions) {
            std::vector<Index> weighted;
            for (Index k = 0; k < weight.size(); ++k)
                if (weight[k] != 0) weighted.push_back(k);
            const MatrixXd rows = modes_(weighted, Eigen::all);
            return product(rows.transpose(), weight(weighted).asDiagonal() * rows);
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

    const MatrixXd& modes_;
    SparseRows by_row_;
    bool is_sparse_ = false;
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

/// The share of a direction, 1 at most, after which the energy rises: it is convex, of parabolas that meet where rows close or
/// open. gap, opening: where the direction begins, and how much of it the whole direction opens; fall: of the energy per share
/// there. Sums of changes alone, which rounding leaves more digits than the energy.
double share_of_descent(const ContactQp& qp, const VectorXd& foundation, const VectorXd& gap, const VectorXd& opening,
                        double fall) {
    const auto released = [&](Index k, double share) {
        const double there = gap[k] + share * opening[k];
        if (!qp.unilateral[static_cast<std::size_t>(k)] || (gap[k] < 0 && there < 0)) return share * opening[k];
        return gap[k] < 0 ? -gap[k] : std::min(0.0, there);
    };
    const auto slope = [&](double share) {
        double sum = -fall;
        for (Index k = 0; k < gap.size(); ++k)
            if (opening[k] != 0) sum += foundation[k] * released(k, share) * opening[k];
        return sum;
    };
    if (slope(1) <= 0) return 1;
    std::vector<double> kinks{0, 1};
    for (Index k = 0; k < gap.size(); ++k)
        if (const double at = -gap[k] / opening[k]; at > 0 && at < 1) kinks.push_back(at);
    std::sort(kinks.begin(), kinks.end());
    const auto rising = std::partition_point(kinks.begin() + 1, kinks.end() - 1, [&](double at) { return slope(at) <= 0; });
    const double begin = *(rising - 1), end = *rising, falls = slope(begin), rises = slope(end);
    return rises > falls ? begin + (end - begin) * std::clamp(-falls / (rises - falls), 0.0, 1.0) : end;
}

/// Goes the whole direction where that halves the imbalance, or else as long as the energy falls. The share of it; 0: the
/// energy rises by rounding, and the imbalance does not become half as large, so that it stays. energy: of `s`.
double move_along(const ContactQp& qp, const VectorXd& foundation, const MotionRows& modes, const VectorXd& residual,
                  const VectorXd& direction, Settled& s, Energy& energy) {
    const auto moves_by = [&](double share, bool is_whole) {
        VectorXd trial = s.amplitudes + share * direction, l = pressures(qp, foundation, modes, trial);
        const Energy there = energy_of(qp, foundation, trial, l);
        const bool falls = there.value <= energy.value + (is_whole ? energy.rounding : 0),
                   halves = imbalance(qp, modes, l).norm() <= 0.5 * residual.norm();
        if (is_whole ? !falls || !halves : !falls && !halves) return false;
        s.amplitudes = std::move(trial);
        s.multipliers = std::move(l);
        energy = there;
        return true;
    };
    if (moves_by(1, true)) return 1;
    const VectorXd gap = qp.drawn_gap + modes.times(s.amplitudes);
    const double share = share_of_descent(qp, foundation, gap, modes.times(direction), residual.dot(direction));
    return share > 0 && moves_by(share, false) ? share : 0;
}

/// G'KG of a foundation, and a little (`held`) against motions that it does not hold.
MatrixXd held_stiffness(const MotionRows& modes, const VectorXd& foundation, double held) {
    MatrixXd stiffness = modes.gram(foundation);
    stiffness.diagonal().array() += held;
    return stiffness;
}

double force_scale_of(const ContactQp& qp, const MotionRows& modes, const VectorXd& multipliers) {
    if (qp.modes.size() == 0) return qp.load_scale;
    const VectorXd sizes = multipliers.cwiseAbs();
    const double scale = std::max(qp.load_scale, modes.transposed_sizes_times(sizes).maxCoeff());
    if (qp.load_scale > 0) return scale;
    // forces of displacements alone may all be across the motions, on which nothing but their rounding acts then
    return std::max(scale, qp.modes.cwiseAbs().maxCoeff() * sizes.maxCoeff());
}

/// What the rounding of gaps, which are the small differences of drawn gaps and motions, may leave of the balance: stiff gaps
/// turn it into force.
double imbalance_rounding(const ContactQp& qp, const VectorXd& foundation, const MotionRows& modes, const Settled& s) {
    const VectorXd terms = qp.drawn_gap.cwiseAbs() + modes.sizes_times(s.amplitudes.cwiseAbs());
    const VectorXd force = (s.multipliers.array() != 0).select(foundation.cwiseProduct(terms), 0.0);
    return balance_rounding * modes.transposed_sizes_times(force).norm();
}

/// x of A x = b for a semidefinite A; of many motions by BLAS while all pivots are positive.
VectorXd answer_of(const MatrixXd& a, const VectorXd& b) {
    if (a.cols() >= many_motions)
        if (const Cholesky factor(a); factor.succeeded()) return factor.solve(b);
    return PivotedCholesky(a).solve(b);
}

/// Newton's steps on a foundation from the amplitudes of `s`, so many at most. True: as far as rounding lets them.
bool settle_on_foundation(const ContactQp& qp, const VectorXd& foundation, const MotionRows& modes, double mean, Index steps,
                          Settled& s) {
    s.multipliers = pressures(qp, foundation, modes, s.amplitudes);
    double held = first_held, before = std::numeric_limits<double>::infinity();
    Energy energy = energy_of(qp, foundation, s.amplitudes, s.multipliers);
    for (Index step = 0; step < steps; ++step) {
        const VectorXd residual = imbalance(qp, modes, s.multipliers);
        const double scale = force_scale_of(qp, modes, s.multipliers), left = residual.norm();
        const bool is_rounding = left <= imbalance_rounding(qp, foundation, modes, s);
        s.balanced = left <= balance_tolerance * scale || (is_rounding && left <= equilibrium_tolerance * scale);
        if (mean == 0 || left <= balance_tolerance * scale || (is_rounding && left > 0.5 * before)) return true;
        before = left;
        const VectorXd pressed = (s.multipliers.array() != 0).select(foundation, 0.0);
        const VectorXd direction = answer_of(held_stiffness(modes, pressed, held * mean), residual);
        const double share = move_along(qp, foundation, modes, residual, direction, s, energy);
        if (share == 0) return is_rounding;
        held = share == 1 ? std::max(least_held, held / held_factor) : std::min(first_held, held * held_factor);
    }
    return false;
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
    const bool is_at_rest = settle_on_foundation(qp, qp.foundation, modes, mean, few_newton_steps + n, s);
    // of few motions softer gaps are a second way to rest that costs nothing, and may leave fewer roundings
    if (s.balanced || mean == 0 || (is_at_rest && n >= many_motions)) return s;
    s.amplitudes.setZero();
    for (const double softening : softenings)
        settle_on_foundation(qp, softened(qp, softening), modes, mean, few_newton_steps, s);
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
    const VectorXd load = qp.mode_load - qp.modes.transpose() * foundation.cwiseProduct(qp.drawn_gap);
    VectorXd amplitudes = factor.solve(load);
    const double farthest = load.cwiseAbs().maxCoeff() / (soft_pivot * pivots.maxCoeff());
    if (!(amplitudes.cwiseAbs().maxCoeff() <= farthest)) return std::nullopt;
    return amplitudes;
}

}  // namespace abut::solver
