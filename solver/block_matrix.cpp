// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/block_matrix.hpp"

#include <algorithm>
#include <numeric>

namespace abut::solver {

namespace {

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

}  // namespace

Eigen::Matrix2d& BlockMatrix::at(int row, int column_index) {
    const auto begin = column.begin() + first[index(row)];
    const auto end = column.begin() + first[index(row) + 1];
    return block[static_cast<std::size_t>(std::lower_bound(begin, end, column_index) - column.begin())];
}

std::span<const int> FunctionSets::operator[](std::size_t set) const {
    return std::span(function).subspan(index(first[set]), index(first[set + 1] - first[set]));
}

void FunctionSets::add(std::span<const int> functions) {
    function.insert(function.end(), functions.begin(), functions.end());
    first.push_back(static_cast<int>(function.size()));
}

namespace {

/// For each function the sets that hold it.
FunctionSets sets_of_functions(int n, const FunctionSets& sets) {
    FunctionSets of{std::vector<int>(index(n) + 1, 0), std::vector<int>(sets.function.size())};
    for (int f : sets.function) ++of.first[index(f) + 1];
    std::partial_sum(of.first.begin(), of.first.end(), of.first.begin());
    std::vector<int> next(of.first.begin(), of.first.end() - 1);
    for (std::size_t s = 0; s < sets.size(); ++s)
        for (int f : sets[s]) of.function[index(next[index(f)]++)] = static_cast<int>(s);
    return of;
}

/// Calls f(row, column) once for every pair, row by row, columns unordered.
template <class F>
void for_coupled_pairs(int n, const FunctionSets& coupled, const FunctionSets& sets_of, F f) {
    std::vector<int> last_row(index(n), -1);
    for (int row = 0; row < n; ++row)
        for (int set : sets_of[index(row)])
            for (int column : coupled[index(set)]) {
                if (column > row || last_row[index(column)] == row) continue;
                last_row[index(column)] = row;
                f(row, column);
            }
}

}  // namespace

BlockMatrix make_block_matrix(int n, const FunctionSets& coupled) {
    const FunctionSets sets_of = sets_of_functions(n, coupled);
    BlockMatrix m{n, std::vector<int>(index(n) + 1, 0), {}, {}};
    for_coupled_pairs(n, coupled, sets_of, [&](int row, int) { ++m.first[index(row) + 1]; });
    std::partial_sum(m.first.begin(), m.first.end(), m.first.begin());
    m.column.reserve(index(m.first.back()));
    for_coupled_pairs(n, coupled, sets_of, [&](int, int column) { m.column.push_back(column); });
    for (int row = 0; row < n; ++row)
        std::sort(m.column.begin() + m.first[index(row)], m.column.begin() + m.first[index(row) + 1]);
    m.block.assign(m.column.size(), Eigen::Matrix2d::Zero());
    return m;
}

BlockScatter::BlockScatter(BlockMatrix& matrix) : matrix_(matrix), place_(index(matrix.n), -1) {}

void BlockScatter::add(std::span<const int> functions, const std::vector<Eigen::Matrix2d>& blocks) {
    const std::size_t n = functions.size();
    for (std::size_t j = 0; j < n; ++j) place_[index(functions[j])] = static_cast<int>(j * n);
    for (std::size_t i = 0; i < n; ++i) {
        const int row = functions[i];
        for (int k = matrix_.first[index(row)]; k < matrix_.first[index(row) + 1]; ++k) {
            const int place = place_[index(matrix_.column[index(k)])];
            if (place >= 0) matrix_.block[index(k)] += blocks[index(place) + i];
        }
    }
    for (int f : functions) place_[index(f)] = -1;
}

Eigen::VectorXd multiply(const BlockMatrix& a, const Eigen::VectorXd& x) {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(2 * a.n);
    for (int r = 0; r < a.n; ++r)
        for (int k = a.first[index(r)]; k < a.first[index(r) + 1]; ++k) {
            const int c = a.column[index(k)];
            const Eigen::Matrix2d& b = a.block[index(k)];
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
        for (int k = a.first[index(r)]; k < a.first[index(r) + 1]; ++k)
            for (int i = 0; i < 2; ++i)
                for (int j = 0; j < 2; ++j) {
                    const int row = number[index(2 * r + i)];
                    const int col = number[index(2 * a.column[index(k)] + j)];
                    if (col >= 0 && row >= col) f(row, col, a.block[index(k)](i, j));
                }
}

}  // namespace

SparseSymmetric restricted(const BlockMatrix& a, const std::vector<int>& number, int n_kept) {
    SparseSymmetric s;
    s.n = n_kept;
    s.first.assign(index(n_kept) + 1, 0);
    for_kept(a, number, [&](int, int col, double) { ++s.first[index(col) + 1]; });
    std::partial_sum(s.first.begin(), s.first.end(), s.first.begin());
    s.row.resize(index(s.first.back()));
    s.value.resize(s.row.size());
    std::vector<int> next(s.first.begin(), s.first.end() - 1);
    // rows are visited in ascending order, so each column fills in ascending order
    for_kept(a, number, [&](int row, int col, double value) {
        const auto k = index(next[index(col)]++);
        s.row[k] = row;
        s.value[k] = value;
    });
    return s;
}

}  // namespace abut::solver
