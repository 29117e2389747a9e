// SPDX-License-Identifier: GPL-3.0-or-later
// Rules of cut cells and of the boundary by kind of edge, in growing numbers of edges on a grid that grows with them: about one
// edge in a cut cell.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "geometry/quadrature/quadrature.hpp"
#include "tests/benchmarks/wheel.hpp"

namespace abut::benchmarks {
namespace {

using namespace geometry;

constexpr int degree = 2;

struct CutWheel {
    Part part;
    CutCells cells;

    explicit CutWheel(const benchmark::State& state)
        : part(wheel(static_cast<EdgeKind>(state.range(0)), static_cast<int>(state.range(1)))),
          cells(cut_cells(part, grid_around(part, static_cast<int>(state.range(1)) / 4))) {}
};

void count(benchmark::State& state, const CutWheel& cut) {
    state.counters["cut"] = static_cast<double>(std::ranges::count(cut.cells.cell_class, CellClass::boundary));
    state.SetComplexityN(state.range(1));
}

void RulesOfCutCells(benchmark::State& state) {
    const CutWheel cut(state);
    for (auto _ : state) benchmark::DoNotOptimize(cell_rules(cut.part, cut.cells, degree));
    count(state, cut);
}

void RulesOfBoundary(benchmark::State& state) {
    const CutWheel cut(state);
    const int n_edges = static_cast<int>(cut.part.edges.size());
    for (auto _ : state)
        for (int edge = 0; edge < n_edges; ++edge)
            benchmark::DoNotOptimize(boundary_rule(cut.part, cut.cells, edge, 0, 1, degree + 1));
    count(state, cut);
}

/// A fit for each kind.
void sizes(benchmark::internal::Benchmark* b, EdgeKind kind) {
    b->ArgNames({"kind", "edges"})->ArgsProduct({{kind}, {100, 400, 1600}});
    b->Unit(benchmark::kMillisecond)->Complexity(benchmark::oN);
}
void of_lines(benchmark::internal::Benchmark* b) {
    sizes(b, lines);
}
void of_arcs(benchmark::internal::Benchmark* b) {
    sizes(b, arcs);
}
void of_ellipses(benchmark::internal::Benchmark* b) {
    sizes(b, ellipses);
}
void of_cubics(benchmark::internal::Benchmark* b) {
    sizes(b, cubics);
}
BENCHMARK(RulesOfCutCells)->Apply(of_lines);
BENCHMARK(RulesOfCutCells)->Apply(of_arcs);
BENCHMARK(RulesOfCutCells)->Apply(of_ellipses);
BENCHMARK(RulesOfCutCells)->Apply(of_cubics);
BENCHMARK(RulesOfBoundary)->Apply(of_lines);
BENCHMARK(RulesOfBoundary)->Apply(of_arcs);
BENCHMARK(RulesOfBoundary)->Apply(of_ellipses);
BENCHMARK(RulesOfBoundary)->Apply(of_cubics);

}  // namespace
}  // namespace abut::benchmarks
