// SPDX-License-Identifier: GPL-3.0-or-later
// Classification of cells over numbers of cells and of edges, up to a million cells with a hundred thousand edges; their
// elements; and points in parts of many edges.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "geometry/brep/monotone.hpp"
#include "geometry/cells/cut_cells.hpp"
#include "geometry/cells/elements.hpp"
#include "tests/benchmarks/wheel.hpp"

namespace abut::benchmarks {
namespace {

using namespace geometry;
/// Arguments: kind of edges, cells each way, edges.
void CutCellsOfManyEdges(benchmark::State& state) {
    const Part part = wheel(static_cast<EdgeKind>(state.range(0)), static_cast<int>(state.range(2)));
    const Grid grid = grid_around(part, static_cast<int>(state.range(1)));
    CutCells cells;
    for (auto _ : state) cells = cut_cells(part, grid);
    if (std::abs(cells.area / area(part) - 1) > 1e-12) state.SkipWithError("the cells' areas do not sum to the part's");
    state.counters["cells"] = static_cast<double>(cells.cell_class.size());
    state.counters["contours"] = static_cast<double>(cells.contours.size());
}
BENCHMARK(CutCellsOfManyEdges)
    ->ArgNames({"kind", "n", "edges"})
    ->ArgsProduct({{lines}, {10, 100, 1000}, {10, 1000, 100000}})
    ->ArgsProduct({{arcs, ellipses, cubics}, {1000}, {100, 10000, 100000}})
    ->Unit(benchmark::kMillisecond);

/// Beside the cells, `n` each way.
void find_elements_of(benchmark::State& state, const Part& part, std::int64_t n) {
    const CutCells cells = cut_cells(part, grid_around(part, static_cast<int>(n)));
    Elements elements;
    for (auto _ : state) elements = find_elements(part, cells);
    if (elements.unclear > 0) state.SkipWithError("components that are not told apart");
    state.counters["extra"] = static_cast<double>(elements.cell_of_extra.size());
}

/// Arguments: kind of edges, cells each way, edges.
void ElementsOfManyEdges(benchmark::State& state) {
    find_elements_of(state, wheel(static_cast<EdgeKind>(state.range(0)), static_cast<int>(state.range(2))), state.range(1));
}
BENCHMARK(ElementsOfManyEdges)
    ->ArgNames({"kind", "n", "edges"})
    ->ArgsProduct({{lines, cubics}, {10, 1000}, {1000, 100000}})
    ->Unit(benchmark::kMillisecond);

/// A plate with n x n square holes, each as wide as a web between them: all cells are cut, and with an odd grid many split.
Part perforated(int n) {
    Part part;
    const auto add_square = [&](const Vec2& low, double size, bool hole) {
        const std::vector<Vec2> corners{low, low + Vec2(size, 0), low + Vec2(size, size), low + Vec2(0, size)};
        part.loops.emplace_back();
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec2 &p = corners[i], &q = corners[(i + 1) % 4];
            part.loops.back().edges.push_back(static_cast<int>(part.edges.size()));
            const Segment side = hole ? Segment{corners[3 - i], corners[(6 - i) % 4]} : Segment{p, q};
            part.edges.emplace_back();
            part.edges.back().curve = side;
        }
    };
    add_square({0, 0}, 1, false);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) add_square({(i + 0.25) / n, (j + 0.25) / n}, 0.5 / n, true);
    return part;
}

/// Arguments: holes each way, cells each way.
void ElementsOfAPerforatedPlate(benchmark::State& state) {
    find_elements_of(state, perforated(static_cast<int>(state.range(0))), state.range(1));
}
BENCHMARK(ElementsOfAPerforatedPlate)
    ->ArgNames({"holes", "n"})
    ->ArgsProduct({{158}, {10, 100, 400, 1000}})
    ->Unit(benchmark::kMillisecond);

std::vector<Vec2> points_around(const Part& part, int n) {
    const Box2 box = bounding_box(part);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Vec2> points;
    for (int k = 0; k < n; ++k) {
        const double x = unit(random);
        points.push_back(box.min + Vec2(x, unit(random)).cwiseProduct(box.size()));
    }
    return points;
}

/// Arguments: kind of edges, edges. A hundred thousand points in one part.
void PointsInPart(benchmark::State& state) {
    const Part part = wheel(static_cast<EdgeKind>(state.range(0)), static_cast<int>(state.range(1)));
    const std::vector<Vec2> points = points_around(part, 100000);
    std::ptrdiff_t n_inside = 0;
    for (auto _ : state) {
        const SlabbedPieces slabs = slabbed(monotone_pieces(part));
        n_inside = std::count_if(points.begin(), points.end(), [&](const Vec2& p) { return contains(slabs, p); });
    }
    state.counters["inside"] = static_cast<double>(n_inside);
}
BENCHMARK(PointsInPart)
    ->ArgNames({"kind", "edges"})
    ->ArgsProduct({{lines, arcs, ellipses, cubics}, {100, 10000, 100000}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace abut::benchmarks
