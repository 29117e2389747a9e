// SPDX-License-Identifier: GPL-3.0-or-later
// Warnings where the answer leaves what was assumed: they name part, place and size.
#include "src/analysis/assumptions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/verification/scene_answers.hpp"

namespace abut::assumptions_test {
namespace {

/// A slender arm clamped on the left, E = 1000, with a load at its right end.
Result arm(const std::string& load, const std::string& yield = "") {
    return test::answer(
        R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3)" + (yield.empty() ? "" : R"(, "yield": )" + yield) +
        R"(}}, "parts": [{"name": "arm", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [10, 1]}}}],
        "supports": [{"on": "arm/left", "fix": ["x", "y"]}], "loads": [)" +
        load + R"(], "accuracy": {"cell_size": 0.25}})");
}

std::string warning(const Result& r, const std::string& begin) {
    const auto found =
        std::find_if(r.warnings.begin(), r.warnings.end(), [&](const std::string& w) { return w.starts_with(begin); });
    return found == r.warnings.end() ? "" : *found;
}

bool has_reason(const Result& r, const std::string& kind, const std::string& begin) {
    return std::any_of(r.reasons.begin(), r.reasons.end(),
                       [&](const Reason& reason) { return reason.kind == kind && reason.text.starts_with(begin); });
}

/// Bars side by side, each pulled by its right end with a traction of its own.
Result bars(const std::vector<double>& tractions) {
    std::string parts, names, loads;
    for (std::size_t k = 0; k < tractions.size(); ++k) {
        const std::string name = "bar_" + std::to_string(k), y = test::number(10 * static_cast<double>(k));
        parts += (k == 0 ? "" : ", ") +
                 (R"({"name": ")" + name + R"(", "material": "m", "geometry": {"rectangle": {"min": [0, )") + y +
                 R"(], "max": [4, )" + test::number(10 * static_cast<double>(k) + 1) + "]}}}";
        names += (k == 0 ? "" : ", ") + ("\"" + name + "/left\", \"" + name + "/bottom\"");
        loads +=
            (k == 0 ? "" : ", ") + (R"({"on": ")" + name + R"(/right", "traction": [)") + test::number(tractions[k]) + ", 0]}";
    }
    return test::answer(R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3, "yield": 1}}, "parts": [)" + parts +
                        R"(], "supports": [{"on": [)" + names + R"(], "symmetry": true}], "loads": [)" + loads +
                        R"(], "accuracy": {"cell_size": 0.5}})");
}

TEST(Assumptions, TheSameOfManyPartsIsOneLineThatNamesTheWorst) {
    const Result r = bars({2, 60, 3, 70, 0.5, 80, 4, 5});
    for (const char* begin : {"yield exceeded", "large strain", "large displacement would matter"})
        EXPECT_EQ(
            std::count_if(r.warnings.begin(), r.warnings.end(), [&](const std::string& w) { return w.starts_with(begin); }), 1)
            << begin;
    const std::string yield = warning(r, "yield exceeded: part bar_5 reaches a von Mises stress of 80 ");
    EXPECT_TRUE(yield.ends_with("; the same of 6 others: bar_3, bar_1, bar_7, bar_6 and 2 more")) << yield;
    EXPECT_TRUE(has_reason(r, "yield", "bar_5 at 80 times its yield (and 6 others)"));
    const std::string strain = warning(r, "large strain: part bar_5 strains by up to 8");
    EXPECT_TRUE(strain.ends_with("; the same of 2 others: bar_3, bar_1")) << strain;
    EXPECT_TRUE(bars({0.5, 0.7}).reasons.empty());
}

TEST(Assumptions, LargeRotationsAreSaidWithPartPlaceAndSize) {
    // the end turns by P L^2 / (2 E I): 0.12 for P = 0.2
    const Result r = arm(R"({"on": "arm/right", "force": [0, -0.2]})");
    const std::string w = warning(r, "large displacement would matter: rotation 6.9");
    EXPECT_NE(w.find(" degrees at part arm, near (10, "), std::string::npos) << w;
    EXPECT_FALSE(warning(r, "large displacement would matter: part arm moves by").empty());
    EXPECT_TRUE(has_reason(r, "rotation", "arm turns by 6.9 degrees"));
    EXPECT_TRUE(has_reason(r, "displacement", "arm moves by 8"));
    EXPECT_TRUE(warning(arm(R"({"on": "arm/right", "force": [0, -0.02]})"), "large displacement").empty());
}

TEST(Assumptions, LargeStrainsAreSaid) {
    const std::string w =
        warning(arm(R"({"on": "arm/right", "traction": [60, 0]})"), "large strain: part arm strains by up to ");
    EXPECT_NE(w.find(" % near ("), std::string::npos) << w;
    EXPECT_TRUE(warning(arm(R"({"on": "arm/right", "traction": [1, 0]})"), "large strain").empty());
}

TEST(Assumptions, WhatHasNoLimitAtACornerIsNoLargeStrain) {
    // strains grow like r^-0.456: cells of 1e-7 see 400 times those of the L's arms, which are below 0.002
    const auto bracket = [](double pull) {
        return test::answer(R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}}, "parts": [{"name": "l", "material": "m",
            "geometry": {"polygon": [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]]}}],
            "supports": [{"on": "l/e5", "fix": ["x"]}, {"on": "l/e0", "fix": ["y"]}],
            "loads": [{"on": "l/e1", "traction": [)" +
                            test::number(pull) + R"(, 0]}], "accuracy": {"level": "draft",
            "refine": [{"near": [1, 1], "radius": 1e-7, "cell_size": 1e-7}]}})");
    };
    EXPECT_TRUE(warning(bracket(1), "large strain").empty());
    EXPECT_FALSE(warning(bracket(60), "large strain").empty());
}

TEST(Assumptions, YieldIsComparedWhereItIsGiven) {
    const std::string load = R"({"on": "arm/right", "traction": [1, 0]})";
    const Result r = arm(load, "0.9");
    const std::string w = warning(r, "yield exceeded: part arm reaches a von Mises stress of ");
    EXPECT_NE(w.find("times the yield of m (0.9)"), std::string::npos) << w;
    EXPECT_TRUE(has_reason(r, "yield", "arm at "));
    EXPECT_FALSE(has_reason(arm(load, "5"), "yield", ""));
    EXPECT_TRUE(warning(arm(load, "5"), "yield").empty());
    EXPECT_TRUE(warning(arm(load), "yield").empty());
}

/// Two halves of a bar, bonded.
Result bar(double traction) {
    return test::answer(R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}}, "parts": [
        {"name": "a", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [2, 1]}}},
        {"name": "b", "material": "m", "geometry": {"rectangle": {"min": [2, 0], "max": [4, 1]}}}],
        "contacts": {"pairs": [{"between": ["a/right", "b/left"], "kind": "bonded"}]},
        "supports": [{"on": ["a/left", "a/bottom", "b/bottom"], "symmetry": true}],
        "loads": [{"on": "b/right", "traction": [)" +
                        test::number(traction) + R"(, 0]}], "accuracy": {"cell_size": 0.25}})");
}

TEST(Assumptions, BondsInTensionAreSaid) {
    const std::string w = warning(bar(3), "bonded pair in tension: a/right and b/left are pulled apart with up to 3 at (2, ");
    EXPECT_NE(w.find("contacts.pairs"), std::string::npos) << w;
    EXPECT_TRUE(warning(bar(-3), "bonded pair").empty());
}

/// A column on a plate, pressed from above with this mean stress.
Result column(double width, double stress, double thickness_of_plate = 1) {
    const std::string w = test::number(0.5 * width);
    return test::answer(R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}}, "parts": [
        {"name": "plate", "material": "m", "thickness": )" +
                        test::number(thickness_of_plate) + R"(, "geometry": {"rectangle": {"min": [-5, -2], "max": [5, 0]}}},
        {"name": "column", "material": "m", "geometry": {"rectangle": {"min": [-)" +
                        w + R"(, 0], "max": [)" + w + R"(, 10]}}}],
        "supports": [{"on": "plate/bottom", "fix": ["x", "y"]}],
        "loads": [{"on": "column/top", "pressure": )" +
                        test::number(stress) + "}]}");
}

/// Euler's stress of the column pinned at both ends, with the length from corner to corner, is 0.1 here but for its ends'
/// share.
TEST(Assumptions, RulesThatLaterOnesOverruleAreSaid) {
    const Result r = test::answer(R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}}, "parts": [
        {"name": "a", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [4, 1]}}},
        {"name": "b", "material": "m", "geometry": {"rectangle": {"min": [0, 1], "max": [4, 2]}}}],
        "supports": [{"on": "a/bottom", "fix": ["x", "y"]}, {"part": "b", "rigid": {"translation": [0, null], "rotation": 0}}],
        "loads": [{"on": "b/top", "pressure": 1}], "accuracy": {"cell_size": 0.25},
        "contacts": {"pairs": [{"between": ["a/top", "b/bottom"], "friction": 0.1}, {"between": ["a/left", "b/top"], "friction": 0.1},
                               {"between": ["b/*", "a/top"], "friction": 0.3}]}})");
    EXPECT_FALSE(warning(r, "contacts.pairs 0 has no effect: contacts.pairs 2, which comes later,").empty());
    EXPECT_FALSE(warning(r, "contacts.pairs 1 has no effect: these edges face each other nowhere").empty());
    EXPECT_TRUE(warning(r, "contacts.pairs 2 has no effect").empty());
}

TEST(Assumptions, SlenderColumnsAreSaidToBuckle) {
    const double thickness = 0.11;
    const double euler = std::pow(M_PI * thickness / 10, 2) / 12 * 1000;
    EXPECT_TRUE(warning(column(thickness, 0.2 * euler), "part column is slender").empty());
    const Result between = column(thickness, 0.5 * euler), beyond = column(thickness, 5 * euler);
    EXPECT_FALSE(warning(between, "part column is slender, and pressed along its length by").empty());
    EXPECT_FALSE(has_reason(between, "buckling", ""));
    EXPECT_TRUE(has_reason(beyond, "buckling", "part column may buckle"));
    EXPECT_TRUE(warning(column(5, 5), "part column is slender").empty());
    EXPECT_TRUE(warning(column(thickness, -5 * euler), "part column is slender").empty());
}

/// A layer is pressed along its length far above Euler's stress; held at its ends alone it buckles, and along its bottom not.
TEST(Assumptions, WhatIsHeldAlongItsSideDoesNotBuckle) {
    const double thickness = 0.11, euler = std::pow(M_PI * thickness / 10, 2) / 12 * 1000;
    for (const double degrees : {0.0, 90.0})
        for (const bool is_along : {true, false}) {
            const std::string side =
                is_along ? std::string(R"(, {"on": "layer/bottom", "fix": [")") + (degrees == 0 ? "y" : "x") + "\"]}" : "";
            const Result r = test::answer(
                R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0}}, "parts": [{"name": "layer", "material": "m",
                "geometry": {"rectangle": {"min": [0, 0], "max": [10, )" +
                test::number(thickness) + R"(]}}, "place": {"rotate": )" + test::number(degrees) + R"(}}],
                "supports": [{"on": "layer/left", "fix": ["x", "y"]})" +
                side + R"(], "loads": [{"on": "layer/right", "pressure": )" + test::number(5 * euler) + "}]}");
            EXPECT_EQ(has_reason(r, "buckling", "part layer may buckle"), !is_along) << degrees;
        }
}

/// A ring of radius 100 and thickness 1 under pressure from outside buckles from 3 E I / R^3 on.
TEST(Assumptions, ThinRingsAreSaidToBuckle) {
    const double critical = 3 * 1000 / 12.0 / std::pow(100, 3);
    const auto ring = [](double thickness, double pressure) {
        const std::string inner = std::to_string(100 - 0.5 * thickness), outer = std::to_string(100 + 0.5 * thickness);
        return test::answer(R"({"abut": 1, "analysis": "plane_stress", "materials": {"m": {"E": 1000, "nu": 0.3}}, "parts": [
            {"name": "ring", "material": "m", "geometry": {"difference": [
                {"circle": {"center": [0, 0], "radius": )" +
                            outer + R"(}, "name": "out"}, {"circle": {"center": [0, 0], "radius": )" + inner + R"(}}]}}],
            "supports": [{"part": "ring", "at": [[)" +
                            outer + R"(, 0], [-)" + outer + R"(, 0]], "fix": ["y"]}, {"part": "ring", "at": [[0, )" + outer +
                            R"(]], "fix": ["x"]}], "loads": [{"on": "ring/out/circle", "pressure": )" + test::number(pressure) +
                            "}]}");
    };
    EXPECT_TRUE(has_reason(ring(1, 1.5 * critical), "buckling", "part ring may buckle"));
    EXPECT_FALSE(has_reason(ring(1, 0.7 * critical), "buckling", ""));
    EXPECT_FALSE(has_reason(ring(1, -1.5 * critical), "buckling", ""));
    EXPECT_FALSE(has_reason(ring(20, 1.5 * critical), "buckling", ""));
}

/// Rings that something holds round, or that fluid presses from both sides.
TEST(Assumptions, ThinRingsThatAreHeldDoNotBuckle) {
    const auto ring = [](const std::string& held, const std::string& loads) {
        return test::answer(R"({"abut": 1, "analysis": "plane_stress", "materials": {"m": {"E": 1000, "nu": 0.3}}, "parts": [
            {"name": "ring", "material": "m", "geometry": {"difference": [
                {"circle": {"center": [0, 0], "radius": 100.5}, "name": "out"}, {"circle": {"center": [0, 0], "radius": 99.5}, "name": "in"}]}}],
            "supports": [)" +
                            held + R"(], "loads": [)" + loads + "]}");
    };
    const std::string
        points =
            R"({"part": "ring", "at": [[100.5, 0], [-100.5, 0]], "fix": ["y"]}, {"part": "ring", "at": [[0, 100.5]], "fix": ["x"]})",
        outside = R"({"on": "ring/out/circle", "pressure": 0.01})";
    EXPECT_TRUE(has_reason(ring(points, outside), "buckling", "part ring may buckle"));
    EXPECT_FALSE(has_reason(ring(R"({"on": "ring/in/circle", "fix": ["x", "y"]})", outside), "buckling", ""));
    EXPECT_FALSE(has_reason(ring(points, outside + R"(, {"on": "ring/in/circle", "pressure": 0.01})"), "buckling", ""));
}

TEST(Assumptions, ThinPartsThatPressThickOnesAreSaid) {
    EXPECT_FALSE(warning(column(2, 1, 3), "contact 1 presses part plate over 1 of its thickness of 3").empty());
    EXPECT_TRUE(warning(column(2, 1), "contact 1 presses").empty());
}

/// A soft sheet between two plates, clamped flat: it is pressed along itself, too, and has nowhere to go.
TEST(Assumptions, SheetsBetweenPlatesDoNotBuckle) {
    const auto plates = [](const char* upper) {
        return test::answer(
            std::string(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}, "soft": {"E": 210, "nu": 0.4}},
            "parts": [{"name": "lower", "material": "m", "geometry": {"rectangle": {"min": [-35, -10], "max": [35, 0]}}},
                {"name": "sheet", "material": "soft", "geometry": {"rectangle": {"min": [-30, 0], "max": [30, 1]}}})") +
            upper + R"(], "contacts": {"friction": 0.3}, "accuracy": {"level": "draft"}})");
    };
    const Result r =
        plates(R"(, {"name": "upper", "material": "m", "geometry": {"rectangle": {"min": [-35, 1], "max": [35, 11]}}}],
        "supports": [{"on": "lower/bottom", "fix": ["x", "y"]}, {"part": "upper", "rigid": {"translation": [0, null], "rotation": 0}}],
        "loads": [{"on": "upper/top", "pressure": 10})");
    ASSERT_EQ(r.status, "ok") << r.message;
    for (const std::string& w : r.warnings) EXPECT_EQ(w.find("buckle"), std::string::npos) << w;
    const Result bare =
        plates(R"(], "supports": [{"on": "lower/bottom", "fix": ["x", "y"]}, {"on": "sheet/left", "fix": ["x", "y"]}],
        "loads": [{"on": "sheet/right", "pressure": 1})");
    ASSERT_EQ(bare.status, "ok") << bare.message;
    EXPECT_TRUE(std::any_of(bare.warnings.begin(), bare.warnings.end(),
                            [](const std::string& w) { return w.find("buckles") != std::string::npos; }));
}

/// The sides of a bolt's cut are drawn together by more than a cell's size can strain: that is no strain.
TEST(Assumptions, WhatAPreloadDrawsTogetherIsNoStrain) {
    const Result r = test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}, "soft": {"E": 210, "nu": 0.3}},
        "parts": [{"name": "bolt", "material": "m", "geometry": {"union": [{"rectangle": {"min": [-2, -6], "max": [2, 6]}},
                {"rectangle": {"min": [-5, 5], "max": [5, 8]}}, {"rectangle": {"min": [-5, -8], "max": [5, -5]}}]}},
            {"name": "left", "material": "soft", "geometry": {"rectangle": {"min": [-8, -5], "max": [-2.5, 5]}}},
            {"name": "right", "material": "soft", "geometry": {"rectangle": {"min": [2.5, -5], "max": [8, 5]}}}],
        "supports": [{"part": "left", "rigid": {"translation": [0, 0], "rotation": 0}},
            {"part": "right", "rigid": {"translation": [0, 0], "rotation": 0}}, {"part": "bolt", "rigid": {"translation": [0, null], "rotation": 0}}],
        "loads": [{"part": "bolt", "preload": {"across": [[-3, 0], [3, 0]], "force": 30}}]})");
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_GT(r.preloads.at(0).shortening, 0.1);
    for (const std::string& w : r.warnings) EXPECT_EQ(w.find("part bolt strains"), std::string::npos) << w;
}

TEST(Assumptions, PartsThatNothingPressesLieLoose) {
    const auto bar = [](double warmer) {
        return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3, "expansion": 1.2e-5}}, "parts": [
            {"name": "l", "material": "m", "geometry": {"rectangle": {"min": [-10, -10], "max": [0, 10]}}},
            {"name": "bar", "material": "m", "geometry": {"rectangle": {"min": [0, -5], "max": [100, 5]}}},
            {"name": "r", "material": "m", "geometry": {"rectangle": {"min": [100, -10], "max": [110, 10]}}}],
            "supports": [{"on": ["l/left", "r/right"], "fix": ["x", "y"]}, {"on": "bar/bottom", "roller": true}],
            "loads": [{"part": "bar", "temperature": )" +
                            std::to_string(warmer) + "}]}");
    };
    EXPECT_NE(warning(bar(-60), "part bar lies loose"), "");
    EXPECT_EQ(warning(bar(60), "part bar lies loose"), "");
}

}  // namespace
}  // namespace abut::assumptions_test
