// SPDX-License-Identifier: GPL-3.0-or-later
// Assemblies made up from seeds, by hand:
//   abut_assemblies dump KIND SEED                    the scene
//   abut_assemblies properties FIRST COUNT [KIND]     what is wrong with each, drawn and changed
//   abut_assemblies estimates FIRST COUNT [KIND]      estimated errors over true ones, a line for each; a table of them
//   abut_assemblies against FILE                      the same against independent finite elements
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "src/scene/read_scene.hpp"
#include "tests/generated/estimate_table.hpp"
#include "tests/generated/same_answer.hpp"

namespace abut::test {
namespace {

struct Range {
    std::uint64_t first, count;
    std::vector<std::string> kinds;
};

Range range_of(const std::vector<std::string>& words) {
    Range r{std::stoull(words.at(1)), std::stoull(words.at(2)), assembly_kinds()};
    if (words.size() > 3) r.kinds = {words.begin() + 3, words.end()};
    return r;
}

void print_properties(const Range& range) {
    for (const std::string& kind : range.kinds)
        for (std::uint64_t seed = range.first; seed < range.first + range.count; ++seed) {
            const auto begin = std::chrono::steady_clock::now();
            const std::string scene = random_scene(kind, seed);
            const Answer drawn = answer_of(read_scene_text(scene, "assembly.json"));
            const auto faults = faults_of_assembly(scene, changes_of(seed));
            const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
            std::printf("%s %d: %zu faults, %.1f s%s\n", kind.c_str(), static_cast<int>(seed), faults.size(), taken.count(),
                        drawn.refused ? (", refused: " + drawn.message).c_str() : "");
            for (const std::string& line : faults) std::printf("    %s\n", line.c_str());
            std::fflush(stdout);
        }
}

void print_estimates(const Range& range) {
    EstimateTable table;
    for (std::uint64_t seed = range.first; seed < range.first + range.count; ++seed)
        for (const std::string& kind : range.kinds) {
            table.add(kind + " " + std::to_string(seed), read_scene_text(random_scene(kind, seed), "assembly.json"));
            std::fprintf(stderr, "%s %d\n", kind.c_str(), static_cast<int>(seed));
        }
    std::cout << table.rows() << table.summary();
}

void print_against(const std::string& path) {
    EstimateTable table;
    std::ifstream file(path);
    const nlohmann::json all = nlohmann::json::parse(file);
    for (const nlohmann::json& one : all.at("scenes")) table.add_against(one.dump());
    std::cout << table.rows() << table.summary();
}

int run(const std::vector<std::string>& words) {
    const std::string what = words.empty() ? "" : words[0];
    if (what == "dump")
        std::cout << random_scene(words.at(1), std::stoull(words.at(2))) << "\n";
    else if (what == "properties")
        print_properties(range_of(words));
    else if (what == "estimates")
        print_estimates(range_of(words));
    else if (what == "against")
        print_against(words.at(1));
    else
        return 2;
    return 0;
}

}  // namespace
}  // namespace abut::test

int main(int count, char** words) {
    return abut::test::run({words + 1, words + count});
}
