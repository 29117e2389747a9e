// SPDX-License-Identifier: GPL-3.0-or-later
// What contact costs beside the factorisations: all passes of every scene, milliseconds by step. "share": contact iterations
// (start, active sets) over factorisations.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "src/analysis/adaptive.hpp"
#include "tests/benchmarks/benchmark_scenes.hpp"

namespace abut::benchmarks {
namespace {

void steps_of(benchmark::State& state, const std::string& path) {
    const Scene scene = scene_file(path);
    AnalyzeOptions options;
    options.threads = 1;
    std::map<std::string, double> least;
    Outcome out;
    for (auto _ : state) {
        Stopwatches seconds;
        out = solve_adaptively(scene, resolve_conditions(scene), options, seconds);
        for (const auto& [stage, s] : seconds) least[stage] = least.contains(stage) ? std::min(least[stage], s) : s;
    }
    for (const char* stage :
         {"assembly", "factorisation", "rows", "condensation", "contact iterations", "displacements", "solve"})
        state.counters[stage] = 1e3 * least[stage];
    state.counters["share"] = least["contact iterations"] / least["factorisation"];
    state.counters["multipliers"] = out.solved.solution.n_multipliers;
    state.counters["iterations"] = out.iterations;
    state.counters["passes"] = static_cast<double>(out.passes.size());
}

const bool registered = [] {
    for (const char* folder : {"data/verification", "data/scenes"}) {
        std::vector<std::string> files;
        for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(ABUT_SOURCE_DIR) / folder))
            if (entry.path().extension() == ".json") files.push_back(entry.path().filename().string());
        std::sort(files.begin(), files.end());
        for (const std::string& file : files)
            benchmark::RegisterBenchmark(("contact_share/" + file).c_str(), steps_of, std::string(folder) + "/" + file)
                ->Unit(benchmark::kMillisecond)
                ->Iterations(5);
    }
    return true;
}();

}  // namespace
}  // namespace abut::benchmarks
