// SPDX-License-Identifier: GPL-3.0-or-later
// Candidate pairs of edges of two parts that face each other along their whole outline.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "geometry/curves/elliptic_arc.hpp"
#include "geometry/curves/spline_shape.hpp"
#include "geometry/proximity/proximity.hpp"

namespace abut::benchmarks {
namespace {

using geometry::Vec2;

enum class Kind { line, arc, ellipse, bezier };

geometry::Curve edge_between(const Vec2& a, const Vec2& b, Kind kind) {
    const Vec2 bulge = 0.1 * geometry::right_of(b - a);
    if (kind == Kind::line) return geometry::Segment{a, b};
    if (kind == Kind::ellipse) return geometry::from_conjugate(0.5 * (a + b), 0.5 * (a - b), bulge, 0, std::numbers::pi);
    if (kind == Kind::bezier) return geometry::bezier_curve({a, 0.7 * a + 0.3 * b + bulge, 0.3 * a + 0.7 * b + bulge, b}, {});
    const double sweep = 0.5, radius = (b - a).norm() / (2 * std::sin(sweep / 2));
    const Vec2 center = 0.5 * (a + b) + radius * std::cos(sweep / 2) * geometry::left_of((b - a).normalized());
    const Vec2 from = a - center;
    return geometry::Arc{center, radius, std::atan2(from.y(), from.x()), sweep};
}

/// A disc of n edges in a frame whose hole has n edges, corners against the middle of edges: a ring of gaps of a fifth of an
/// edge, two candidates for each edge.
std::vector<geometry::Part> gear_in_frame(int n, Kind kind) {
    std::vector<geometry::Part> parts(2);
    const double step = 2 * std::numbers::pi / n;
    for (int part = 0; part < 2; ++part) {
        const double radius = 1 + part * 0.2 * step;
        geometry::Loop loop;
        for (int k = 0; k < n; ++k) {
            const double a = (part == 0 ? k : 0.5 - k) * step, b = (part == 0 ? k + 1 : -0.5 - k) * step;
            loop.edges.push_back(k);
            parts[static_cast<std::size_t>(part)].edges.push_back(
                {edge_between(radius * Vec2(std::cos(a), std::sin(a)), radius * Vec2(std::cos(b), std::sin(b)), kind), "", ""});
        }
        parts[static_cast<std::size_t>(part)].loops.push_back(loop);
    }
    return parts;
}

/// Arguments: edges of both parts together, and their kind.
void Proximity(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0)) / 2;
    const std::vector<geometry::Part> parts = gear_in_frame(n, static_cast<Kind>(state.range(1)));
    const double distance = 0.25 * 2 * std::numbers::pi / n;
    for (auto _ : state) benchmark::DoNotOptimize(geometry::close_edge_pairs(parts, distance));
    state.counters["edges"] = 2.0 * n;
    state.counters["candidates"] = static_cast<double>(geometry::close_edge_pairs(parts, distance).size());
}
BENCHMARK(Proximity)->ArgsProduct({{1000, 10000, 100000}, {0, 1}})->Unit(benchmark::kMillisecond);
BENCHMARK(Proximity)->ArgsProduct({{1000}, {2, 3}})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace abut::benchmarks
