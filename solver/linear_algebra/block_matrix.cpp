// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/block_matrix.hpp"

#include <algorithm>
#include <numeric>

#include "src/base/ensure.hpp"

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

/// Ascending: rows are short, and nearly in order.
void sort_few(int* begin, const int* end) {
    for (int* p = begin; p < end; ++p) {
        const int v = *p;
        int* to = p;
        for (; to > begin && to[-1] > v; --to) *to = to[-1];
        *to = v;
    }
}

}  // namespace

BlockMatrix make_block_matrix(int n, const FunctionSets& coupled) {
    const FunctionSets sets_of = sets_of_functions(n, coupled);
    BlockMatrix m{n, {0}, {}, {}};
    m.first.reserve(index(n) + 1);
    m.column.reserve(2 * coupled.function.size());
    std::vector<int> last_row(index(n), -1);
    for (int row = 0; row < n; ++row) {
        for (int set : sets_of[index(row)])
            for (int column : coupled[index(set)]) {
                if (column > row || last_row[index(column)] == row) continue;
                last_row[index(column)] = row;
                m.column.push_back(column);
            }
        sort_few(m.column.data() + m.first.back(), m.column.data() + m.column.size());
        m.first.push_back(static_cast<int>(m.column.size()));
    }
    m.block.assign(m.column.size(), Eigen::Matrix2d::Zero());
    return m;
}

BlockScatter::BlockScatter(BlockMatrix& matrix, int begin, int end)
    : matrix_(matrix), begin_(begin), end_(end), place_(index(matrix.n), -1) {}

bool BlockScatter::reaches(std::span<const int> functions) const {
    return std::any_of(functions.begin(), functions.end(), [this](int f) { return has(f); });
}

void BlockScatter::add(std::span<const int> functions, const std::vector<Eigen::Matrix2d>& blocks) {
    const std::size_t n = functions.size();
    for (std::size_t j = 0; j < n; ++j) place_[index(functions[j])] = static_cast<int>(j * n);
    for (std::size_t i = 0; i < n; ++i) {
        const int row = functions[i];
        if (!has(row)) continue;
        for (int k = matrix_.first[index(row)]; k < matrix_.first[index(row) + 1]; ++k) {
            const int place = place_[index(matrix_.column[index(k)])];
            if (place >= 0) matrix_.block[index(k)] += blocks[index(place) + i];
        }
    }
    for (int f : functions) place_[index(f)] = -1;
}

Eigen::VectorXd multiply(const BlockMatrix& a, const Eigen::VectorXd& x) {
    ENSURE(x.size() == 2 * a.n, "a function has two coefficients");
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

/// Calls f(block, numbers of its rows, of its columns) row by row.
template <class F>
void for_numbered(const BlockMatrix& a, const std::vector<int>& number, F f) {
    for (int r = 0; r < a.n; ++r) {
        const int* rows = number.data() + 2 * r;
        if (rows[0] < 0 && rows[1] < 0) continue;
        for (int k = a.first[index(r)]; k < a.first[index(r) + 1]; ++k)
            f(a.block[index(k)], rows, number.data() + 2 * a.column[index(k)]);
    }
}

}  // namespace

SparseSymmetric restricted(const BlockMatrix& a, const std::vector<int>& number, int n_kept) {
    ENSURE(number.size() == 2 * index(a.n), "a function has two rows");
    SparseSymmetric s;
    s.n = n_kept;
    s.first.assign(index(n_kept) + 1, 0);
    for_numbered(a, number, [&](const Eigen::Matrix2d&, const int* rows, const int* columns) {
        for (int j : {0, 1}) {
            if (columns[j] < 0) continue;
            s.first[index(columns[j]) + 1] += (rows[0] >= columns[j]) + (rows[1] >= columns[j]);
        }
    });
    std::partial_sum(s.first.begin(), s.first.end(), s.first.begin());
    s.row.resize(index(s.first.back()));
    s.value.resize(s.row.size());
    std::vector<int> next(s.first.begin(), s.first.end() - 1);
    // rows are visited in ascending order, so each column fills in ascending order
    for_numbered(a, number, [&](const Eigen::Matrix2d& block, const int* rows, const int* columns) {
        for (int j : {0, 1}) {
            if (columns[j] < 0) continue;
            int& k = next[index(columns[j])];
            for (int i : {0, 1}) {
                if (rows[i] < columns[j]) continue;
                s.row[index(k)] = rows[i];
                s.value[index(k++)] = block(i, j);
            }
        }
    });
    return s;
}

}  // namespace abut::solver
