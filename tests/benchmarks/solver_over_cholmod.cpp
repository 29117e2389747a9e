// SPDX-License-Identifier: GPL-3.0-or-later
// Whole solver time on one grid over the time of CHOLMOD's analysis and factorisation of the same stiffness matrices alone: in
// one run, in turns, on one thread. The solver's time is a pass of the analysis: cells, space, quadrature, assembly, supports,
// factorisation, contact, displacements; without recovery and output. Counters: `ratio` over the faster of CHOLMOD's two
// settings (`over_defaults`, `over_supernodal`), medians of the thread's time; `share_*` of the stages in the solver's time.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "tests/benchmarks/cholmod_alone.hpp"
#include "tests/benchmarks/one_grid.hpp"
#include "tests/benchmarks/one_thread.hpp"

namespace abut::benchmarks {
namespace {

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double seconds_of_cholmod(const std::vector<solver::SparseSymmetric>& matrices, CholmodSettings settings) {
    double seconds = 0;
    for (const solver::SparseSymmetric& matrix : matrices) seconds += seconds_of_cholmod(matrix, settings);
    return seconds;
}

/// Seconds of every repeat.
struct Times {
    std::vector<double> whole, defaults, supernodal;
    std::map<std::string, std::vector<double>> stage;
};

void count_shares(benchmark::State& state, const Times& times) {
    for (const auto& [stage, seconds] : times.stage) state.counters["share_" + stage] = median(seconds) / median(times.whole);
}

void count_ratios(benchmark::State& state, const Times& times) {
    const double ours = median(times.whole), fastest = std::min(median(times.defaults), median(times.supernodal));
    state.counters["cholmod_ms"] = 1e3 * fastest;
    state.counters["ratio"] = ours / fastest;
    state.counters["over_defaults"] = ours / median(times.defaults);
    state.counters["over_supernodal"] = ours / median(times.supernodal);
}

/// Argument: thousands of unknowns.
void SolverOverCholmod(benchmark::State& state, GridKind kind) {
    use_one_thread();
    const OneGrid problem = grid_of_size(kind, static_cast<int>(state.range(0)));
    const SolvedAssembly solved = solve(problem);
    if (!solved.failure.empty() || !solved.solution.converged) return state.SkipWithError("the grid has no solution");
    const std::vector<solver::SparseSymmetric> matrices = stiffness_matrices(solved);
    Times times;
    for (auto _ : state) {
        times.whole.push_back(thread_seconds_of([&] { benchmark::DoNotOptimize(solve(problem)); }));
        times.defaults.push_back(seconds_of_cholmod(matrices, CholmodSettings::defaults));
        times.supernodal.push_back(seconds_of_cholmod(matrices, CholmodSettings::supernodal));
        for (const auto& [stage, seconds] : stage_seconds(problem, solved)) times.stage[stage].push_back(seconds);
        state.SetIterationTime(times.whole.back());
    }
    state.counters["unknowns"] = n_unknowns(solved);
    state.counters["multipliers"] = solved.solution.n_multipliers;
    count_ratios(state, times);
    count_shares(state, times);
}

/// Repeats are set here: each would be preceded by the search for the grid if Google Benchmark looked for their number.
void small_sizes(benchmark::internal::Benchmark* b) {
    for (int thousands : {2, 5, 10, 20}) b->Arg(thousands);
    b->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(25);
}
void large_sizes(benchmark::internal::Benchmark* b) {
    for (int thousands : {50, 100, 200}) b->Arg(thousands);
    b->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(5);
}
BENCHMARK_CAPTURE(SolverOverCholmod, even, GridKind::even)->Apply(small_sizes);
BENCHMARK_CAPTURE(SolverOverCholmod, even, GridKind::even)->Apply(large_sizes);
BENCHMARK_CAPTURE(SolverOverCholmod, graded, GridKind::graded)->Apply(small_sizes);
BENCHMARK_CAPTURE(SolverOverCholmod, graded, GridKind::graded)->Apply(large_sizes);

}  // namespace
}  // namespace abut::benchmarks
