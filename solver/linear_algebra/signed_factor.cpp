// SPDX-License-Identifier: GPL-3.0-or-later
// Legend: s the supernode at hand, d one before it that has rows among its columns; "local": numbered within s. Left-looking as
// in CHOLMOD's supernodal Cholesky factorisation, from where the structure comes.
#include "solver/linear_algebra/signed_factor.hpp"

#include <algorithm>
#include <cmath>

#include "solver/linear_algebra/blas.hpp"
#include "src/base/index.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::Map;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Block = Map<MatrixXd, 0, Eigen::OuterStride<>>;
using ConstBlock = Map<const MatrixXd, 0, Eigen::OuterStride<>>;

constexpr int panel_width = 48;  // columns that are eliminated one by one before their product is taken off the others

/// c -= a b'.
void subtract_product(const ConstBlock& a, const MatrixXd& b, Block c) {
    const int m = static_cast<int>(a.rows()), n = static_cast<int>(b.rows()), k = static_cast<int>(b.cols());
    const int lda = static_cast<int>(a.outerStride()), ldb = static_cast<int>(b.rows()),
              ldc = static_cast<int>(c.outerStride());
    const double minus = -1, one = 1;
    if (m > 0 && n > 0) dgemm_("N", "T", &m, &n, &k, &minus, a.data(), &lda, b.data(), &ldb, &one, c.data(), &ldc);
}

/// L S L' of the leading square of `a` within columns [begin, end), by columns. Result: local column that failed, or -1.
int factor_columns(Block& a, int begin, int end, const VectorXd& sign) {
    for (int k = begin; k < end; ++k) {
        double pivot = sign[k] * a(k, k);
        for (int j = begin; j < k; ++j) pivot -= sign[k] * sign[j] * a(k, j) * a(k, j);
        if (!(pivot > 0)) return k;
        a(k, k) = std::sqrt(pivot);
        for (int j = begin; j < k; ++j)
            a.block(k + 1, k, end - k - 1, 1) -= sign[j] * a(k, j) * a.block(k + 1, j, end - k - 1, 1);
        a.block(k + 1, k, end - k - 1, 1) *= sign[k] / a(k, k);
    }
    return -1;
}

/// The same of a whole supernode (rows x width), panel by panel, its rows below included.
int factor_supernode(Block a, const VectorXd& sign) {
    const int width = static_cast<int>(a.cols()), rows = static_cast<int>(a.rows()), lda = static_cast<int>(a.outerStride());
    const double one = 1;
    for (int begin = 0; begin < width; begin += panel_width) {
        const int end = std::min(begin + panel_width, width), n = end - begin, below = rows - end;
        const int failed = factor_columns(a, begin, end, sign);
        if (failed >= 0) return failed;
        if (below == 0) continue;
        dtrsm_("R", "L", "T", "N", &below, &n, &one, &a(begin, begin), &lda, &a(end, begin), &lda);
        a.block(end, begin, below, n) *= sign.segment(begin, n).asDiagonal();
        const MatrixXd signed_rows = a.block(end, begin, width - end, n) * sign.segment(begin, n).asDiagonal();
        subtract_product({&a(end, begin), below, n, Eigen::OuterStride<>(lda)}, signed_rows,
                         {a.data() + end + static_cast<Index>(end) * lda, below, width - end, Eigen::OuterStride<>(lda)});
    }
    return -1;
}

/// The factorisation under way.
class Elimination {
public:
    Elimination(const SparseSymmetric& matrix, const SupernodePattern& pattern, const VectorXd& sign,
                std::vector<double>& values)
        : matrix_(matrix),
          pattern_(pattern),
          sign_(sign),
          values_(values),
          position_(at(matrix.n)),
          supernode_of_(at(matrix.n)),
          local_(at(matrix.n), -1),
          waiting_(at(pattern.count()), -1),
          next_(waiting_),
          first_left_(waiting_) {
        for (int k = 0; k < matrix.n; ++k) position_[at(pattern.order[at(k)])] = k;
        for (int s = 0; s < pattern.count(); ++s)
            for (int k = pattern.first_column[at(s)]; k < pattern.first_column[at(s) + 1]; ++k) supernode_of_[at(k)] = s;
    }

    /// Position at which it ended, or -1.
    int run() {
        scatter_matrix();
        for (int s = 0; s < pattern_.count(); ++s) {
            const Supernode node = pattern_[s];
            for (int i = 0; i < node.rows; ++i) local_[at(node.row[i])] = i;
            for (int d = waiting_[at(s)]; d >= 0;) {
                const int after = next_[at(d)];
                take_off(d, node);
                d = after;
            }
            const int failed = factor_supernode(block(node), sign_.segment(node.begin, node.width));
            if (failed >= 0) return node.begin + failed;
            first_left_[at(s)] = node.width;
            hand_on(s, node);
        }
        return -1;
    }

private:
    Block block(const Supernode& node) {
        return {values_.data() + node.first_value, node.rows, node.width, Eigen::OuterStride<>(node.rows)};
    }

    void scatter_matrix() {
        for (int c = 0; c < matrix_.n; ++c)
            for (int k = matrix_.first[at(c)]; k < matrix_.first[at(c) + 1]; ++k) {
                const int a = position_[at(c)], b = position_[at(matrix_.row[at(k)])];
                const Supernode node = pattern_[supernode_of_[at(std::min(a, b))]];
                const int* row = std::lower_bound(node.row, node.row + node.rows, std::max(a, b));
                values_[at(node.first_value + (std::min(a, b) - node.begin) * node.rows) +
                        at(static_cast<int>(row - node.row))] = matrix_.value[at(k)];
            }
    }

    /// Takes the product of the rows of d that lie in s off the block of s.
    void take_off(int d, const Supernode& s) {
        const Supernode from = pattern_[d];
        const int begin = first_left_[at(d)];
        int end = begin;
        while (end < from.rows && from.row[end] < s.begin + s.width) ++end;
        const ConstBlock rows(values_.data() + from.first_value + begin, from.rows - begin, from.width,
                              Eigen::OuterStride<>(from.rows));
        const MatrixXd signed_rows = rows.topRows(end - begin) * sign_.segment(from.begin, from.width).asDiagonal();
        product_.setZero(rows.rows(), end - begin);
        subtract_product(rows, signed_rows,
                         {product_.data(), product_.rows(), product_.cols(), Eigen::OuterStride<>(product_.rows())});
        Block to = block(s);
        for (int j = begin; j < end; ++j)
            for (int i = j; i < from.rows; ++i)
                to(local_[at(from.row[i])], from.row[j] - s.begin) += product_(i - begin, j - begin);
        first_left_[at(d)] = end;
        hand_on(d, from);
    }

    /// Puts d on the list of the supernode that its next row belongs to.
    void hand_on(int d, const Supernode& from) {
        if (first_left_[at(d)] == from.rows) return;
        const int to = supernode_of_[at(from.row[first_left_[at(d)]])];
        next_[at(d)] = waiting_[at(to)];
        waiting_[at(to)] = d;
    }

    const SparseSymmetric& matrix_;
    const SupernodePattern& pattern_;
    const VectorXd& sign_;
    std::vector<double>& values_;
    std::vector<int> position_, supernode_of_, local_, waiting_, next_, first_left_;
    MatrixXd product_;
};

}  // namespace

SignedFactor::SignedFactor(const SparseSymmetric& matrix, const SupernodalStructure& structure, const std::vector<double>& sign)
    : structure_(structure), sign_(matrix.n), values_(static_cast<std::size_t>(structure.entries()), 0.0) {
    const SupernodePattern pattern = structure_.pattern();
    for (int k = 0; k < matrix.n; ++k) sign_[k] = sign[at(pattern.order[at(k)])];
    const int failed = Elimination(matrix, pattern, sign_, values_).run();
    if (failed >= 0) failed_at_ = pattern.order[at(failed)];
}

Supernodes SignedFactor::supernodes() const {
    return {structure_.pattern(), values_.data(), sign_.data()};
}

}  // namespace abut::solver
