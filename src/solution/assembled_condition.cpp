// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/solution/assembled_condition.hpp"

#include <algorithm>

#include "src/base/index.hpp"

namespace abut {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Rows and columns of the matrix over all parts, by part and coefficient; -1 where a coefficient is dropped. Nothing is pinned
/// here: contact holds what supports leave free.
std::vector<std::vector<int>> numbers_of(const SolvedAssembly& solved, int& n) {
    std::vector<std::vector<int>> numbers;
    for (const solver::PartSystem& system : solved.problem.parts) {
        numbers.emplace_back(system.dropped.size(), -1);
        for (std::size_t i = 0; i < system.dropped.size(); ++i)
            if (!system.dropped[i]) numbers.back()[i] = n++;
    }
    return numbers;
}

void add_lower(Triplets& to, int i, int j, double value) {
    to.emplace_back(std::max(i, j), std::min(i, j), value);
}

void add_stiffness(const solver::PartSystem& system, const std::vector<int>& number, Triplets& to) {
    const int first = *std::find_if(number.begin(), number.end(), [](int k) { return k >= 0; });
    std::vector<int> own = number;
    int n = 0;
    for (int& k : own)
        if (k >= 0) k = n++;
    const solver::SparseSymmetric a = restricted(system.stiffness, own, n);
    for (int c = 0; c < a.n; ++c)
        for (int k = a.first[at(c)]; k < a.first[at(c) + 1]; ++k)
            add_lower(to, first + a.row[at(k)], first + c, a.value[at(k)]);
}

/// Which rows carry pressure.
std::vector<char> closed_rows(const SolvedAssembly& solved, const std::vector<int>& first_row, int n_rows) {
    std::vector<char> closed(at(n_rows), 0);
    for (std::size_t f = 0; f < solved.problem.interfaces.size(); ++f) {
        const solver::Interface& face = solved.problem.interfaces[f];
        for (std::size_t q = 0; q < face.points.size(); ++q)
            closed[at(first_row[f]) + q] = pressure_at(face.pressure, solved.solution.pressure[f], face.points[q].s) > 0;
    }
    return closed;
}

/// D'D / softness of the closed rows.
void add_penalties(const SolvedAssembly& solved, const std::vector<std::vector<int>>& numbers, Triplets& to) {
    std::vector<int> first_row;
    const solver::Rows rows = interface_rows(solved.problem.parts, solved.problem.interfaces, first_row);
    const std::vector<char> closed = closed_rows(solved, first_row, rows.n);
    std::vector<std::vector<std::pair<int, double>>> of_row(at(rows.n));
    for (std::size_t part = 0; part < rows.by_part.size(); ++part)
        for (const solver::RowEntry& e : rows.by_part[part])
            if (closed[at(e.row)] && numbers[part][at(e.coefficient)] >= 0)
                of_row[at(e.row)].emplace_back(numbers[part][at(e.coefficient)], e.value);
    for (std::size_t r = 0; r < of_row.size(); ++r)
        for (const auto& [i, a] : of_row[r])
            for (const auto& [j, b] : of_row[r])
                if (i >= j) add_lower(to, i, j, a * b / rows.softness[static_cast<Eigen::Index>(r)]);
}

solver::SparseSymmetric sparse_of(const Triplets& entries, int n) {
    Eigen::SparseMatrix<double> lower(n, n);
    lower.setFromTriplets(entries.begin(), entries.end());
    solver::SparseSymmetric a;
    a.n = n;
    a.first.assign(lower.outerIndexPtr(), lower.outerIndexPtr() + n + 1);
    a.row.assign(lower.innerIndexPtr(), lower.innerIndexPtr() + lower.nonZeros());
    a.value.assign(lower.valuePtr(), lower.valuePtr() + lower.nonZeros());
    return a;
}

bool is_by_penalty(const SolvedAssembly& solved) {
    const auto& faces = solved.problem.interfaces;
    return std::all_of(faces.begin(), faces.end(), [](const solver::Interface& f) { return !f.penalty.empty(); });
}

}  // namespace

std::optional<double> assembled_condition(const SolvedAssembly& solved) {
    const auto& parts = solved.problem.parts;
    const bool is_solved = solved.failure.empty() && solved.solution.mechanism.empty() && !parts.empty();
    const bool has_rigid = std::any_of(parts.begin(), parts.end(), [](const solver::PartSystem& s) { return !!s.body; });
    if (!is_solved || has_rigid || !is_by_penalty(solved)) return std::nullopt;
    int n = 0;
    const std::vector<std::vector<int>> numbers = numbers_of(solved, n);
    Triplets entries;
    for (std::size_t part = 0; part < parts.size(); ++part) add_stiffness(parts[part], numbers[part], entries);
    if (!solved.problem.interfaces.empty()) add_penalties(solved, numbers, entries);
    const solver::Factorization factor(sparse_of(entries, n));
    if (!factor.ok()) return std::nullopt;
    return factor.unscaled_condition_one();
}

}  // namespace abut
