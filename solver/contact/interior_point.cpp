// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/interior_point.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "solver/contact/rigid_settle.hpp"
#include "solver/linear_algebra/dense.hpp"
#include "solver/linear_algebra/sparse_cholesky.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int max_steps = 100;
constexpr double to_boundary = 0.995;  // of the longest step that keeps l and gap positive
/// Of the mean diagonal of C and of G'C^-1 G: keeps the factors of redundant rows, and of motions that no row resists yet.
constexpr double regularization = 1e-13;

/// Unilateral rows have a multiplier and a gap, both positive; bilateral ones a gap that is to vanish.
struct Iterate {
    VectorXd l, a, gap;
};
using Direction = Iterate;

/// Units of forces and of lengths.
struct Scales {
    double force, length;
};

/// The factor of C with another diagonal.
class SoftenedFactor {
public:
    explicit SoftenedFactor(const ContactQp& qp) : qp_(qp) {
        if (!qp.compliance.is_sparse()) return;
        std::vector<Index> rows(static_cast<std::size_t>(qp.gap.size()));
        std::iota(rows.begin(), rows.end(), Index{0});
        lower_ = qp.compliance.among(rows);
        modes_ = qp.modes.sparseView();
    }
    bool compute(const VectorXd& diagonal) {
        if (!qp_.compliance.is_sparse()) {
            MatrixXd matrix = qp_.compliance.dense();
            matrix.diagonal() = diagonal;
            return dense_.compute(std::move(matrix));
        }
        SparseSymmetric matrix = lower_;
        for (std::size_t j = 0; j + 1 < matrix.first.size(); ++j)
            matrix.value[static_cast<std::size_t>(matrix.first[j])] = diagonal[static_cast<Index>(j)];
        return sparse_.compute(std::move(matrix)) < 0;
    }
    VectorXd solve(const VectorXd& b) const { return qp_.compliance.is_sparse() ? sparse_.solve(b) : dense_.solve(b); }
    /// Of G.
    MatrixXd inverse_form() const {
        if (qp_.compliance.is_sparse()) return sparse_.inverse_form(modes_);
        const MatrixXd columns = dense_.solve_lower(qp_.modes);
        return columns.transpose() * columns;
    }

private:
    const ContactQp& qp_;
    Cholesky dense_;
    SparseSymmetric lower_;
    Eigen::SparseMatrix<double> modes_;
    SparseCholesky sparse_;
};

class Newton {
public:
    Newton(const ShiftedQp& shifted) : qp_(shifted.qp), gap0_(shifted.gap), compliance_(shifted.qp) {
        const Index m = gap0_.size();
        for (Index k = 0; k < m; ++k)
            if (qp_.unilateral[static_cast<std::size_t>(k)]) unilateral_.push_back(k);
    }
    const std::vector<Index>& unilateral() const { return unilateral_; }

    /// Residuals of gap = g + C l + G a (of bilateral rows: of 0), and of the balance. The state that they are of.
    ContactState look_at(const Iterate& x) {
        ContactState state{x.l, x.a, qp_.compliance * x.l};
        of_gap_ = gap0_ + state.closing + qp_.modes * x.a - x.gap;
        of_balance_ = qp_.modes.transpose() * x.l + qp_.mode_load;
        return state;
    }
    double gap_residual() const { return of_gap_.size() > 0 ? of_gap_.cwiseAbs().maxCoeff() : 0; }
    double balance_residual() const { return of_balance_.size() > 0 ? of_balance_.cwiseAbs().maxCoeff() : 0; }

    bool factorize(const Iterate& x) {
        VectorXd diagonal = qp_.compliance.diagonal();
        diagonal.array() += regularization * diagonal.mean();
        for (Index k : unilateral_) diagonal[k] += x.gap[k] / x.l[k];
        if (!compliance_.compute(diagonal)) return false;
        if (qp_.modes.cols() == 0) return true;
        MatrixXd stiffness = compliance_.inverse_form();
        stiffness.diagonal().array() += regularization * stiffness.diagonal().mean();
        return stiffness_.compute(stiffness);
    }

    /// Towards l gap = product (by row).
    Direction direction(const Iterate& x, const VectorXd& product) const {
        VectorXd right = -of_gap_;
        for (Index k : unilateral_) right[k] += (product[k] - x.l[k] * x.gap[k]) / x.l[k];
        Direction d{compliance_.solve(right), VectorXd(0), VectorXd::Zero(right.size())};
        d.a = VectorXd::Zero(qp_.modes.cols());
        if (d.a.size() > 0) {
            d.a = stiffness_.solve(of_balance_ + qp_.modes.transpose() * d.l);
            d.l -= compliance_.solve(qp_.modes * d.a);
        }
        for (Index k : unilateral_) d.gap[k] = (product[k] - x.l[k] * x.gap[k] - x.gap[k] * d.l[k]) / x.l[k];
        return d;
    }

    /// The longest step in which no unilateral multiplier, or gap, falls below zero; 1 at most.
    double longest_share(const VectorXd& value, const VectorXd& change) const {
        double share = 1;
        for (Index k : unilateral_)
            if (change[k] < 0) share = std::min(share, -value[k] / change[k]);
        return share;
    }

    double mean_product(const VectorXd& l, const VectorXd& gap) const {
        double sum = 0;
        for (Index k : unilateral_) sum += l[k] * gap[k];
        return unilateral_.empty() ? 0 : sum / static_cast<double>(unilateral_.size());
    }

private:
    const ContactQp& qp_;
    const VectorXd& gap0_;
    std::vector<Index> unilateral_;
    VectorXd of_gap_, of_balance_;
    SoftenedFactor compliance_;
    Cholesky stiffness_;
};

/// All rows pressed and open by the mean of the start.
Iterate first_iterate(const ShiftedQp& shifted, const std::vector<Index>& unilateral, const Scales& scales) {
    const Index m = shifted.gap.size();
    Iterate x{VectorXd::Zero(m), VectorXd::Zero(shifted.qp.modes.cols()), VectorXd::Zero(m)};
    for (Index k : unilateral) {
        x.l[k] = scales.force;
        x.gap[k] = std::max(scales.length, shifted.gap[k]);
    }
    return x;
}

Scales scales_of(const ShiftedQp& shifted, const VectorXd& start) {
    const double force =
        std::max(start.cwiseAbs().maxCoeff(), force_scale(shifted.qp, start) / static_cast<double>(start.size()));
    const double length =
        std::max(shifted.qp.compliance.diagonal().maxCoeff() * force, (shifted.qp.compliance * start).cwiseAbs().maxCoeff());
    return {force, length};
}

}  // namespace

InteriorPoint interior_point(const ShiftedQp& shifted, const VectorXd& start) {
    const ContactQp& qp = shifted.qp;
    InteriorPoint result;
    result.active = bilateral_rows(qp);
    if (start.size() == 0) return result;
    const Scales scales = scales_of(shifted, start);
    Scales reached = scales;  // a thin part gives way to a single row's force by far more than to all of them
    if (!(scales.force > 0 && scales.length > 0)) return result;
    Newton newton(shifted);
    Iterate x = first_iterate(shifted, newton.unilateral(), scales);
    for (result.iterations = 0; result.iterations < max_steps; ++result.iterations) {
        const ContactState state = newton.look_at(x);
        const double mean = newton.mean_product(x.l, x.gap);
        reached = {x.l.cwiseAbs().maxCoeff(), state.closing.cwiseAbs().maxCoeff()};
        const double rounding = gap_rounding(shifted, state).maxCoeff();
        result.converged = mean <= complementarity * reached.force * reached.length &&
                           newton.gap_residual() <= std::max(complementarity * reached.length, rounding) &&
                           newton.balance_residual() <= complementarity * force_scale(qp, x.l);
        if (result.converged || !newton.factorize(x)) break;
        const VectorXd none = VectorXd::Zero(x.l.size());
        const Direction predictor = newton.direction(x, none);
        const double pressed = newton.longest_share(x.l, predictor.l), open = newton.longest_share(x.gap, predictor.gap);
        const double predicted = newton.mean_product(x.l + pressed * predictor.l, x.gap + open * predictor.gap);
        const double centering = mean > 0 ? std::pow(predicted / mean, 3) : 0;
        const VectorXd product = VectorXd::Constant(x.l.size(), centering * mean) - predictor.l.cwiseProduct(predictor.gap);
        const Direction d = newton.direction(x, product);
        // one length for both: C couples them
        const double share =
            std::min(1.0, to_boundary * std::min(newton.longest_share(x.l, d.l), newton.longest_share(x.gap, d.gap)));
        x.l += share * d.l;
        x.a += share * d.a;
        x.gap += share * d.gap;
    }
    for (Index k : newton.unilateral())
        result.active[static_cast<std::size_t>(k)] = x.l[k] / reached.force > x.gap[k] / reached.length;
    result.state = {x.l, x.a, qp.compliance * x.l};
    return result;
}

}  // namespace abut::solver
