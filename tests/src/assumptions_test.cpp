// SPDX-License-Identifier: GPL-3.0-or-later
// Warnings where the answer leaves what was assumed: they name part, place and size.
#include "src/assumptions.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/verification/scene_answers.hpp"

namespace abut {
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

TEST(Assumptions, LargeRotationsAreSaidWithPartPlaceAndSize) {
    // the end turns by P L^2 / (2 E I): 0.12 for P = 0.2
    const Result r = arm(R"({"on": "arm/right", "force": [0, -0.2]})");
    const std::string w = warning(r, "large displacement would matter: rotation 6.9");
    EXPECT_NE(w.find(" degrees at part arm, near (10, "), std::string::npos) << w;
    EXPECT_FALSE(warning(r, "large displacement would matter: part arm moves by").empty());
    EXPECT_TRUE(warning(arm(R"({"on": "arm/right", "force": [0, -0.02]})"), "large displacement").empty());
}

TEST(Assumptions, LargeStrainsAreSaid) {
    const std::string w =
        warning(arm(R"({"on": "arm/right", "traction": [60, 0]})"), "large strain: part arm strains by up to ");
    EXPECT_NE(w.find(" % near (0, "), std::string::npos) << w;  // at the clamp's corners
    EXPECT_TRUE(warning(arm(R"({"on": "arm/right", "traction": [1, 0]})"), "large strain").empty());
}

TEST(Assumptions, YieldIsComparedWhereItIsGiven) {
    const std::string load = R"({"on": "arm/right", "traction": [1, 0]})";
    const Result r = arm(load, "0.9");
    const std::string w = warning(r, "yield exceeded: part arm reaches a von Mises stress of ");
    EXPECT_NE(w.find("times the yield of m (0.9)"), std::string::npos) << w;
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

}  // namespace
}  // namespace abut
