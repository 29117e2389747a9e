// SPDX-License-Identifier: GPL-3.0-or-later
// From coefficients to answers: the stress fit, and the samples that pictures and largest values are made of.
#include <benchmark/benchmark.h>

#include "src/answers/field_results.hpp"
#include "tests/benchmarks/benchmark_scenes.hpp"

namespace abut::benchmarks {
namespace {

/// A displacement of no meaning: what recovery costs does not depend on it.
Eigen::VectorXd any_displacement(const PartOnGrid& grid) {
    return Eigen::VectorXd::LinSpaced(2 * grid.input.space.n_functions, -1, 1).array().sin();
}

PartOnGrid plate(const benchmark::State& state) {
    static const Scene scene = plate_with_hole();
    return plate_on_grid(scene, static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
}

void count(benchmark::State& state, const PartOnGrid& grid) {
    state.counters["unknowns"] = 2 * grid.input.space.n_functions;
    state.SetComplexityN(2 * grid.input.space.n_functions);
}

/// Arguments: cells each way, degree.
void FitStress(benchmark::State& state) {
    const PartOnGrid grid = plate(state);
    const Eigen::VectorXd displacement = any_displacement(grid);
    if (const auto field = stress_field(grid, displacement); !field.failure.empty()) state.SkipWithError(field.failure.c_str());
    for (auto _ : state) benchmark::DoNotOptimize(stress_field(grid, displacement));
    count(state, grid);
}

void SampleFields(benchmark::State& state) {
    const PartOnGrid grid = plate(state);
    const Eigen::VectorXd displacement = any_displacement(grid);
    const solver::StressField stress = stress_field(grid, displacement);
    for (auto _ : state) benchmark::DoNotOptimize(part_field(grid, displacement, stress, grid.size / 160));
    count(state, grid);
}

void sizes(benchmark::internal::Benchmark* b) {
    b->ArgNames({"cells", "degree"})->ArgsProduct({{16, 32, 64, 128}, {2}});
    b->Unit(benchmark::kMillisecond)->Complexity();
}
void degrees(benchmark::internal::Benchmark* b) {
    b->ArgNames({"cells", "degree"})->ArgsProduct({{64}, {1, 3, 4}})->Unit(benchmark::kMillisecond);
}
BENCHMARK(FitStress)->Apply(sizes);
BENCHMARK(FitStress)->Apply(degrees);
BENCHMARK(SampleFields)->Apply(sizes);

}  // namespace
}  // namespace abut::benchmarks
