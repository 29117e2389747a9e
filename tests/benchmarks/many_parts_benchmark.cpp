// SPDX-License-Identifier: GPL-3.0-or-later
// Scaling in parts and in pairs: discs in rows of ten that do not meet (parts), discs in a square whose rows do (pairs), and a
// stack of plates that is solved whole.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "src/analysis/analysis.hpp"
#include "src/contact/candidates.hpp"
#include "tests/benchmarks/benchmark_scenes.hpp"

namespace abut::benchmarks {
namespace {

std::string disc(int column, int row, double pitch) {
    const auto number = [](double v) { return std::to_string(v); };
    return R"({"name": "d)" + std::to_string(column) + "_" + std::to_string(row) +
           R"(", "material": "m", "geometry": {"circle": {"center": [)" + number(column) + ", " + number(pitch * row) +
           R"(], "radius": 0.499}}})";
}

/// pitch: of the rows; 1 brings neighbouring rows into contact, 2 does not.
Scene discs(int columns, int rows, double pitch) {
    std::string parts;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) parts += (parts.empty() ? "" : ", ") + disc(column, row, pitch);
    return scene_text(R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3}}, "parts": [)" + parts +
                      R"(], "supports": [{"part": "d0_0", "rigid": {"translation": [0, 0], "rotation": 0}}]})");
}

void find_all(benchmark::State& state, const Scene& scene) {
    for (auto _ : state) benchmark::DoNotOptimize(find_candidates(scene, 1));
    state.counters["parts"] = static_cast<double>(scene.parts.size());
    state.counters["pairs"] = static_cast<double>(find_candidates(scene, 1).size());
}

/// Argument: parts, in rows of ten apart from each other.
void CandidatesOfParts(benchmark::State& state) {
    find_all(state, discs(10, static_cast<int>(state.range(0)) / 10, 2));
    state.SetComplexityN(state.range(0));
}
BENCHMARK(CandidatesOfParts)->Arg(10)->Arg(40)->Arg(160)->Arg(640)->Unit(benchmark::kMillisecond)->Complexity();

/// Argument: about how many pairs: two a disc but for those at the sides.
void CandidatesOfPairs(benchmark::State& state) {
    const int side = static_cast<int>(std::lround(std::sqrt(0.5 * static_cast<double>(state.range(0)))));
    find_all(state, discs(side, side, 1));
    state.SetComplexityN(2 * side * (side - 1));
}
BENCHMARK(CandidatesOfPairs)->Arg(18)->Arg(72)->Arg(288)->Arg(1152)->Unit(benchmark::kMillisecond)->Complexity();

Scene stack(int n) {
    std::string parts;
    for (int k = 0; k < n; ++k)
        parts += (k > 0 ? ", " : "") + (R"({"name": "p)" + std::to_string(k)) +
                 R"(", "material": "m", "geometry": {"rectangle": {"min": [0, )" + std::to_string(k) + R"(], "max": [3, )" +
                 std::to_string(k + 1) + "]}}}";
    return scene_text(R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3}}, "parts": [)" + parts +
                      R"(], "supports": [{"on": "p0/bottom", "fix": ["x", "y"]}], "loads": [{"on": "p)" +
                      std::to_string(n - 1) + R"(/top", "pressure": 10}], "accuracy": {"cell_size": 0.2}})");
}

/// Argument: plates, each held by those below and above only; multipliers grow with them.
void AnalyzeStack(benchmark::State& state) {
    const Scene scene = stack(static_cast<int>(state.range(0)));
    Result result;
    for (auto _ : state) result = analyze(scene, {});
    if (result.status != "ok") state.SkipWithError(result.message.c_str());
    state.counters["unknowns"] = result.unknowns;
    state.counters["multipliers"] = result.multipliers;
    state.SetComplexityN(state.range(0));
}
BENCHMARK(AnalyzeStack)->Arg(2)->Arg(4)->Arg(8)->Arg(16)->Arg(32)->Unit(benchmark::kMillisecond)->UseRealTime()->Complexity();

}  // namespace
}  // namespace abut::benchmarks
