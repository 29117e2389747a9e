// SPDX-License-Identifier: GPL-3.0-or-later
// One part: stiffness, factorisation, one solution. Arguments: cells each way, degree.
#include <benchmark/benchmark.h>

#include "solver/part_system.hpp"
#include "tests/benchmarks/benchmark_scenes.hpp"

namespace abut::benchmarks {
namespace {

PartOnGrid plate(const benchmark::State& state) {
    return plate_on_grid(plate_with_hole(), static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
}

solver::PartSystem plate_system(const benchmark::State& state) {
    PartOnGrid g = plate(state);
    const int n = g.input.space.n_functions;
    return solver::make_part_system(std::move(g.input), {}, Eigen::VectorXd::Zero(2 * n), g.center, g.size);
}

void AssembleStiffness(benchmark::State& state) {
    const PartOnGrid g = plate(state);
    for (auto _ : state) benchmark::DoNotOptimize(assemble_stiffness(g.input));
    state.counters["unknowns"] = 2 * g.input.space.n_functions;
    state.counters["cut"] = static_cast<double>(g.input.cut_rules.size());
}
BENCHMARK(AssembleStiffness)->ArgsProduct({{16, 32, 64}, {1, 2, 3}})->Unit(benchmark::kMillisecond)->UseRealTime();

/// Ordering, symbolic and numeric factorisation: a new grid needs all three.
void Factorise(benchmark::State& state) {
    const solver::PartSystem system = plate_system(state);
    const solver::SparseSymmetric matrix = restricted(system.stiffness, system.number, system.n_kept);
    for (auto _ : state) {
        const solver::Factorization factor(matrix);
        if (!factor.ok()) state.SkipWithError("not positive definite");
        benchmark::DoNotOptimize(factor.failed_at());
    }
    state.counters["unknowns"] = matrix.n;
    state.counters["entries"] = static_cast<double>(matrix.value.size());
}
BENCHMARK(Factorise)->ArgsProduct({{16, 32, 64}, {1, 2, 3}})->Unit(benchmark::kMillisecond)->UseRealTime();

void SolveFactorised(benchmark::State& state) {
    const solver::PartSystem system = plate_system(state);
    const Eigen::VectorXd load = Eigen::VectorXd::Ones(2 * system.n());
    for (auto _ : state) benchmark::DoNotOptimize(solve(system, load));
    state.counters["unknowns"] = system.n_kept;
}
BENCHMARK(SolveFactorised)->ArgsProduct({{16, 32, 64}, {2}})->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace abut::benchmarks
