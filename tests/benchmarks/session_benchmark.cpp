// SPDX-License-Identifier: GPL-3.0-or-later
// An answer after a change of the loads, on what was prepared once; with all displacements and stresses; the preparing.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "src/session/session.hpp"
#include "tests/benchmarks/benchmark_scenes.hpp"

namespace abut::benchmarks {
namespace {

/// All loads are named: they act at factors.
Session session_of(const char* file) {
    Scene scene = scene_file(file);
    scene.cases.clear();
    for (std::size_t k = 0; k < scene.loads.size(); ++k)
        if (scene.loads[k].name.empty()) scene.loads[k].name = "load " + std::to_string(k);
    AnalyzeOptions options;
    options.threads = 1;
    return Session(std::move(scene), options);
}

/// From 0.8 to 1.2 of what was prepared, each load at another pace: contact changes its ends.
void turn_loads(Session& session, int step) {
    int k = 0;
    for (const auto& [name, factor] : LoadFactors(session.loads()))
        session.set_load(name, 1 + 0.2 * std::sin(0.37 * step * static_cast<double>(++k)));
}

void answer(benchmark::State& state, const char* file) {
    Session session = session_of(file);
    const Result& result = session.prepare();
    int step = 0;
    for (auto _ : state) {
        turn_loads(session, ++step);
        const Answer answer = session.answer();
        if (answer.status != "ok") state.SkipWithError(answer.message.c_str());
    }
    state.counters["unknowns"] = result.unknowns;
    state.counters["multipliers"] = result.multipliers;
}

void fields(benchmark::State& state, const char* file) {
    Session session = session_of(file);
    session.prepare();
    int step = 0;
    for (auto _ : state) {
        turn_loads(session, ++step);
        benchmark::DoNotOptimize(session.fields());
    }
}

void prepare(benchmark::State& state, const char* file) {
    Session session = session_of(file);
    for (auto _ : state) benchmark::DoNotOptimize(session.prepare());
}

BENCHMARK_CAPTURE(answer, pin_bracket, "data/scenes/pin_bracket.json")->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK_CAPTURE(answer, pin_bracket_swinging, "data/scenes/pin_bracket_cases.json")
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(answer, vise, "data/scenes/vise.json")->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK_CAPTURE(answer, vise_clamp, "data/scenes/vise_clamp.json")->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK_CAPTURE(fields, pin_bracket, "data/scenes/pin_bracket.json")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(prepare, pin_bracket, "data/scenes/pin_bracket.json")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace abut::benchmarks
