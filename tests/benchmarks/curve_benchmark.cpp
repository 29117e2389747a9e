// SPDX-License-Identifier: GPL-3.0-or-later
// What boundary curves answer, by kind: evaluation, length, closest point, crossings with grid lines.
#include <benchmark/benchmark.h>

#include <random>
#include <vector>

#include "geometry/curves/curve.hpp"
#include "tests/benchmarks/wheel.hpp"

namespace abut::benchmarks {
namespace {

using namespace geometry;

constexpr int n_queries = 256;  // a pass, so that the loop itself does not count

Curve sample(const benchmark::State& state) {
    return edge_between(static_cast<EdgeKind>(state.range(0)), Vec2(0.1, 0.2), Vec2(1.3, 0.9));
}

const std::vector<double>& fractions() {
    static const std::vector<double> values = [] {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> unit(0, 1);
        std::vector<double> made(n_queries);
        for (double& v : made) v = unit(random);
        return made;
    }();
    return values;
}

/// Calls f with every fraction of a curve's parameter; shows the time of one.
template <class F>
void ask(benchmark::State& state, F f) {
    for (auto _ : state)
        for (double t : fractions()) benchmark::DoNotOptimize(f(t));
    state.SetItemsProcessed(state.iterations() * n_queries);
}

void CurvePoint(benchmark::State& state) {
    const Curve curve = sample(state);
    ask(state, [&](double t) { return point(curve, t); });
}

void CurveNormal(benchmark::State& state) {
    const Curve curve = sample(state);
    ask(state, [&](double t) { return outward_normal(curve, t); });
}

void CurveLength(benchmark::State& state) {
    const Curve curve = sample(state);
    ask(state, [&](double t) { return length(curve, 0, t); });
}

void CurveParameterAtLength(benchmark::State& state) {
    const Curve curve = sample(state);
    const double whole = length(curve);
    ask(state, [&](double t) { return parameter_at_length(curve, t * whole); });
}

void CurveClosestPoint(benchmark::State& state) {
    const Curve curve = sample(state);
    ask(state, [&](double t) { return closest_parameter(curve, point(curve, t) + 0.3 * outward_normal(curve, t)); });
}

void CurveCrossings(benchmark::State& state) {
    const Curve curve = sample(state);
    const Box2 box = bounding_box(curve);
    ask(state, [&](double t) { return crossings(curve, 0, box.min.x() + t * box.size().x()); });
}

void by_kind(benchmark::internal::Benchmark* b) {
    b->ArgName("kind")->DenseRange(lines, cubics);
}
BENCHMARK(CurvePoint)->Apply(by_kind);
BENCHMARK(CurveNormal)->Apply(by_kind);
BENCHMARK(CurveLength)->Apply(by_kind);
BENCHMARK(CurveParameterAtLength)->Apply(by_kind);
BENCHMARK(CurveClosestPoint)->Apply(by_kind);
BENCHMARK(CurveCrossings)->Apply(by_kind);

}  // namespace
}  // namespace abut::benchmarks
