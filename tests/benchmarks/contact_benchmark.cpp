// SPDX-License-Identifier: GPL-3.0-or-later
// Contact between parts that are factorised already: condensation to the multipliers, the quadratic program, the displacements.
#include <benchmark/benchmark.h>

#include "src/analysis/grading.hpp"
#include "src/solution/assembly_model.hpp"
#include "tests/benchmarks/benchmark_scenes.hpp"
#include "tests/benchmarks/solve_again.hpp"

namespace abut::benchmarks {
namespace {

/// The first grids of a scene, as the analysis makes them, with all cells scaled.
SolvedAssembly first_pass(const Scene& scene, double coarseness) {
    const std::vector<Candidate> candidates = find_candidates(scene, 1);
    Stopwatches seconds;
    return solve_pass(scene, resolve_conditions(scene), candidates, std::vector<bool>(scene.parts.size(), true),
                      first_sizes(scene, candidates, coarseness), coarseness, seconds);
}

/// Argument: cells per cell of the standard level. Two held parts (case B), and a pin that only contact holds (pin bracket).
void solve_contact(benchmark::State& state, const char* file) {
    const SolvedAssembly pass = first_pass(scene_file(file), 1.0 / static_cast<double>(state.range(0)));
    solve_again(state, pass);
}
BENCHMARK_CAPTURE(solve_contact, case_b, "data/scenes/case_b.json")
    ->RangeMultiplier(2)
    ->Range(1, 4)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(solve_contact, pin_bracket, "data/scenes/pin_bracket.json")
    ->RangeMultiplier(2)
    ->Range(1, 2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void FindCandidates(benchmark::State& state) {
    const Scene scene = scene_file("data/scenes/pin_bracket.json");
    for (auto _ : state) benchmark::DoNotOptimize(find_candidates(scene, 1));
}
BENCHMARK(FindCandidates)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace abut::benchmarks
