// SPDX-License-Identifier: GPL-3.0-or-later
// Parts without a common level have nothing to do with each other, in every search.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "src/analysis/analysis.hpp"
#include "src/contact/candidates.hpp"
#include "src/contact/detect.hpp"
#include "src/plan/plan.hpp"
#include "src/scene/part_levels.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::levels_test {
namespace {

std::string text(double value) {
    return std::to_string(value);
}

std::string rectangle(double x0, double y0, double x1, double y1) {
    return R"({"rectangle": {"min": [)" + text(x0) + ", " + text(y0) + "], \"max\": [" + text(x1) + ", " + text(y1) + "]}}";
}

std::string part(const std::string& name, const std::string& geometry, const std::string& level) {
    return R"({"name": ")" + name + R"(", "material": "steel", )" + (level.empty() ? "" : "\"level\": " + level + ", ") +
           "\"geometry\": " + geometry + "}";
}

Scene scene_of(const std::string& parts, const std::string& more = "") {
    return read_scene_text(
        R"({"abut": 1, "units": {"length": "mm", "force": "N"}, "thickness": 10, "parts": [)" + parts + "]" + more + "}",
        "s.json");
}

/// Blocks on a raster, so that they touch, overlap, and miss each other.
Scene random_scene(std::mt19937& random) {
    const auto number = [&](int most) { return static_cast<int>(random() % static_cast<unsigned>(most)); };
    std::string parts;
    for (int k = 0; k < 9; ++k) {
        const double x = number(6), y = number(6);
        const std::string geometry = number(4) == 0
                                         ? R"({"circle": {"center": [)" + text(x) + ", " + text(y) + R"(], "radius": 1}})"
                                         : rectangle(x, y, x + 1 + number(3), y + 1 + number(3));
        parts += (k == 0 ? "" : ", ") + part("p" + std::to_string(k), geometry, "");
    }
    Scene scene = scene_of(parts);
    for (ScenePart& p : scene.parts)
        for (int level = 1; level <= 3; ++level)
            if (number(3) == 0) p.level.push_back(level);
    return scene;
}

using Rows = std::vector<std::string>;

/// What is found of pairs that have a common level by `levels`.
Rows rows_of(const std::vector<DetectedPair>& pairs, const Scene& levels) {
    Rows rows;
    for (const DetectedPair& p : pairs)
        if (have_common_level(scene_part(levels, p.part[0]).level, scene_part(levels, p.part[1]).level))
            rows.push_back(p.between[0] + " " + p.between[1] + " " + p.status + " " + text(p.length) + " " + p.why);
    return rows;
}

Rows rows_of(const std::vector<Candidate>& candidates, const Scene& levels) {
    Rows rows;
    for (const Candidate& c : candidates)
        if (have_common_level(scene_part(levels, c.first).level, scene_part(levels, c.second).level))
            rows.push_back(text(c.first) + " " + text(c.second) + " " + text(c.zone.begin1) + " " + text(c.zone.end1) + " " +
                           text(c.zone.gap_min));
    return rows;
}

/// A pin in the eyes of two links that overlap, pulled apart.
const std::string eye = R"({"name": "eye", "circle": {"center": [0, 0], "radius": 6}})";
std::string link(double to, const std::string& level) {
    return part(to < 0 ? "left" : "right",
                R"({"difference": [{"name": "plate", "slot": {"from": [0, 0], "to": [)" + text(to) +
                    R"(, 0], "radius": 15}}, )" + eye + R"(, {"name": "end", "circle": {"center": [)" + text(to) +
                    R"(, 0], "radius": 5}}]})",
                level);
}
const std::string pin = part("pin", R"({"circle": {"center": [0, 0], "radius": 6}})", "[1, 2]");
const std::string draft = R"(, "accuracy": {"level": "draft"})";
const std::string pulled =
    draft +
    R"(, "supports": [{"on": "left/end/circle", "fix": ["x", "y"]}], "loads": [{"on": "right/end/circle", "force": [5000, 0]}])";

}  // namespace

TEST(Levels, ThePairsAreThoseOfTheSearchWithoutLevelsThatHaveOneInCommon) {
    std::mt19937 random(20);
    std::size_t n_left = 0, n_dropped = 0;
    for (int k = 0; k < 60; ++k) {
        const Scene scene = random_scene(random);
        Scene plain = scene;
        for (ScenePart& p : plain.parts) p.level.clear();
        const Detection found = detect_contacts(scene, std::nullopt), all = detect_contacts(plain, std::nullopt);
        EXPECT_EQ(rows_of(found.pairs, plain), rows_of(all.pairs, scene)) << k;
        EXPECT_EQ(rows_of(found.near_misses, plain), rows_of(all.near_misses, scene)) << k;
        EXPECT_EQ(rows_of(find_candidates_anyway(scene, 1), plain), rows_of(find_candidates_anyway(plain, 1), scene)) << k;
        n_left += found.pairs.size();
        n_dropped += all.pairs.size() - found.pairs.size();
    }
    EXPECT_GT(n_left, 60u);
    EXPECT_GT(n_dropped, 60u);
}

TEST(Levels, SoAreThoseOfTheSearchByCells) {
    const std::string parts = part("a", rectangle(0, 0, 4, 2), "1") + ", " + part("b", rectangle(0, 2, 4, 4), "2") + ", " +
                              part("c", rectangle(4, 0, 6, 4), "[1, 2]");
    const Scene scene = scene_of(parts, R"(, "accuracy": {"method": "dissertation", "cell_size": 0.5})");
    std::set<std::array<int, 2>> pairs;
    for (const DetectedPair& p : detect_contacts(scene, std::nullopt).pairs) pairs.insert(p.part);
    EXPECT_EQ(pairs, (std::set<std::array<int, 2>>{{0, 2}, {1, 2}}));
    for (const Candidate& c : find_candidates_anyway(scene, 1)) EXPECT_EQ(c.second, 2);
}

TEST(Levels, OverlapsAreRefusedOnACommonLevelAlone) {
    const auto overlapping = [](const std::string& first, const std::string& second) {
        return scene_of(part("a", rectangle(0, 0, 4, 2), first) + ", " + part("b", rectangle(1, 1, 5, 5), second));
    };
    EXPECT_TRUE(find_candidates(overlapping("1", "2"), 1).empty());
    EXPECT_TRUE(detect_contacts(overlapping("1", "2"), std::nullopt).pairs.empty());
    for (const auto& [first, second] :
         {std::pair<std::string, std::string>{"", ""}, {"1", ""}, {"1", "1"}, {"[1, 2]", "[2, 3]"}}) {
        EXPECT_EQ(detect_contacts(overlapping(first, second), std::nullopt).pairs.size(), 1u);
        try {
            find_candidates(overlapping(first, second), 1);
            FAIL() << first << " " << second;
        } catch (const InputError& error) {
            EXPECT_NE(error.problems()[0].hint.find("give each its own \"level\" where they lie above each other"),
                      std::string::npos);
        }
    }
}

TEST(Levels, ThePlanSearchesNoOtherPairs) {
    const Scene scene = scene_of(link(-60, "1") + ", " + link(60, "2") + ", " + pin, pulled);
    const std::vector<Effect> effects = plan_effects(scene, resolve_conditions(scene));
    const auto contact =
        std::find_if(effects.begin(), effects.end(), [](const Effect& effect) { return effect.name == "contact"; });
    ASSERT_NE(contact, effects.end());
    EXPECT_EQ(contact->pairs, (std::vector<std::array<std::string, 2>>{{"left", "pin"}, {"right", "pin"}}));
}

TEST(Levels, APinThatJoinsTwoLinksCarriesThePullOnEach) {
    const Result result = analyze(scene_of(link(-60, "1") + ", " + link(60, "2") + ", " + pin, pulled), {});
    ASSERT_EQ(result.status, "ok") << result.message;
    ASSERT_EQ(result.contacts.size(), 2u);
    // forces on the links, which come first
    EXPECT_NEAR(result.contacts[0].force.x(), 5000, 5000 * 1e-9);
    EXPECT_NEAR(result.contacts[1].force.x(), -5000, 5000 * 1e-9);
    EXPECT_NEAR(result.contacts[0].force.y(), 0, 5000 * 1e-9);
    EXPECT_LT(result.equilibrium.relative_residual, 1e-9);
    EXPECT_LT(result.equilibrium.relative_moment_residual, 1e-9);
    EXPECT_EQ(result.parts[2].level, (Levels{1, 2}));
}

TEST(Levels, WhatLiesAboveAnswersAsIfItLayBeside) {
    // two stacks of a block on a base: the second drawn over the first, or 64 to the right, which rounds nothing
    const auto stacks = [](double right, const std::string& first, const std::string& second) {
        std::string parts, supports, loads;
        for (const auto& [name, x, level] :
             {std::tuple<std::string, double, std::string>{"1", 0, first}, {"2", right, second}}) {
            parts += (parts.empty() ? "" : ", ") + part("base" + name, rectangle(x, 0, x + 8, 4), level) + ", " +
                     part("top" + name, rectangle(x + 2, 4, x + 6, 8), level);
            supports +=
                (supports.empty() ? "" : ", ") + std::string(R"({"on": "base)") + name + R"(/bottom", "fix": ["x", "y"]})";
            loads += (loads.empty() ? "" : ", ") + std::string(R"({"on": "top)") + name + R"(/top", "pressure": )" +
                     (name == "1" ? "10" : "\"4 + y\"") + "}";
        }
        return analyze(scene_of(parts, draft + R"(, "supports": [)" + supports + R"(], "loads": [)" + loads + "]"), {});
    };
    const Result above = stacks(1, "1", "2"), beside = stacks(64, "", "");
    ASSERT_EQ(above.contacts.size(), 2u);
    ASSERT_EQ(beside.contacts.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_EQ(above.contacts[k].between, beside.contacts[k].between);
        EXPECT_NEAR(above.contacts[k].force.y(), beside.contacts[k].force.y(), 1e-9 * std::abs(beside.contacts[k].force.y()));
        EXPECT_NEAR(above.contacts[k].max_pressure.value, beside.contacts[k].max_pressure.value,
                    1e-9 * beside.contacts[k].max_pressure.value);
    }
    EXPECT_EQ(above.unknowns, beside.unknowns);
    EXPECT_NEAR(above.strain_energy, beside.strain_energy, 1e-9 * beside.strain_energy);
}

}  // namespace abut::levels_test
