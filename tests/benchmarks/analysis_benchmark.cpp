// SPDX-License-Identifier: GPL-3.0-or-later
// Whole analyses, from the scene in memory to the result in memory; and the reading of the scene, import included.
#include <benchmark/benchmark.h>

#include "src/analysis/analysis.hpp"
#include "tests/benchmarks/benchmark_scenes.hpp"

namespace abut::benchmarks {
namespace {

void analyze_scene(benchmark::State& state, const char* file) {
    const Scene scene = scene_file(file);
    Result result;
    for (auto _ : state) result = analyze(scene, {});
    if (result.status != "ok") state.SkipWithError(result.message.c_str());
    state.counters["unknowns"] = result.unknowns;
    state.counters["grids"] = result.solver.grids;
    state.counters["multipliers"] = result.multipliers;
}
BENCHMARK_CAPTURE(analyze_scene, case_b, "data/scenes/case_b.json")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(analyze_scene, pin_bracket, "data/scenes/pin_bracket.json")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(analyze_scene, vise, "data/scenes/vise.json")->Unit(benchmark::kMillisecond)->UseRealTime();

void read(benchmark::State& state, const char* file) {
    for (auto _ : state) benchmark::DoNotOptimize(scene_file(file));
}
BENCHMARK_CAPTURE(read, case_b, "data/scenes/case_b.json")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(read, pin_bracket, "data/scenes/pin_bracket.json")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace abut::benchmarks
