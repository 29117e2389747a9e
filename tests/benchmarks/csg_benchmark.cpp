// SPDX-License-Identifier: GPL-3.0-or-later
// Boolean operations: cost by number of primitives, and of deep trees.
#include <benchmark/benchmark.h>

#include <cmath>
#include <utility>
#include <vector>

#include "geometry/csg/csg.hpp"

namespace abut::benchmarks {
namespace {

using namespace geometry;

template <class Shape>
CsgNode node(Shape shape) {
    return {std::move(shape), "", "/geometry"};
}

/// Circles and rectangles (some turned) in turn on a square grid; each overlaps its neighbours where `size` exceeds 1.
std::vector<CsgNode> grid_of_primitives(int n, double size) {
    std::vector<CsgNode> all;
    const int side = static_cast<int>(std::ceil(std::sqrt(n)));
    for (int k = 0; k < n; ++k) {
        const Vec2 at(k % side, k / side);
        const double h = size / 2;
        if (k % 3 == 0)
            all.push_back(node(Circle{at, h}));
        else if (k % 3 == 1)
            all.push_back(node(Rectangle{at - Vec2(h, h), at + Vec2(h, 0.8 * h)}));
        else
            all.push_back(node(Placed{{node(Rectangle{{-h, -h}, {h, h}})}, 30, at}));
    }
    return all;
}

CsgNode plate(double size) {
    return node(Rectangle{{-2, -2}, {size + 2, size + 2}});
}

void evaluate_repeatedly(benchmark::State& state, const CsgNode& tree) {
    const CsgResult result = evaluate(tree);
    if (!result.problems.empty()) return state.SkipWithError(result.problems.front().what.c_str());
    for (auto _ : state) benchmark::DoNotOptimize(evaluate(tree));
    state.counters["edges"] = static_cast<double>(result.part.edges.size());
}

/// Argument: number of primitives that overlap.
void CsgUnion(benchmark::State& state) {
    evaluate_repeatedly(state, node(Union{grid_of_primitives(static_cast<int>(state.range(0)), 1.3)}));
}
BENCHMARK(CsgUnion)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);

/// Argument: number of holes.
void CsgPlateWithHoles(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0));
    std::vector<CsgNode> of = grid_of_primitives(n, 0.6);
    of.insert(of.begin(), plate(std::sqrt(n)));
    evaluate_repeatedly(state, node(Difference{of}));
}
BENCHMARK(CsgPlateWithHoles)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);

/// Argument: number of elliptic holes.
void CsgPlateWithEllipses(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0)), side = static_cast<int>(std::ceil(std::sqrt(n)));
    std::vector<CsgNode> of{plate(std::sqrt(n))};
    for (int k = 0; k < n; ++k) of.push_back(node(Ellipse{{k % side, k / side}, {0.4, 0.2}, 7.0 * k}));
    evaluate_repeatedly(state, node(Difference{of}));
}
BENCHMARK(CsgPlateWithEllipses)->Arg(1)->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond);

/// Argument: depth of difference(difference(...), hole).
void CsgNestedDifferences(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0));
    CsgNode tree = plate(std::sqrt(n));
    for (CsgNode& hole : grid_of_primitives(n, 0.6)) tree = node(Difference{{std::move(tree), std::move(hole)}});
    evaluate_repeatedly(state, tree);
}
BENCHMARK(CsgNestedDifferences)->Arg(200)->Arg(1000)->Unit(benchmark::kMillisecond);

/// Argument: depth of union(union(...), primitive).
void CsgNestedUnions(benchmark::State& state) {
    const std::vector<CsgNode> all = grid_of_primitives(static_cast<int>(state.range(0)), 1.3);
    CsgNode tree = all.front();
    for (std::size_t k = 1; k < all.size(); ++k) tree = node(Union{{std::move(tree), all[k]}});
    evaluate_repeatedly(state, tree);
}
BENCHMARK(CsgNestedUnions)->Arg(200)->Arg(1000)->Unit(benchmark::kMillisecond);

/// Argument: depth of a chain in which unions and differences take turns.
void CsgTurns(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0));
    CsgNode tree = plate(std::sqrt(n));
    const std::vector<CsgNode> holes = grid_of_primitives(n, 0.6);
    for (std::size_t k = 0; k < holes.size(); ++k)
        if (k % 2 == 0)
            tree = node(Difference{{std::move(tree), holes[k]}});
        else
            tree = node(Union{{std::move(tree), holes[k]}});
    evaluate_repeatedly(state, tree);
}
BENCHMARK(CsgTurns)->Arg(100)->Arg(200)->Unit(benchmark::kMillisecond);

/// Argument: number of turned rectangles intersected.
void CsgIntersection(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0));
    std::vector<CsgNode> of;
    for (int k = 0; k < n; ++k)
        of.push_back(node(Placed{{node(Rectangle{{-1, -1}, {1, 1}})}, 90.0 * k / n, Vec2(1e-3 * k, 0)}));
    evaluate_repeatedly(state, node(Intersection{of}));
}
BENCHMARK(CsgIntersection)->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace abut::benchmarks
