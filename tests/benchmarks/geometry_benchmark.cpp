// SPDX-License-Identifier: GPL-3.0-or-later
// Classification of cells and their quadrature rules: cost per cell and per cut cell.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "geometry/quadrature/quadrature.hpp"
#include "tests/benchmarks/benchmark_scenes.hpp"

namespace abut::benchmarks {
namespace {

double n_cut(const geometry::CutCells& cells) {
    return static_cast<double>(std::count(cells.cell_class.begin(), cells.cell_class.end(), geometry::CellClass::boundary));
}

void count_cells(benchmark::State& state, const geometry::CutCells& cells) {
    state.counters["cells"] = static_cast<double>(cells.cell_class.size());
    state.counters["cut"] = n_cut(cells);
    state.counters["s/cut"] =
        benchmark::Counter(n_cut(cells), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Argument: cells each way.
void CutCells(benchmark::State& state) {
    const Scene plate = plate_with_hole();
    const geometry::Grid grid = plate_grid(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(geometry::cut_cells(plate.parts[0].part, grid));
    count_cells(state, geometry::cut_cells(plate.parts[0].part, grid));
}
BENCHMARK(CutCells)->RangeMultiplier(4)->Range(16, 256);

/// Arguments: cells each way, degree.
void CellRules(benchmark::State& state) {
    const Scene plate = plate_with_hole();
    const geometry::CutCells cells = geometry::cut_cells(plate.parts[0].part, plate_grid(static_cast<int>(state.range(0))));
    const int degree = static_cast<int>(state.range(1));
    for (auto _ : state) benchmark::DoNotOptimize(cell_rules(plate.parts[0].part, cells, degree));
    count_cells(state, cells);
}
BENCHMARK(CellRules)->ArgsProduct({{16, 64}, {1, 2, 3}});

}  // namespace
}  // namespace abut::benchmarks
