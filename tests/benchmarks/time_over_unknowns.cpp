// SPDX-License-Identifier: GPL-3.0-or-later
// Whole solver time on one grid from 2 thousand to a million unknowns, on one thread: slope of its logarithm over that of the
// unknowns, from one size to the next and over all since the first; peak memory. Sizes above 200 thousand take minutes and
// gigabytes: they run with ABUT_LARGE_BENCHMARKS=1 only.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <vector>

#include "tests/benchmarks/one_grid.hpp"
#include "tests/benchmarks/one_thread.hpp"
#include "tests/benchmarks/peak_memory.hpp"

namespace abut::benchmarks {
namespace {

constexpr int largest_by_default = 200;  // thousands

struct Measured {
    double unknowns, seconds;
};

double slope(const Measured& from, const Measured& to) {
    return std::log(to.seconds / from.seconds) / std::log(to.unknowns / from.unknowns);
}

void count_slopes(benchmark::State& state, GridKind kind, const Measured& now) {
    static std::map<GridKind, std::vector<Measured>> sizes;
    std::vector<Measured>& before = sizes[kind];
    if (!before.empty()) {
        state.counters["slope"] = slope(before.back(), now);
        state.counters["slope_from_first"] = slope(before.front(), now);
    }
    before.push_back(now);
}

/// Argument: thousands of unknowns, ascending.
void TimeOverUnknowns(benchmark::State& state, GridKind kind) {
    const int thousands = static_cast<int>(state.range(0));
    if (thousands > largest_by_default && std::getenv("ABUT_LARGE_BENCHMARKS") == nullptr)
        return state.SkipWithError("only with ABUT_LARGE_BENCHMARKS=1");
    use_one_thread();
    const OneGrid problem = grid_of_size(kind, thousands);
    forget_peak_memory();
    double seconds = HUGE_VAL;
    int unknowns = 0, multipliers = 0;
    for (auto _ : state) {
        const double begin = thread_seconds();
        const SolvedAssembly solved = solve(problem);
        state.SetIterationTime(thread_seconds() - begin);
        seconds = std::min(seconds, thread_seconds() - begin);
        if (!solved.failure.empty() || !solved.solution.converged) return state.SkipWithError("the grid has no solution");
        unknowns = n_unknowns(solved);
        multipliers = solved.solution.n_multipliers;
    }
    state.counters["unknowns"] = unknowns;
    state.counters["multipliers"] = multipliers;
    state.counters["peak_bytes"] =
        benchmark::Counter(peak_memory(), benchmark::Counter::kDefaults, benchmark::Counter::kIs1024);
    count_slopes(state, kind, {static_cast<double>(unknowns), seconds});
}

/// The least of the repeats makes the slopes. Few repeats where one takes seconds.
void small_sizes(benchmark::internal::Benchmark* b) {
    for (int thousands : {2, 5, 10, 20, 50, 100}) b->Arg(thousands);
    b->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(7);
}
void large_sizes(benchmark::internal::Benchmark* b) {
    for (int thousands : {200, 500, 1000}) b->Arg(thousands);
    b->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(1);
}
BENCHMARK_CAPTURE(TimeOverUnknowns, even, GridKind::even)->Apply(small_sizes);
BENCHMARK_CAPTURE(TimeOverUnknowns, even, GridKind::even)->Apply(large_sizes);
BENCHMARK_CAPTURE(TimeOverUnknowns, graded, GridKind::graded)->Apply(small_sizes);
BENCHMARK_CAPTURE(TimeOverUnknowns, graded, GridKind::graded)->Apply(large_sizes);
BENCHMARK_CAPTURE(TimeOverUnknowns, halved, GridKind::halved)->Apply(small_sizes);
BENCHMARK_CAPTURE(TimeOverUnknowns, halved, GridKind::halved)->Apply(large_sizes);

}  // namespace
}  // namespace abut::benchmarks
