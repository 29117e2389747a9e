// SPDX-License-Identifier: GPL-3.0-or-later
// `contacts` and `analyze` find the same: rows, lengths, rules, order, and what overlaps.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "geometry/csg/overlap.hpp"
#include "src/contact/candidates.hpp"
#include "src/contact/detect.hpp"
#include "src/results/result_units.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::one_search_test {
namespace {

const std::string source = ABUT_SOURCE_DIR;

/// Parts by name and geometry, with more members of the scene.
Scene scene_of(const std::string& parts, const std::string& more = "") {
    return read_scene_text(
        R"({"abut": 1, "units": {"length": "mm", "force": "N"}, "materials": {"m": {"E": 1e5, "nu": 0.3}}, "parts": [)" +
            parts + "]" + more + "}",
        "scene.json");
}

std::string part(const std::string& name, const std::string& geometry) {
    return R"({"name": ")" + name + R"(", "material": "m", "geometry": )" + geometry + "}";
}

std::string block(const std::string& name, const std::string& min, const std::string& max) {
    return part(name, R"({"rectangle": {"min": )" + min + R"(, "max": )" + max + "}}");
}

std::string disc(const std::string& name, double y) {
    return part(name, R"({"circle": {"center": [0, )" + std::to_string(y) + R"(], "radius": 1}})");
}

const std::string base = block("base", "[-9, -9]", "[9, 0]");

std::vector<std::string> lines_of(const Scene& scene) {
    std::vector<std::string> lines;
    try {
        find_candidates(scene, 1);
    } catch (const InputError& error) {
        for (const Problem& p : error.problems()) lines.push_back(one_line(p));
    }
    return lines;
}

void expect_same_rows(const Scene& scene) {
    const std::vector<Candidate> candidates = find_candidates_anyway(scene, 1);
    const std::vector<DetectedPair> rows = detect_contacts(scene, std::nullopt).pairs;
    std::size_t shown = 0;
    while (shown < candidates.size() && candidates[shown].shown) ++shown;
    for (std::size_t k = shown; k < candidates.size(); ++k) EXPECT_FALSE(candidates[k].shown) << k;
    ASSERT_GE(rows.size(), shown);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        if (k >= shown) {
            EXPECT_EQ(rows[k].length, 0) << k;  // a place where no faces oppose each other
            continue;
        }
        const Candidate& c = candidates[k];
        EXPECT_EQ(rows[k].part, (std::array{c.first, c.second})) << k;
        EXPECT_EQ(rows[k].length, c.zone.end1 - c.zone.begin1) << k;
        EXPECT_LE(rows[k].gap_min, c.zone.gap_min - c.interference) << k;  // less at corners
        EXPECT_EQ(rows[k].gap_max, c.zone.gap_max - c.interference) << k;
    }
}

TEST(OneSearch, ContactsAndAnalyzeListTheSameRows) {
    int n = 0;
    for (const char* folder : {"/data/scenes", "/data/verification"})
        for (const auto& entry : std::filesystem::directory_iterator(source + folder)) {
            if (entry.path().extension() != ".json") continue;
            SCOPED_TRACE(entry.path().filename().string());
            expect_same_rows(read_scene(entry.path().string()));
            ++n;
        }
    EXPECT_GT(n, 50);
}

TEST(OneSearch, ResultsHaveTheOrderOfContacts) {
    // far: a zone that only the analysis looks at, of parts that come first
    const Scene scene = scene_of(
        block("far", "[0, 2.3]", "[4, 4.3]") + "," + block("base", "[-5, -5]", "[5, 0]") + "," +
            block("b", "[0, 0]", "[4, 2]") + "," + block("c", "[-4, 0]", "[-1, 2]"),
        R"(, "supports": [{"on": ["base/bottom", "far/top"], "fix": ["x", "y"]}, {"on": ["b/left", "c/left"], "fix": ["x"]}],
        "loads": [{"on": ["b/top", "c/top"], "pressure": 1}], "accuracy": {"level": "draft"}, "contacts": {"search_distance": 0.4})");
    Scene as_default = scene;
    as_default.contacts.search_distance.reset();
    const std::vector<DetectedPair> rows = detect_contacts(as_default, std::nullopt).pairs;
    ASSERT_EQ(rows.size(), 2U);
    const std::vector<Candidate> wide = find_candidates(as_default, 3);
    ASSERT_EQ(wide.size(), 3U);
    for (std::size_t k = 0; k < rows.size(); ++k) EXPECT_EQ(rows[k].part, (std::array{wide[k].first, wide[k].second}));
    EXPECT_EQ(wide[2].first, 0);
    EXPECT_EQ(contact_number(0), "1");  // what people read, and contact_1.csv
}

TEST(OneSearch, OfSeveralRulesTheLastCounts) {
    const std::string parts = base + "," + block("b", "[0, 0]", "[4, 2]");
    const auto rows = [&](const std::string& rules) {
        return detect_contacts(scene_of(parts, R"(, "contacts": {"pairs": [)" + rules + "]}"), std::nullopt).pairs.size();
    };
    const std::string leave = R"({"between": ["base/*", "b/*"], "kind": "ignore"})",
                      take = R"({"between": ["base/top", "b/bottom"], "interference": 0.01})";
    EXPECT_EQ(rows(leave), 0U);
    EXPECT_EQ(rows(leave + "," + take), 1U);
    EXPECT_EQ(rows(take + "," + leave), 0U);
    const Scene only_ruled =
        scene_of(parts + "," + block("c", "[-4, 0]", "[-1, 2]"), R"(, "contacts": {"detect": false, "pairs": [)" + take + "]}");
    const std::vector<DetectedPair> found = detect_contacts(only_ruled, std::nullopt).pairs;
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].parts[1], "b");
    EXPECT_NEAR(found[0].gap_min, -0.01, 1e-12);
    EXPECT_EQ(found[0].status, "touching");
    expect_same_rows(only_ruled);
}

// ---- overlaps of any depth ----

TEST(DeepOverlaps, AreRefusedHoweverDeep) {
    for (const double share : {0.005, 0.02, 0.04, 0.1, 0.4, 0.9, 1.0, 1.5}) {  // of the diameter
        SCOPED_TRACE(share);
        const double depth = 2 * share;
        const Scene scene = scene_of(base + "," + disc("d", 1 - depth));
        const std::vector<std::string> lines = lines_of(scene);
        ASSERT_EQ(lines.size(), 1U);
        const std::vector<DetectedPair> rows = detect_contacts(scene, std::nullopt).pairs;
        ASSERT_EQ(rows.size(), 1U);
        EXPECT_EQ(rows[0].status, "overlap");
        EXPECT_EQ(rows[0].between, (std::array<std::string, 2>{"base/top", "d/circle"}));
        EXPECT_NE(lines[0].find(rows[0].why.substr(0, rows[0].why.find(':'))), std::string::npos) << lines[0] << "\n"
                                                                                                  << rows[0].why;
        const double inside = std::min(1.0, depth - 1);  // of the centre
        const double area = share >= 1 ? std::numbers::pi : std::acos(-inside) + inside * std::sqrt(1 - inside * inside);
        EXPECT_NEAR(rows[0].overlap_area, area, 1e-9);
        EXPECT_NEAR(-rows[0].gap_min, depth, 0.005 * depth);
    }
}

TEST(DeepOverlaps, OnePartAcrossAnotherWithoutVerticesInside) {
    const Scene scene = scene_of(block("beam", "[-20, -0.5]", "[20, 0.5]") + "," + block("post", "[-0.25, -30]", "[0.25, 30]"));
    const std::vector<std::string> lines = lines_of(scene);
    ASSERT_EQ(lines.size(), 1U);
    for (const char* word : {"parts beam and post overlap by up to 0.5 mm", "area 0.5", "move them apart", "\"ignore\""})
        EXPECT_NE(lines[0].find(word), std::string::npos) << word << ": " << lines[0];
    EXPECT_EQ(detect_contacts(scene, std::nullopt).pairs.size(), 1U);
}

TEST(DeepOverlaps, AreNoPressFits) {
    const auto refused = [](const std::string& parts, const std::string& contacts) {
        return lines_of(scene_of(parts, R"(, "contacts": )" + contacts));
    };
    const std::string shallow = base + "," + disc("d", 0.98), deep = base + "," + disc("d", 0.8),
                      across = block("beam", "[-20, -0.5]", "[20, 0.5]") + "," + block("post", "[-0.25, -30]", "[0.25, 30]");
    for (const char* allowed : {R"({"overlap": "press_fit"})", R"({"overlap": "ignore"})"}) {
        EXPECT_TRUE(refused(shallow, allowed).empty());
        EXPECT_EQ(refused(deep, allowed).size(), 1U);
        EXPECT_EQ(refused(across, allowed).size(), 1U);
    }
    EXPECT_NE(refused(deep, R"({"overlap": "press_fit"})")[0].find("no press fit"), std::string::npos);
    EXPECT_NE(refused(deep, R"({"overlap": "ignore"})")[0].find("too deep to count as touching"), std::string::npos);
    // searched less far than the parts are pressed together, nothing would press
    EXPECT_EQ(refused(shallow, R"({"overlap": "press_fit", "search_distance": 0.01})").size(), 1U);
    // left alone on purpose
    EXPECT_TRUE(refused(deep, R"({"pairs": [{"between": ["base/*", "d/*"], "kind": "ignore"}]})").empty());
    EXPECT_TRUE(refused(deep, R"({"detect": false})").empty());
}

TEST(DeepOverlaps, PartsInTheSamePlace) {
    for (const std::string& other : {block("b", "[-9, -9]", "[9, 0]"), block("b", "[-4, -4]", "[-3, -3]")}) {
        const std::vector<std::string> lines = lines_of(scene_of(base + "," + other));
        ASSERT_EQ(lines.size(), 1U);
        EXPECT_NE(lines[0].find("lie in the same place"), std::string::npos) << lines[0];
    }
}

TEST(DeepOverlaps, DepthIsThatOfTheDeepestPoint) {
    const Scene scene = scene_of(base + "," + block("b", "[0, -0.3]", "[4, 2]"));
    const geometry::Overlap common = overlap(scene.parts[0].part, scene.parts[1].part, 1e-9);
    EXPECT_NEAR(common.depth, 0.3, 1e-12);
    EXPECT_NEAR(common.area, 1.2, 1e-12);
    EXPECT_EQ(scene.parts[0].part.edges.at(static_cast<std::size_t>(common.edge1)).name, "top");
    EXPECT_EQ(scene.parts[1].part.edges.at(static_cast<std::size_t>(common.edge2)).name, "bottom");
    EXPECT_EQ(overlap(scene.parts[0].part, scene_of(disc("d", 1)).parts[0].part, 1e-9).depth, 0);
}

}  // namespace
}  // namespace abut::one_search_test
