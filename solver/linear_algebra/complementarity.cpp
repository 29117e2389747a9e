// SPDX-License-Identifier: GPL-3.0-or-later
// The dictionary: basic = rhs + table * nonbasic, the covering variable among them. Variables: w_i is i, z_i is n + i, the
// covering one 2n. A search from an expected set of positive z begins at the dictionary in which these are basic.
#include "solver/linear_algebra/complementarity.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/linear_algebra/dense.hpp"
#include "src/base/ensure.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double least_pivot = 1e-11;  // of the largest entry of the column
/// Before a path is given up; most take n pivots as loads grow, 5 n otherwise, fewer from an expected set.
constexpr int pivots_a_row = 6, pivots_a_row_as_loads_grow = 2, pivots_a_row_near = 1;
constexpr Index most_rows_from_nothing = 600;  // of more it takes ten seconds and more to find out that there is no way
constexpr Index exchanges_together = 32;       // so many are one product of matrices: the table is passed through less

std::size_t of(Index i) {
    return static_cast<std::size_t>(i);
}

/// The table is known as table_ + columns_ * rows_, the last exchanges being in these.
class Dictionary {
public:
    Dictionary(MatrixXd table, std::vector<Index> basic)
        : n_(table.rows()),
          table_(std::move(table)),
          columns_(n_, exchanges_together),
          rows_(exchanges_together, n_ + 2),
          basic_(std::move(basic)) {
        for (Index variable : basic_) nonbasic_.push_back(complement(variable));
        nonbasic_.push_back(covering());
    }

    Index covering() const { return 2 * n_; }
    Index complement(Index variable) const { return variable < n_ ? variable + n_ : variable - n_; }
    const std::vector<Index>& basic() const { return basic_; }
    VectorXd values() const { return column(0); }

    /// Exchanges the basic variable of a row with a nonbasic one, and says which left the basis.
    Index exchange(Index row, Index entering) {
        const Index c = column_of(entering);
        VectorXd factor = column(c);
        const double pivot = factor[row];
        VectorXd solved = this->row(row) / -pivot;
        solved[c] = 1 / pivot;
        factor[row] = 1;
        table_.col(c).setZero();
        table_.row(row).setZero();
        columns_.row(row).setZero();
        rows_.col(c).setZero();
        columns_.col(kept_) = factor;
        rows_.row(kept_) = solved.transpose();
        if (++kept_ == exchanges_together) {
            add_product(columns_, rows_, table_);
            kept_ = 0;
        }
        std::swap(basic_[of(row)], nonbasic_[of(c - 1)]);
        return nonbasic_[of(c - 1)];
    }

    /// The row whose variable is the first to fall to zero as `entering` grows; the covering one where it ties. -1: none falls.
    Index blocking(Index entering) const {
        const VectorXd rate = column(column_of(entering)), value = values();
        const double least = least_pivot * rate.cwiseAbs().maxCoeff();
        Index best = -1;
        double first = 0;
        for (Index i = 0; i < n_; ++i) {
            if (rate[i] >= -least) continue;
            const double t = value[i] / -rate[i];
            if (best >= 0 && t > first) continue;
            if (best >= 0 && t == first && basic_[of(i)] != covering()) continue;
            best = i;
            first = t;
        }
        return best;
    }

private:
    VectorXd column(Index c) const { return table_.col(c) + columns_.leftCols(kept_) * rows_.col(c).head(kept_); }
    VectorXd row(Index r) const {
        return table_.row(r).transpose() + rows_.topRows(kept_).transpose() * columns_.row(r).head(kept_).transpose();
    }
    Index column_of(Index nonbasic) const {
        return 1 + (std::find(nonbasic_.begin(), nonbasic_.end(), nonbasic) - nonbasic_.begin());
    }

    Index n_, kept_ = 0;
    MatrixXd table_, columns_, rows_;
    std::vector<Index> basic_, nonbasic_;
};

/// Fractions between 1/2 and 1 that no two rows share.
double spread(Index row) {
    constexpr double golden = 0.6180339887498949;
    const double x = golden * static_cast<double>(row + 1);
    return 0.5 + 0.5 * (x - std::floor(x));
}

/// (q, M) of w = M z + q with the z of a set basic in place of their w; nothing where the set does not determine them.
std::optional<MatrixXd> exchanged(const MatrixXd& m, const VectorXd& q, const std::vector<char>& positive) {
    std::vector<Index> in, out;
    for (std::size_t i = 0; i < positive.size(); ++i) (positive[i] ? in : out).push_back(static_cast<Index>(i));
    const Index n = q.size(), basic = static_cast<Index>(in.size());
    std::vector<Index> columns = {0};  // q, then what belongs to rows that are not exchanged
    for (Index j : out) columns.push_back(j + 1);
    MatrixXd all(n, n + 1);
    all << q, m;
    MatrixXd right(basic, basic + static_cast<Index>(columns.size()));
    right << MatrixXd::Identity(basic, basic), -all(in, columns);
    const std::optional<MatrixXd> solved = solve_square_columns(m(in, in), right);
    if (!solved) return std::nullopt;
    const MatrixXd coupling = product(m(out, in), *solved);
    MatrixXd exchanged(n, n + 1);
    for (Index j = 0; j < basic; ++j) {
        exchanged(in, Eigen::all).col(in[of(j)] + 1) = solved->col(j);
        exchanged(out, Eigen::all).col(in[of(j)] + 1) = coupling.col(j);
    }
    exchanged(in, columns) = solved->rightCols(static_cast<Index>(columns.size()));
    exchanged(out, columns) = all(out, columns) + coupling.rightCols(static_cast<Index>(columns.size()));
    return exchanged;
}

/// Lemke's pivots from a dictionary (values, table) whose basic variables are given. cover: the covering variable's column.
std::optional<VectorXd> pivoted(MatrixXd table, const VectorXd& cover, std::vector<Index> basic, Index most_pivots) {
    const Index n = table.rows();
    VectorXd z = VectorXd::Zero(n);
    const auto write = [&](const std::vector<Index>& variables, const VectorXd& values) {
        for (Index i = 0; i < n; ++i)
            if (variables[of(i)] >= n) z[variables[of(i)] - n] = values[i];
        return z;
    };
    Index row = -1;
    double worst = 0;
    for (Index i = 0; i < n; ++i)
        if (const double lacks = -table(i, 0) / cover[i]; table(i, 0) < 0 && lacks > worst) {
            row = i;
            worst = lacks;
        }
    if (row < 0) return write(basic, table.col(0));
    table.conservativeResize(n, n + 2);
    table.col(n + 1) = cover;
    Dictionary dictionary(std::move(table), std::move(basic));
    Index left = dictionary.exchange(row, dictionary.covering());
    for (Index step = 0; step < most_pivots && left != dictionary.covering(); ++step) {
        const Index entering = dictionary.complement(left);
        row = dictionary.blocking(entering);
        if (row < 0) return std::nullopt;
        left = dictionary.exchange(row, entering);
    }
    if (left != dictionary.covering()) return std::nullopt;
    return write(dictionary.basic(), dictionary.values());
}

}  // namespace

std::optional<VectorXd> complementary(const MatrixXd& matrix, const VectorXd& q, const std::vector<char>& positive,
                                      const VectorXd& ties) {
    const Index n = q.size();
    ENSURE(matrix.rows() == n && matrix.cols() == n, "every row has a variable and a constant");
    ENSURE(positive.empty() || static_cast<Index>(positive.size()) == n, "every variable is expected or not, or none is");
    ENSURE(ties.size() == 0 || ties.size() == n, "every row has its share of the trifle, or none has");
    if (n == 0) return VectorXd::Zero(0);
    VectorXd moved = q;
    const double largest = q.cwiseAbs().maxCoeff(), trifle = tie_fraction * largest;
    if (largest == 0) return VectorXd::Zero(n);
    for (Index i = 0; i < n; ++i) moved[i] += (ties.size() > 0 ? ties[i] : 1) * trifle * spread(i);
    std::vector<Index> basic(of(n));
    for (Index i = 0; i < n; ++i) basic[of(i)] = !positive.empty() && positive[of(i)] ? n + i : i;
    if (!positive.empty())
        if (std::optional<MatrixXd> table = exchanged(matrix, moved, positive))
            if (auto z = pivoted(std::move(*table), VectorXd::Ones(n), basic, pivots_a_row_near * n)) return z;
    if (n > most_rows_from_nothing) return std::nullopt;
    for (Index i = 0; i < n; ++i) basic[of(i)] = i;
    MatrixXd table(n, n + 1);
    table << moved, matrix;
    // from nothing: what all rows lack is given way to at one rate, as if loads grew; what that does not find, others may
    if (auto z = pivoted(table, (-q).cwiseMax(0) / largest, basic, pivots_a_row_as_loads_grow * n)) return z;
    return pivoted(std::move(table), VectorXd::Ones(n), std::move(basic), pivots_a_row * n);
}

}  // namespace abut::solver
