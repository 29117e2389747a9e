// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/block_matrix.hpp"

#include <algorithm>

namespace abut::solver {

Eigen::Matrix2d& BlockMatrix::at(int row, int column_index) {
    const auto begin = column.begin() + first[static_cast<std::size_t>(row)];
    const auto end = column.begin() + first[static_cast<std::size_t>(row) + 1];
    return block[static_cast<std::size_t>(std::lower_bound(begin, end, column_index) - column.begin())];
}

BlockMatrix make_block_matrix(int n, const std::vector<std::vector<int>>& coupled) {
    std::vector<std::vector<int>> rows(static_cast<std::size_t>(n));
    for (const auto& set : coupled)
        for (int a : set)
            for (int b : set)
                if (b <= a) rows[static_cast<std::size_t>(a)].push_back(b);
    BlockMatrix m;
    m.n = n;
    m.first.push_back(0);
    for (auto& row : rows) {
        std::sort(row.begin(), row.end());
        row.erase(std::unique(row.begin(), row.end()), row.end());
        m.column.insert(m.column.end(), row.begin(), row.end());
        m.first.push_back(static_cast<int>(m.column.size()));
    }
    m.block.assign(m.column.size(), Eigen::Matrix2d::Zero());
    return m;
}

Eigen::VectorXd multiply(const BlockMatrix& a, const Eigen::VectorXd& x) {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(2 * a.n);
    for (int r = 0; r < a.n; ++r)
        for (int k = a.first[static_cast<std::size_t>(r)]; k < a.first[static_cast<std::size_t>(r) + 1]; ++k) {
            const int c = a.column[static_cast<std::size_t>(k)];
            const Eigen::Matrix2d& b = a.block[static_cast<std::size_t>(k)];
            y.segment<2>(2 * r) += b * x.segment<2>(2 * c);
            if (c != r) y.segment<2>(2 * c) += b.transpose() * x.segment<2>(2 * r);
        }
    return y;
}

namespace {

/// Calls f(row, column, value) for every entry of the lower triangle that is kept.
template <class F>
void for_kept(const BlockMatrix& a, const std::vector<int>& number, F f) {
    for (int r = 0; r < a.n; ++r)
        for (int k = a.first[static_cast<std::size_t>(r)]; k < a.first[static_cast<std::size_t>(r) + 1]; ++k)
            for (int i = 0; i < 2; ++i)
                for (int j = 0; j < 2; ++j) {
                    const int row = number[static_cast<std::size_t>(2 * r + i)];
                    const int col = number[static_cast<std::size_t>(2 * a.column[static_cast<std::size_t>(k)] + j)];
                    if (col >= 0 && row >= col) f(row, col, a.block[static_cast<std::size_t>(k)](i, j));
                }
}

}  // namespace

SparseSymmetric restricted(const BlockMatrix& a, const std::vector<int>& number, int n_kept) {
    SparseSymmetric s;
    s.n = n_kept;
    s.first.assign(static_cast<std::size_t>(n_kept) + 1, 0);
    for_kept(a, number, [&](int, int col, double) { ++s.first[static_cast<std::size_t>(col) + 1]; });
    for (std::size_t c = 0; c < static_cast<std::size_t>(n_kept); ++c) s.first[c + 1] += s.first[c];
    s.row.resize(static_cast<std::size_t>(s.first.back()));
    s.value.resize(s.row.size());
    std::vector<int> next(s.first.begin(), s.first.end() - 1);
    // rows are visited in ascending order, so each column fills in ascending order
    for_kept(a, number, [&](int row, int col, double value) {
        const auto k = static_cast<std::size_t>(next[static_cast<std::size_t>(col)]++);
        s.row[k] = row;
        s.value[k] = value;
    });
    return s;
}

}  // namespace abut::solver
