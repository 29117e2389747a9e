// SPDX-License-Identifier: GPL-3.0-or-later
// The dictionary: basic = rhs + table * nonbasic, the covering variable among them. Variables: w_i is i, z_i is n + i, the
// covering one 2n.
#include "solver/linear_algebra/complementarity.hpp"

#include <cmath>
#include <numeric>
#include <vector>

#include "src/base/ensure.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double least_pivot = 1e-11;  // of the largest entry of the column
constexpr int pivots_a_row = 6;

class Dictionary {
public:
    Dictionary(const MatrixXd& m, const VectorXd& q) : n_(q.size()), table_(n_, n_ + 2) {
        table_ << q, m, VectorXd::Ones(n_);
        for (Index i = 0; i < n_; ++i) basic_.push_back(i);
        for (Index j = 0; j <= n_; ++j) nonbasic_.push_back(n_ + j);
    }

    Index covering() const { return 2 * n_; }
    Index complement(Index variable) const { return variable < n_ ? variable + n_ : variable - n_; }
    const std::vector<Index>& basic() const { return basic_; }
    double value(Index row) const { return table_(row, 0); }

    /// Exchanges the basic variable of a row with a nonbasic one, and says which left the basis.
    Index exchange(Index row, Index entering) {
        Index column = 0;
        while (nonbasic_[static_cast<std::size_t>(column)] != entering) ++column;
        const Index c = column + 1;
        const double pivot = table_(row, c);
        Eigen::RowVectorXd solved = table_.row(row) / -pivot;
        solved[c] = 1 / pivot;
        const VectorXd factor = table_.col(c);
        table_.col(c).setZero();
        table_.row(row).setZero();
        table_.noalias() += factor * solved;
        table_.row(row) = solved;
        std::swap(basic_[static_cast<std::size_t>(row)], nonbasic_[static_cast<std::size_t>(column)]);
        return nonbasic_[static_cast<std::size_t>(column)];
    }

    /// The row whose variable is the first to fall to zero as `entering` grows; the covering one where it ties. -1: none falls.
    Index blocking(Index entering) const {
        Index column = 0;
        while (nonbasic_[static_cast<std::size_t>(column)] != entering) ++column;
        const auto rate = table_.col(column + 1);
        const double least = least_pivot * rate.cwiseAbs().maxCoeff();
        Index best = -1;
        double reach = 0;
        for (Index i = 0; i < n_; ++i) {
            if (rate[i] >= -least) continue;
            const double t = table_(i, 0) / -rate[i];
            if (best >= 0 && t > reach) continue;
            if (best >= 0 && t == reach && basic_[static_cast<std::size_t>(i)] != covering()) continue;
            best = i;
            reach = t;
        }
        return best;
    }

private:
    Index n_;
    MatrixXd table_;
    std::vector<Index> basic_, nonbasic_;
};

/// Fractions between 1/2 and 1 that no two rows share.
double spread(Index row) {
    constexpr double golden = 0.6180339887498949;
    const double x = golden * static_cast<double>(row + 1);
    return 0.5 + 0.5 * (x - std::floor(x));
}

}  // namespace

std::optional<VectorXd> complementary(const MatrixXd& matrix, const VectorXd& q) {
    const Index n = q.size();
    ENSURE(matrix.rows() == n && matrix.cols() == n, "every row has a variable and a constant");
    VectorXd z = VectorXd::Zero(n);
    if (n == 0) return z;
    VectorXd moved = q;
    const double trifle = tie_fraction * q.cwiseAbs().maxCoeff();
    for (Index i = 0; i < n; ++i) moved[i] += trifle * spread(i);
    Index row = 0;
    if (moved.minCoeff(&row) >= 0) return z;
    Dictionary dictionary(matrix, moved);
    Index left = dictionary.exchange(row, dictionary.covering());
    for (Index step = 0; step < pivots_a_row * n && left != dictionary.covering(); ++step) {
        const Index entering = dictionary.complement(left);
        row = dictionary.blocking(entering);
        if (row < 0) return std::nullopt;
        left = dictionary.exchange(row, entering);
    }
    if (left != dictionary.covering()) return std::nullopt;
    for (Index i = 0; i < n; ++i)
        if (const Index variable = dictionary.basic()[static_cast<std::size_t>(i)]; variable >= n)
            z[variable - n] = dictionary.value(i);
    return z;
}

}  // namespace abut::solver
