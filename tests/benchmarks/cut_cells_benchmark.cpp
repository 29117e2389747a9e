// SPDX-License-Identifier: GPL-3.0-or-later
// Classification of cells over numbers of cells and of edges, up to a million cells with a hundred thousand edges; their
// elements; and points in parts of many edges.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/cut_cells.hpp"
#include "geometry/elements.hpp"
#include "geometry/elliptic_arc.hpp"
#include "geometry/monotone.hpp"
#include "geometry/spline_shape.hpp"

namespace abut::benchmarks {
namespace {

using namespace geometry;
constexpr double two_pi = 2 * std::numbers::pi;

enum Kind : std::int64_t { lines, arcs, ellipses, cubics };

/// Flat enough for neighbours not to cross.
Curve edge_between(Kind kind, const Vec2& p, const Vec2& q) {
    constexpr double half = 0.75;  // of an arc's angle
    const Vec2 d = q - p, middle = 0.5 * (p + q);
    const Vec2 along = -0.5 / std::sin(half) * d, outward = 0.3 * right_of(d);
    if (kind == arcs) {
        const Vec2 center = middle + 0.5 / std::tan(half) * left_of(d);
        return Arc{center, along.norm(), std::atan2((p - center).y(), (p - center).x()), 2 * half};
    }
    if (kind == ellipses) return EllipticArc{middle - std::cos(half) * outward, along, outward, two_pi / 4 - half, 2 * half};
    if (kind == cubics) return bezier_curve({p, p + 0.3 * d + outward, q - 0.4 * d + outward, q}, {});
    return Segment{p, q};
}

/// A wheel of radius 1 with waves, of n edges.
Part wheel(Kind kind, int n) {
    Part part;
    part.loops.resize(1);
    const auto corner = [&](int i) {
        const double angle = two_pi * i / n + 0.1, radius = 1 + 0.05 * std::sin(7 * angle);
        return Vec2(radius * std::cos(angle), radius * std::sin(angle));
    };
    for (int i = 0; i < n; ++i) {
        part.loops[0].edges.push_back(i);
        part.edges.push_back({edge_between(kind, corner(i), corner((i + 1) % n)), "", ""});
    }
    return part;
}

/// n x n cells, not uniform, with the part's box and a little more.
Grid grid_around(const Part& part, int n) {
    const Box2 box = bounding_box(part);
    Grid grid;
    for (int axis : {0, 1}) {
        std::vector<double>& coordinates = axis == 0 ? grid.x : grid.y;
        for (int k = 0; k <= n; ++k) {
            const double s = static_cast<double>(k) / n, bent = s + 0.02 * std::sin(two_pi * s);
            coordinates.push_back(box.min[axis] - 0.01 + bent * (box.size()[axis] + 0.02));
        }
    }
    return grid;
}

/// Arguments: kind of edges, cells each way, edges.
void CutCellsOfManyEdges(benchmark::State& state) {
    const Part part = wheel(static_cast<Kind>(state.range(0)), static_cast<int>(state.range(2)));
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
    find_elements_of(state, wheel(static_cast<Kind>(state.range(0)), static_cast<int>(state.range(2))), state.range(1));
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
    const Part part = wheel(static_cast<Kind>(state.range(0)), static_cast<int>(state.range(1)));
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
