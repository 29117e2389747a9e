// SPDX-License-Identifier: GPL-3.0-or-later
// What each effect costs: one supported plate under edge pressure, then the same plate with one effect more. Rows named "off"
// hold what could call for an effect but does not, and should take the time of "plate".
#include <benchmark/benchmark.h>

#include "src/analysis/analysis.hpp"
#include "tests/benchmarks/benchmark_scenes.hpp"

namespace abut::benchmarks {
namespace {

/// What is added to the plate.
struct More {
    const char *parts, *loads, *supports, *contacts;
};

/// All grids fixed: nothing but the effect differs.
Scene plate_with(const More& more) {
    const std::string plate =
        R"({"name": "plate", "material": "m", "geometry": {"difference": [{"rectangle": {"min": [0, 0], "max": [4, 2]}},
                                                                          {"circle": {"center": [2.1, 0.9], "radius": 0.4}}]}})";
    return scene_text(R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3, "density": 1e-3}}, "parts": [)" + plate +
                      more.parts + R"(], "supports": [{"on": "plate/bottom", "fix": ["x", "y"]})" + more.supports +
                      R"(], "loads": [{"on": "plate/top", "pressure": 10})" + more.loads + R"(], "contacts": )" +
                      more.contacts + R"(, "accuracy": {"cell_size": 0.08}})");
}

void effect(benchmark::State& state, const More& more) {
    const Scene scene = plate_with(more);
    Result result;
    for (auto _ : state) result = analyze(scene, {});
    if (result.status != "ok") state.SkipWithError(result.message.c_str());
    state.counters["unknowns"] = result.unknowns;
    state.counters["multipliers"] = result.multipliers;
    for (const auto& [stage, seconds] : result.timing)
        if (stage == "geometry" || stage == "assembly" || stage == "solve" || stage == "recovery")
            state.counters[stage + "_ms"] = 1e3 * seconds;
}

constexpr const char* next_block =
    R"(, {"name": "block", "material": "m", "geometry": {"rectangle": {"min": [4, 0], "max": [5, 2]}}})";
constexpr const char* far_block =
    R"(, {"name": "block", "material": "m", "geometry": {"rectangle": {"min": [99, 0], "max": [100, 2]}}})";
constexpr const char* hold_block = R"(, {"on": "block/right", "fix": ["x", "y"]})";
constexpr const char* detect = R"({"detect": true})";
constexpr const char* no_detect = R"({"detect": false})";

constexpr More nothing{"", "", "", detect};
constexpr More body_force{"", R"(, {"part": "plate", "body_force": [1, 0]})", "", detect};
constexpr More gravity{"", R"(, {"gravity": [0, -9.81]})", "", detect};
constexpr More rigid_support{"", "", R"(, {"part": "plate", "rigid": {"translation": [null, null], "rotation": 0}})", detect};
constexpr More partner{next_block, "", hold_block, detect};
constexpr More part_far_away{far_block, "", hold_block, detect};
constexpr More no_detection{next_block, "", hold_block, no_detect};

BENCHMARK_CAPTURE(effect, plate, nothing)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(effect, body_force, body_force)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(effect, gravity, gravity)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(effect, rigid_support, rigid_support)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(effect, contact, partner)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(effect, off_part_far_away, part_far_away)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(effect, off_no_detection, no_detection)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace abut::benchmarks
