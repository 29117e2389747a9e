// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/nonnegative.hpp"

#include <algorithm>
#include <limits>

#include "solver/linear_algebra/dense.hpp"
#include "src/base/ensure.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;

Eigen::VectorXd least_squares_on(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, const std::vector<Index>& passive) {
    Eigen::MatrixXd columns(a.rows(), static_cast<Index>(passive.size()));
    for (std::size_t i = 0; i < passive.size(); ++i) columns.col(static_cast<Index>(i)) = a.col(passive[i]);
    return least_squares(columns, b);
}

}  // namespace

NonnegativeResult nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b,
                                            const std::vector<char>& bounded) {
    const Index n = a.cols();
    ENSURE(b.size() == a.rows() && static_cast<Index>(bounded.size()) == n,
           "there is a datum for every row, a bound for every column");
    NonnegativeResult r{Eigen::VectorXd::Zero(n), b, true};
    if (a.size() == 0) return r;
    r.converged = false;
    const double tolerance = 1e-12 * (a.cwiseAbs().maxCoeff() * b.norm() + std::numeric_limits<double>::min());
    std::vector<Index> passive;
    for (Index k = 0; k < n; ++k)
        if (!bounded[static_cast<std::size_t>(k)]) passive.push_back(k);
    if (!passive.empty()) {
        const Eigen::VectorXd z = least_squares_on(a, b, passive);
        for (std::size_t i = 0; i < passive.size(); ++i) r.x[passive[i]] = z[static_cast<Index>(i)];
        r.residual = b - a * r.x;
    }
    for (Index step = 0; step < 3 * n + 10; ++step) {
        const Eigen::VectorXd w = a.transpose() * r.residual;
        Index enter = -1;
        for (Index k = 0; k < n; ++k)
            if (bounded[static_cast<std::size_t>(k)] && r.x[k] == 0 && w[k] > tolerance && (enter < 0 || w[k] > w[enter]))
                enter = k;
        if (enter < 0) {
            r.converged = true;
            return r;
        }
        passive.push_back(enter);
        for (;;) {
            const Eigen::VectorXd z = least_squares_on(a, b, passive);
            double share = 1;
            for (std::size_t i = 0; i < passive.size(); ++i) {
                const Index k = passive[i];
                const double zk = z[static_cast<Index>(i)];
                if (bounded[static_cast<std::size_t>(k)] && zk <= 0) share = std::min(share, r.x[k] / (r.x[k] - zk));
            }
            if (!(share >= 0)) share = 0;
            std::vector<Index> kept;
            for (std::size_t i = 0; i < passive.size(); ++i) {
                const Index k = passive[i];
                const double zk = z[static_cast<Index>(i)];
                const bool leaves = share < 1 && bounded[static_cast<std::size_t>(k)] && zk <= 0 &&
                                    r.x[k] <= share * (r.x[k] - zk) * (1 + 1e-14);
                r.x[k] = leaves ? 0.0 : r.x[k] + share * (zk - r.x[k]);
                if (!leaves) kept.push_back(k);
            }
            passive.swap(kept);
            if (share >= 1) break;
        }
        r.residual = b - a * r.x;
    }
    return r;
}

std::optional<Eigen::VectorXd> least_distance(const Eigen::MatrixXd& rows, const Eigen::VectorXd& least) {
    constexpr double nearest = 1e-6;  // of the residual, whose last entry is 1 over 1 + the square of the distance
    const Index n = rows.cols();
    ENSURE(least.size() == rows.rows(), "every row has a least value");
    if (least.size() == 0 || !(least.maxCoeff() > 0)) return Eigen::VectorXd::Zero(n);
    const double largest = least.maxCoeff(), row = n > 0 ? rows.rowwise().norm().maxCoeff() : 0;
    if (!(row > 0)) return std::nullopt;
    Eigen::MatrixXd dual(n + 1, rows.rows());
    dual.topRows(n) = rows.transpose() / row;
    dual.row(n) = least.transpose() / largest;
    const std::vector<char> bounded(static_cast<std::size_t>(rows.rows()), 1);
    const Eigen::VectorXd left = nonnegative_least_squares(dual, Eigen::VectorXd::Unit(n + 1, n), bounded).residual;
    if (left[n] <= nearest) return std::nullopt;
    return -largest / (row * left[n]) * left.head(n);
}

}  // namespace abut::solver
