// SPDX-License-Identifier: GPL-3.0-or-later
// Tightened parts, from the scene to the answer. Closed forms: verify's H2.
#include <gtest/gtest.h>

#include "geometry/brep/input_error.hpp"
#include "src/analysis/analysis.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::preload_test {
namespace {

constexpr double F0 = 1000, kb = 20000, kp = 30000;

/// Two bolts between rigid plates that two bars hold apart; turned by `turn` degrees about the origin. gap:
/// that the bars lack; along: how far their means are moved along the bolts.
std::string scene(const std::string& loads, double gap = 0, double turn = 0, const std::string& along = "0") {
    const auto rect = [&](double x0, double y0, double x1, double y1) {
        return R"({"place": {"of": {"rectangle": {"min": [)" + std::to_string(x0) + ", " + std::to_string(y0) +
               R"(], "max": [)" + std::to_string(x1) + ", " + std::to_string(y1) + R"(]}}, "rotate": )" + std::to_string(turn) +
               "}}";
    };
    const auto part = [](const std::string& name, const std::string& material, const std::string& geometry) {
        return R"({"name": ")" + name + R"(", "material": ")" + material + R"(", "geometry": )" + geometry + "}";
    };
    return R"({"abut": 1, "materials": {"bolt": {"E": 2e5, "nu": 0}, "bar": {"E": 1e5, "nu": 0}}, "parts": [)" +
           part("below", "rigid", rect(-40, -10, 40, 0)) + ", " + part("above", "rigid", rect(-40, 100, 40, 110)) + ", " +
           part("a", "bolt", rect(-10, 0, -5, 100)) + ", " + part("b", "bolt", rect(5, 0, 10, 100)) + ", " +
           part("left", "bar", rect(-30, 0, -15, 100 - gap)) + ", " + part("right", "bar", rect(15, 0, 30, 100 - gap)) +
           R"(], "contacts": {"pairs": [{"between": ["a/*", "below/*"], "kind": "bonded"},
               {"between": ["a/*", "above/*"], "kind": "bonded"}, {"between": ["b/*", "below/*"], "kind": "bonded"},
               {"between": ["b/*", "above/*"], "kind": "bonded"}]},
             "supports": [{"on": "below/bottom", "fix": ["x", "y"]},
               {"part": "left", "rigid": {"translation": [0, )" +
           along + R"(], "rotation": 0}},
               {"part": "right", "rigid": {"translation": [0, )" +
           along + R"(], "rotation": 0}}],
             "loads": [)" +
           loads + "]}";
}

std::string preload(const std::string& part, const std::string& across, double force) {
    return R"({"part": ")" + part + R"(", "preload": {"across": )" + across + R"(, "force": )" + std::to_string(force) + "}}";
}

std::string message_of(const std::string& text) {
    try {
        const Result r = analyze(read_scene_text(text, "s.json"), {});
        return r.status + ": " + r.message;
    } catch (const InputError& error) { return error.problems().front().what; }
}

/// One bolt's bar in a frame of its own: shortened, held at both ends.
TEST(Preload, HeldBarCarriesWhatItIsTightenedTo) {
    const std::string text = R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0}},
      "parts": [{"name": "bar", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [10, 1]}}}],
      "supports": [{"on": "bar/left", "fix": ["x", "y"]}, {"on": "bar/right", "fix": ["x"]}],
      "loads": [)" + preload("bar", "[[4, -1], [4.5, 2]]", 3) +
                             R"(], "output": {"probes": [{"part": "bar", "at": [8, 0.5]}]}})";
    const Result r = analyze(read_scene_text(text, "s.json"), {});
    ASSERT_EQ(r.status, "ok") << r.message;
    ASSERT_EQ(r.preloads.size(), 1u);
    EXPECT_NEAR(r.preloads[0].force_under_load, 3, 1e-8);
}

TEST(Preload, StressIsUniformAwayFromTheCutAndInIt) {
    for (double x : {2.0, 4.0, 5.1, 8.0}) {
        const std::string text = R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0}},
      "parts": [{"name": "bar", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [10, 1]}}}],
      "supports": [{"on": "bar/left", "fix": ["x", "y"]}, {"on": "bar/right", "fix": ["x"]}],
      "loads": [)" + preload("bar", "[[4, -1], [4, 2]]", 3) +
                                 R"(], "output": {"probes": [{"part": "bar", "at": [)" + std::to_string(x) + R"(, 0.5]}]}})";
        const Result r = analyze(read_scene_text(text, "s.json"), {});
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_NEAR(r.probes.at(0).stress.xx, 3, 1e-7) << x;
        EXPECT_NEAR(r.preloads[0].shortening, 3.0 * 10 / 1000, 1e-9);
    }
}

/// A cell that a cut goes through has both of its sides, which meet where the cut was drawn.
TEST(Preload, TheSidesOfACutAreApart) {
    for (const char* across : {"[[4.3, -1], [4.3, 2]]", "[[4.3, 2], [4.3, -1]]"}) {
        const std::string text =
            R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0}},
          "parts": [{"name": "bar", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [10, 1]}}}],
          "supports": [{"on": "bar/left", "fix": ["x", "y"]}, {"on": "bar/right", "fix": ["x"]}],
          "loads": [)" +
            preload("bar", across, 3) +
            R"(], "output": {"probes": [{"part": "bar", "at": [4.29, 0.5]}, {"part": "bar", "at": [4.31, 0.5]}]}})";
        const Result r = analyze(read_scene_text(text, "s.json"), {});
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_NEAR(r.probes.at(0).displacement.x(), 0.003 * 4.29, 1e-8) << across;
        EXPECT_NEAR(r.probes.at(1).displacement.x(), 0.003 * (4.31 - 10), 1e-8) << across;
        const PartResult& bar = r.parts.at(0);
        EXPECT_NEAR(bar.max_displacement.value, 0.003 * 5.7, bar.max_displacement_error.value() * 0.003 * 5.7);
        EXPECT_LT(bar.max_displacement_error.value(), 0.1);
    }
}

TEST(Preload, WhatDoesNotPartThePartIsRefused) {
    const auto ring = [](const std::string& across) {
        return R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}},
          "parts": [{"name": "ring", "material": "m", "geometry": {"difference": [{"circle": {"center": [0, 0], "radius": 2}},
            {"circle": {"center": [0, 0], "radius": 1}}]}}],
          "supports": [{"on": "ring/*", "fix": ["x", "y"]}], "loads": [)" +
               preload("ring", across, 1) + "]}";
    };
    EXPECT_NE(message_of(ring("[[0.5, 0], [2.5, 0]]")).find("it does not part it in two"), std::string::npos);
    EXPECT_NE(message_of(ring("[[1.5, 0], [2.5, 0]]")).find("it does not part it in two"), std::string::npos);
    EXPECT_NE(message_of(ring("[[3, 0], [4, 0]]")).find("it does not part it in two"), std::string::npos);
    EXPECT_NE(message_of(ring("[[0, 0], [0, 0]]")).find("are one point"), std::string::npos);
    EXPECT_NE(message_of(ring("[[0, 0]]")).find("points"), std::string::npos);
    EXPECT_NE(message_of(scene(preload("above", "[[0, 90], [0, 120]]", 1))).find("it is rigid"), std::string::npos);
    EXPECT_NE(message_of(scene(preload("a", "[[-12, 50], [-4, 50]]", -1))).find("a force above 0"), std::string::npos);
    EXPECT_NE(message_of(scene(R"({"part": "a", "preload": {"across": [[0, 0], [1, 1]]}})")).find("force"), std::string::npos);
}

/// A part that nothing meets at its far end.
TEST(Preload, WhatNothingPressesBackOnCannotBeTightened) {
    const std::string text = R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0}},
      "parts": [{"name": "bar", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [10, 1]}}}],
      "supports": [{"on": "bar/left", "fix": ["x", "y"]}], "loads": [)" +
                             preload("bar", "[[4, -1], [4, 2]]", 3) + "]}";
    EXPECT_NE(message_of(text).find("nothing presses back"), std::string::npos) << message_of(text);
}

TEST(Preload, CutsOneBehindTheOtherAreNamed) {
    const std::string text = R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0}},
      "parts": [{"name": "bar", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [10, 1]}}}],
      "supports": [{"on": "bar/left", "fix": ["x", "y"]}, {"on": "bar/right", "fix": ["x"]}], "loads": [)" +
                             preload("bar", "[[3, -1], [3, 2]]", 3) + ", " + preload("bar", "[[6, -1], [6, 2]]", 2) + "]}";
    EXPECT_NE(message_of(text).find("part bar cannot be tightened to"), std::string::npos) << message_of(text);
    EXPECT_NE(message_of(text).find("one behind the other"), std::string::npos) << message_of(text);
}

/// Parts that do not touch are solved by themselves, and are tightened all the same.
TEST(Preload, EveryTightenedPartIsInTheAnswer) {
    const auto bar = [](const std::string& name, double y) {
        return R"({"name": ")" + name + R"(", "material": "m", "geometry": {"rectangle": {"min": [0, )" + std::to_string(y) +
               R"(], "max": [10, )" + std::to_string(y + 1) + "]}}}";
    };
    const auto cut = [](double y) { return "[[4, " + std::to_string(y - 1) + "], [4, " + std::to_string(y + 2) + "]]"; };
    const Result r =
        analyze(read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0}}, "parts": [)" + bar("a", 0) + ", " +
                                    bar("loaded", 20) + ", " + bar("b", 40) +
                                    R"(], "supports": [{"on": ["a/left", "loaded/left", "b/left"], "fix": ["x", "y"]},
                                                     {"on": ["a/right", "b/right"], "fix": ["x"]}],
                                                   "loads": [)" +
                                    preload("b", cut(40), 2) + ", " + preload("a", cut(0), 3) +
                                    R"(, {"on": "loaded/right", "force": [1, 0]}]})",
                                "s.json"),
                {});
    ASSERT_EQ(r.status, "ok") << r.message;
    ASSERT_EQ(r.preloads.size(), 2u);
    for (const PreloadResult& p : r.preloads) EXPECT_NEAR(p.force_under_load, p.part == "a" ? 3 : 2, 1e-8);
}

struct TwoBolts : testing::TestWithParam<std::tuple<double, double>> {};

/// Bolts of half the width each, tightened one after the other's mind: forces are reached together, whatever gap is closed
/// on the way and however the assembly is turned.
TEST_P(TwoBolts, ReachTheirForcesTogether) {
    const auto [gap, turn] = GetParam();
    const double c = std::cos(turn * 3.14159265358979323846 / 180), s = std::sin(turn * 3.14159265358979323846 / 180);
    const auto point = [&](double x, double y) {
        return "[" + std::to_string(c * x - s * y) + ", " + std::to_string(s * x + c * y) + "]";
    };
    const auto across = [&](double x0, double x1, double y) { return "[" + point(x0, y) + ", " + point(x1, y) + "]"; };
    const Result r = analyze(
        read_scene_text(scene(preload("a", across(-12, -4, 50), 600) + ", " + preload("b", across(4, 12, 30), 400), gap, turn),
                        "s.json"),
        {});
    ASSERT_EQ(r.status, "ok") << r.message;
    ASSERT_EQ(r.preloads.size(), 2u);
    EXPECT_NEAR(r.preloads[0].force_under_load, 600, 1e-5);
    EXPECT_NEAR(r.preloads[1].force_under_load, 400, 1e-5);
}
INSTANTIATE_TEST_SUITE_P(Gaps, TwoBolts, testing::Combine(testing::Values(0.0, 0.03), testing::Values(0.0, 17.0)));

/// With a preload that is no load of the case the part is as it was drawn.
TEST(Preload, TakesPartInLoadCases) {
    std::string text = scene(R"({"name": "tight", "part": "a", "preload": {"across": [[-12, 50], [-4, 50]], "force": 500}},
      {"name": "tight", "part": "b", "preload": {"across": [[4, 50], [12, 50]], "force": 500}},
      {"name": "pull", "part": "above", "force": [0, 500]})",
                             0, 0, "null");
    text.back() = ',';
    text += R"("cases": [{"name": "tightened", "loads": {"tight": 1}}, {"name": "loaded", "loads": {"tight": 1, "pull": 1}},
      {"name": "slack", "loads": {"pull": 1}}]})";
    const std::vector<CaseResult> cases = analyze_cases(read_scene_text(text, "s.json"), {});
    ASSERT_EQ(cases.size(), 3u);
    const auto force = [&](std::size_t k) {
        double sum = 0;
        for (const PreloadResult& p : cases[k].result.preloads) sum += p.force_under_load;
        return sum;
    };
    EXPECT_NEAR(force(0), F0, 1e-5);
    EXPECT_NEAR(force(1), F0 + 500 * kb / (kb + kp), 1e-4);
    EXPECT_NEAR(force(2), 500, 1e-5);
}

TEST(Preload, DoesNotPressInACase) {
    std::string text = scene(R"({"name": "tight", "part": "a", "preload": {"across": [[-12, 50], [-4, 50]], "force": 500}})");
    text.back() = ',';
    text += R"("cases": [{"name": "loose", "loads": {"tight": -1}}]})";
    EXPECT_NE(message_of(text).find("its factor is negative"), std::string::npos) << message_of(text);
}

/// One bolt after the other: the one that is not tightened yet carries what the other gives it, as if it had no preload.
TEST(Preload, LeavesBoltsAloneThatAreNotTightenedYet) {
    const std::string first = R"({"name": "first", "part": "a", "preload": {"across": [[-12, 50], [-4, 50]], "force": 500}})",
                      second = R"({"name": "second", "part": "b", "preload": {"across": [[4, 50], [12, 50]], "force": 300}})";
    for (const std::string friction : {"0", "0.2"}) {
        const auto answers = [&](const std::string& loads, const std::string& steps) {
            std::string text = scene(loads, 0, 0, "null");
            text.replace(text.find(R"("contacts": {)"), 13, R"("contacts": {"friction": )" + friction + ", ");
            text.back() = ',';
            return analyze_cases(read_scene_text(text + R"("steps": [)" + steps + "]}", "s.json"), {});
        };
        const std::string one = R"({"name": "1", "loads": {"first": 1}})";
        const std::vector<CaseResult> both = answers(first + ", " + second,
                                                     one + R"(, {"name": "2", "loads": {"first": 1, "second": 1}})"),
                                      alone = answers(first, one);
        ASSERT_EQ(both.size(), 2u);
        ASSERT_EQ(both[0].result.status, "ok") << both[0].result.message;
        ASSERT_EQ(both[1].result.status, "ok") << both[1].result.message;
        ASSERT_EQ(alone[0].result.contacts.size(), both[0].result.contacts.size());
        for (std::size_t k = 0; k < both[0].result.contacts.size(); ++k)
            EXPECT_LT((both[0].result.contacts[k].force - alone[0].result.contacts[k].force).norm(), 0.05)
                << friction << " " << k;
        EXPECT_NEAR(both[0].result.preloads.at(0).force_under_load, 500, 1e-5);
        EXPECT_GT(std::abs(both[0].result.preloads.at(1).force_under_load), 1);
        // what friction has locked in before bears a little of the second
        const double shared = friction == "0" ? 1e-5 : 0.2;
        EXPECT_NEAR(both[1].result.preloads.at(0).force_under_load, 500, shared);
        EXPECT_NEAR(both[1].result.preloads.at(1).force_under_load, 300, shared);
    }
}

/// A bolt that is warm expands, which presses less on what it clamps; what it carries is what presses on its head.
TEST(Preload, WarmBoltsCarryWhatTheirHeadsPressWith) {
    const std::string parts =
        R"({"abut": 1, "analysis": "plane_strain", "thickness": 10, "materials": {"m": {"E": 210000, "nu": 0.3, "expansion": 1.2e-5}},
        "parts": [{"name": "bolt", "material": "m", "geometry": {"union": [{"rectangle": {"min": [-6, -20], "max": [6, 20]}},
            {"rectangle": {"min": [-12, 12], "max": [12, 20]}}, {"rectangle": {"min": [-12, -20], "max": [12, -12]}}]}},
          {"name": "left", "material": "m", "geometry": {"rectangle": {"min": [-16, -12], "max": [-7, 12]}}},
          {"name": "right", "material": "m", "geometry": {"rectangle": {"min": [7, -12], "max": [16, 12]}}}],
        "supports": [{"on": "right/right", "fix": ["x", "y"]}, {"on": "left/left", "fix": ["x", "y"]},
          {"part": "bolt", "rigid": {"translation": [0, null], "rotation": 0}}], "accuracy": {"level": "draft"}, "loads": [)";
    for (const double warmth : {10.0, 50.0, -50.0}) {
        const std::string loads = preload("bolt", "[[-6.5, 2], [6.5, 2]]", 5000) + R"(, {"part": "bolt", "temperature": )" +
                                  std::to_string(warmth) + "}]}";
        const Result r = analyze(read_scene_text(parts + loads, "s.json"), {});
        ASSERT_EQ(r.status, "ok") << r.message;
        double on_head = 0;
        for (const ContactResult& c : r.contacts)
            if (c.max_pressure.at.y() > 0) on_head += std::abs(c.force.y());
        EXPECT_NEAR(r.preloads.at(0).force_under_load, on_head, 1e-6 * 5000) << warmth;
        EXPECT_EQ(on_head == 0, warmth == 50) << on_head;
    }
}

TEST(NoPreload, IsNotInTheAnswer) {
    const Result r = analyze(read_scene_text(scene(R"({"part": "above", "force": [0, -500]})"), "s.json"), {});
    EXPECT_TRUE(r.preloads.empty());
    EXPECT_EQ(result_json(r).find("preloads"), std::string::npos);
}

}  // namespace
}  // namespace abut::preload_test
