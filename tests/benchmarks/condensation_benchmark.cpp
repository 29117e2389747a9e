// SPDX-License-Identifier: GPL-3.0-or-later
// Condensation to the multipliers alone: C = D K^-1 D' of one part's factor, rows along one side of a square plate.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "solver/parts/part_system.hpp"
#include "tests/benchmarks/benchmark_scenes.hpp"

namespace abut::benchmarks {
namespace {

constexpr int degree = 2;

/// Cells each way for so many unknowns of the plate, whose hole takes a fifth of it.
int cells_for(double unknowns) {
    return static_cast<int>(std::lround(std::sqrt(unknowns / 2 / 0.8)));
}

/// The first few coefficients held.
solver::SparseSymmetric held(const solver::BlockMatrix& k) {
    constexpr int n_held = 6;
    std::vector<int> number(static_cast<std::size_t>(2 * k.n), -1);
    std::iota(number.begin() + n_held, number.end(), 0);
    return restricted(k, number, 2 * k.n - n_held);
}

/// m rows, each of three neighbouring functions' y components; functions are numbered along the grid's rows, so that the last
/// ones lie along the upper side.
Eigen::SparseMatrix<double> rows_on_upper_side(int n, int m, int side) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int row = 0; row < m; ++row)
        for (int k = 0; k < 3; ++k) {
            const int function = n / 2 - side + (row * (side - 3)) / m + k;
            entries.emplace_back(2 * function + 1, row, k == 1 ? 0.5 : 0.25);
        }
    Eigen::SparseMatrix<double> columns(n, m);
    columns.setFromTriplets(entries.begin(), entries.end());
    return columns;
}

/// Arguments: thousands of unknowns, multipliers.
void Condense(benchmark::State& state) {
    const int side = cells_for(1e3 * static_cast<double>(state.range(0))), m = static_cast<int>(state.range(1));
    const Scene plate = plate_with_hole();
    const solver::SparseSymmetric matrix = held(assemble_stiffness(plate_on_grid(plate, side, degree).input));
    const Eigen::SparseMatrix<double> columns = rows_on_upper_side(matrix.n, m, side);
    const solver::Factorization factor(matrix);
    for (auto _ : state) benchmark::DoNotOptimize(factor.inverse_form(columns));
    state.counters["unknowns"] = matrix.n;
    state.SetComplexityN(matrix.n);
}
void by_unknowns(benchmark::internal::Benchmark* b) {
    b->ArgNames({"thousands", "multipliers"})->ArgsProduct({{3, 10, 30, 100}, {50}});
    b->Unit(benchmark::kMillisecond)->Complexity();
}
void by_multipliers(benchmark::internal::Benchmark* b) {
    b->ArgNames({"thousands", "multipliers"})->ArgsProduct({{30}, {10, 25, 100, 200}})->Unit(benchmark::kMillisecond);
}
BENCHMARK(Condense)->Apply(by_unknowns);
BENCHMARK(Condense)->Apply(by_multipliers);

}  // namespace
}  // namespace abut::benchmarks
