// SPDX-License-Identifier: GPL-3.0-or-later
// Everything in the folder of real inputs: read or refused with one clear line, at once; and no contacts where none are drawn.
// The files lie beside the checkout; without them these tests are skipped.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <set>

#include "geometry/brep/input_error.hpp"
#include "src/contact/detect.hpp"
#include "src/inspection/inspect.hpp"
#include "src/scene/read_sketch.hpp"

namespace abut::inputs_test {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

const std::string inputs = std::string(ABUT_SOURCE_DIR) + "/../shared/inputs/";

std::vector<std::string> files_in(const std::string& folder) {
    std::vector<std::string> paths;
    if (!fs::exists(folder)) return paths;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

bool is_clear_line(const Problem& problem) {
    const std::string line = one_line(problem);
    return line.find('\n') == std::string::npos && !problem.what.empty() && !problem.hint.empty();
}

/// A scene that is none has a line for each of its faults; all else has one, for the file.
bool may_have_many(const std::string& path) {
    return fs::path(path).extension() == ".json";
}

struct Outcome {
    bool is_refused = false;
    int n_parts = 0;
};

/// As `inspect -o` and `contacts` go through a file.
Outcome try_file(const std::string& path) {
    try {
        const Inspection inspection = inspect_file(path, {});
        EXPECT_FALSE(inspection_table(inspection).empty());
        EXPECT_FALSE(inspection_json(inspection).empty());
        EXPECT_FALSE(inspection_svg(inspection).empty());
        for (const geometry::SketchProblem& p : inspection.problems)
            EXPECT_TRUE(is_clear_line({path, p.what, p.hint})) << path << ": " << p.what;
        EXPECT_TRUE(!inspection.problems.empty() || !inspection.scene.parts.empty()) << path << ": nothing, and no word of it";
        detect_contacts(inspection.scene, std::nullopt);
        return {false, static_cast<int>(inspection.scene.parts.size())};
    } catch (const InputError& error) {
        EXPECT_TRUE(may_have_many(path) || error.problems().size() == 1) << path;
        for (const Problem& problem : error.problems()) EXPECT_TRUE(is_clear_line(problem)) << one_line(problem);
        return {true, 0};
    }
}

/// What is drawn as contact or overlap in files of public/, with the reason, as found by looking at pictures of them.
const std::map<std::string, std::set<std::string>> drawn_in_public{
    // Layers are operations of a milling machine: pockets are drawn across the outline that they are cut into, holes inside
    // the pockets around them.
    {"dxfjs__issue39.dxf", {"overlap"}},
    // Two insertions of one block in different sizes, drawn across each other to try that out.
    {"dxfjs__blocks1.dxf", {"overlap"}},
    // Made from a wrench and its mirror image, which lie on each other.
    {"derived_nested_mirrored_pair.dxf", {"overlap"}},
    // Made as an assembly: two rails side by side, and one on top with a gap of 0.02 mm.
    {"derived_vslot_three.dxf", {"touching"}},
    // Profiles of one solid, drawn across each other, and loose lines.
    {"openscad__example007.dxf", {"overlap"}},
    {"openscad__example009.dxf", {"overlap"}},
    // Two areas that share a line, and loose lines.
    {"trimesh__ae.r12b.dxf", {"touching"}},
    {"trimesh__ae.r2000a.dxf", {"touching"}},
};

/// As `contacts` finds them: none where something could not be read.
std::set<std::string> statuses_of(const std::string& path) {
    std::set<std::string> statuses;
    const SketchReading reading = read_sketch(path, {});
    if (!reading.drawing.problems.empty() || !reading.sketch.problems.empty()) return statuses;
    for (const DetectedPair& pair : detect_contacts(reading.scene, std::nullopt).pairs)
        if (pair.status != "gap") statuses.insert(pair.status);
    return statuses;
}

}  // namespace

TEST(Inputs, EveryFileIsReadOrRefusedWithOneLineAtOnce) {
    const std::vector<std::string> paths = files_in(inputs);
    if (paths.empty()) GTEST_SKIP() << "the files are not here";
    int n_with_parts = 0;
    for (const std::string& path : paths) {
        const Clock::time_point begin = Clock::now();
        const Outcome outcome = try_file(path);
        // drawings with a fault each, one of them by its number of crossings
        const bool is_drawn_badly = path.find("/inputs/drawn/") != std::string::npos;
        const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        if (!is_drawn_badly) { EXPECT_LT(seconds, 5) << path; }
        n_with_parts += outcome.n_parts > 0;
        const std::string kind = fs::path(path).extension().string();
        const bool is_other = kind == ".txt" || kind == ".md" || kind == ".csv";
        EXPECT_TRUE(outcome.is_refused || !is_other) << path;
    }
    EXPECT_GE(n_with_parts, 60);  // of 72 drawings and meshes; the others are open, crossing, truncated or no drawing
}

TEST(Inputs, NestsHaveNoContactsButThoseDrawn) {
    const std::vector<std::string> paths = files_in(inputs + "public/");
    if (paths.empty()) GTEST_SKIP() << "the files are not here";
    std::size_t n_with_contacts = 0;
    for (const std::string& path : paths) {
        const std::string name = fs::path(path).filename().string();
        if (!is_importable(path)) continue;
        std::set<std::string> statuses;
        try {
            statuses = statuses_of(path);
        } catch (const InputError&) { continue; }
        const auto drawn = drawn_in_public.find(name);
        EXPECT_EQ(statuses, drawn == drawn_in_public.end() ? std::set<std::string>() : drawn->second) << name;
        n_with_contacts += !statuses.empty();
    }
    EXPECT_EQ(n_with_contacts, drawn_in_public.size());
}

}  // namespace abut::inputs_test
