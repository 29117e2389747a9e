// SPDX-License-Identifier: GPL-3.0-or-later
// The largest stress at small radii, with its own estimate, against Inglis' 1 + 2 a / b of an elliptic hole under tension.
#include "src/analysis/largest_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "src/analysis/analysis.hpp"
#include "src/analysis/singular_places.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::largest_stress_test {
namespace {

std::string plate(const std::string& geometry, const std::string& edges, const std::string& accuracy = "{}") {
    return R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "accuracy": )" + accuracy +
           R"(, "parts": [{"name": "p", "material": "m", "geometry": )" + geometry + R"(}],
        "supports": [{"on": "p/)" +
           edges + R"(bottom", "symmetry": true},
            {"part": "p", "rigid": {"translation": [0, null], "rotation": null}}],
        "loads": [{"on": "p/)" +
           edges + R"(top", "traction": [0, 1]}]})";
}

std::string as_ellipse(double b) {
    std::ostringstream text;
    text << R"({"difference": [{"rectangle": {"min": [-20, -20], "max": [20, 20]}, "name": "r"},
        {"ellipse": {"center": [0, 0], "radii": [1, )"
         << b << R"(]}, "name": "h"}]})";
    return plate(text.str(), "r/");
}

/// The same hole as four rational arcs.
std::string as_nurbs(double b) {
    std::ostringstream text;
    text.precision(17);
    text << R"({"loops": [[{"line": {"from": [-20, -20], "to": [20, -20]}, "name": "bottom"},
        {"line": {"from": [20, -20], "to": [20, 20]}}, {"line": {"from": [20, 20], "to": [-20, 20]}, "name": "top"},
        {"line": {"from": [-20, 20], "to": [-20, -20]}}], [)";
    const std::array<std::array<int, 2>, 9> corner{
        {{1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}, {0, 1}, {1, 1}, {1, 0}}};
    for (std::size_t i = 0; i < 8; i += 2) {
        text << (i > 0 ? ", " : "") << R"({"nurbs": {"degree": 2, "knots": [0, 0, 0, 1, 1, 1], "points": [)";
        for (std::size_t k = i; k <= i + 2; ++k)
            text << (k > i ? ", [" : "[") << corner[k][0] << ", " << b * corner[k][1] << "]";
        text << R"(], "weights": [1, )" << std::sqrt(0.5) << ", 1]}}";
    }
    return plate(text.str() + "]]}", "");
}

const std::string l_shape = plate(R"({"difference": [{"rectangle": {"min": [0, 0], "max": [2, 2]}, "name": "r"},
    {"rectangle": {"min": [1, -1], "max": [3, 1]}}]})",
                                  "r/");

PartResult solved(const std::string& scene, std::vector<std::string>* warnings = nullptr) {
    const Result result = analyze(read_scene_text(scene, "scene.json"), {});
    EXPECT_EQ(result.status, "ok") << result.message;
    if (warnings) *warnings = result.warnings;
    return result.parts.at(0);
}

/// An ellipse b high in a plate 20 times as large: its sides raise the stress by 0.3 % at most.
void expect_needle(double b, const std::string& scene) {
    constexpr double sides = 0.003;
    const double truth = 1 + 2 / b;
    SCOPED_TRACE(scene);
    const PartResult part = solved(scene);
    ASSERT_TRUE(part.max_von_mises_error);
    EXPECT_FALSE(part.max_von_mises_at_corner);
    EXPECT_LT(*part.max_von_mises_error, 0.01);
    EXPECT_NEAR(part.max_von_mises.value / truth, 1, *part.max_von_mises_error + sides);
    EXPECT_NEAR(std::abs(part.max_von_mises.at.x()), 1, 0.1 * b * b);
}

}  // namespace

TEST(LargestStress, OfANeedleHoleIsWithinItsErrorHoweverItIsDrawn) {
    expect_needle(0.1, as_ellipse(0.1));
    expect_needle(0.1, as_nurbs(0.1));
}

TEST(LongLargestStress, OfSharperNeedlesToo) {
    for (const double b : {0.05, 0.02})
        for (const std::string& scene : {as_ellipse(b), as_nurbs(b)}) expect_needle(b, scene);
}

TEST(LargestStress, AtAReentrantCornerHasNoLimitAndSaysSo) {
    std::vector<std::string> warnings;
    const PartResult part = solved(l_shape, &warnings);
    EXPECT_TRUE(part.max_von_mises_at_corner);
    EXPECT_FALSE(part.max_von_mises_error);
    EXPECT_TRUE(test::warns(warnings, "has no limit there"));
}

/// The hole's stress is the largest on the first grids; a notch beside it has sharp corners.
TEST(LargestStress, ThatASharpCornerExceedsOnFinerGridsIsSaid) {
    const auto notched = [](const char* notch) {
        return plate(std::string(R"({"difference": [{"rectangle": {"min": [-20, -20], "max": [20, 20]}, "name": "r"},
            {"ellipse": {"center": [0, 0], "radii": [1, 0.3]}, "name": "h"})") +
                         notch + "]}",
                     "r/");
    };
    std::vector<std::string> warnings;
    const PartResult part = solved(notched(R"(, {"rectangle": {"min": [18.5, -0.5], "max": [21, 0.5]}})"), &warnings);
    EXPECT_FALSE(part.max_von_mises_at_corner);
    EXPECT_LT(part.max_von_mises.at.x(), 2);
    EXPECT_TRUE(test::warns(warnings, "that at the sharp corner at (18.5, "));
    solved(notched(""), &warnings);
    EXPECT_FALSE(test::warns(warnings, "corner"));
}

/// A saddle on a nose with sharp corners at its root: the saddle's stress is the largest on the first grids.
TEST(LargestStress, ThatASharpCornerOfAnotherPartExceedsIsSaidToo) {
    const Result r = analyze(read_scene_text(R"({"abut": 1, "analysis": "plane_stress", "thickness": 10,
        "materials": {"steel": {"E": 210000, "nu": 0.3}, "alu": {"E": 70000, "nu": 0.33}}, "parts": [
        {"name": "base", "material": "steel", "geometry": {"union": [{"rectangle": {"min": [-50, -12], "max": [50, 0]}},
            {"slot": {"from": [0, -4], "to": [0, 6], "radius": 8}}]}},
        {"name": "saddle", "material": "alu", "thickness": 6, "geometry": {"difference": [
            {"rectangle": {"min": [-20, 6], "max": [20, 32]}}, {"slot": {"from": [0, -5], "to": [0, 5.95], "radius": 8.05}}]}}],
        "supports": [{"on": {"part": "base", "near": [0, -12]},
            "spring": {"normal": 2000, "tangential": 300}}, {"part": "saddle", "rigid": {"rotation": 0}}],
        "loads": [{"on": {"part": "saddle", "near": [0, 32]}, "force": [100, -1000]}]})",
                                             "scene.json"),
                             {});
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_GT(r.parts[1].max_von_mises.value, r.parts[0].max_von_mises.value);
    EXPECT_FALSE(r.parts[1].max_von_mises_at_corner);
    EXPECT_TRUE(test::warns(r.warnings, "that at the sharp corner of base at (8, 0)"));
}

/// An arm that a stop holds at its tip: the stop's stress is the largest on the first grids.
TEST(LargestStress, ThatTheEndOfASupportExceedsIsSaid) {
    const Result r = analyze(read_scene_text(R"({"abut": 1, "analysis": "plane_stress", "thickness": 10,
        "materials": {"steel": {"E": 210000, "nu": 0.3}, "brass": {"E": 100000, "nu": 0.34}}, "parts": [
        {"name": "arm", "material": "steel", "geometry": {"union": [{"rectangle": {"min": [0, 0], "max": [70, 6]}, "name": "a"},
            {"circle": {"center": [70, 3], "radius": 3}}]}},
        {"name": "stop", "material": "brass", "geometry": {"rectangle": {"min": [55, -20.279], "max": [90, -0.279]}}}],
        "supports": [{"on": ["arm/a/left", "stop/bottom"], "fix": ["x", "y"]}],
        "loads": [{"on": "arm/a/top", "force": [0, -410]}], "accuracy": {"level": "draft"}})",
                                             "scene.json"),
                             {});
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_GT(r.parts[1].max_von_mises.value, r.parts[0].max_von_mises.value);
    EXPECT_TRUE(test::warns(r.warnings, "that at the end of a support of arm at (0, "));
}

/// Tables: 0.2888 for a right angle, 0.5 (and an oscillation) for half a turn, none for a sharp wedge; nu = 0.3, plane strain.
TEST(LargestStress, GrowsTowardsClampsAsTheirAnglesSay) {
    constexpr double kolosov = 3 - 4 * 0.3, pi = 3.141592653589793;
    EXPECT_NEAR(growth_at_clamp(pi / 2, kolosov), 0.2888, 1e-3);
    EXPECT_NEAR(growth_at_clamp(0, kolosov), 0.5, 1e-3);
    EXPECT_EQ(growth_at_clamp(0.75 * pi, kolosov), 0);
}

TEST(LargestStress, ThatTheGridsCannotShowIsWarnedOf) {
    const std::string coarse = as_ellipse(0.02);
    Scene scene = read_scene_text(coarse, "scene.json");
    scene.accuracy.cell_size = 0.5;
    const Result result = analyze(scene, {});
    ASSERT_TRUE(result.parts[0].max_von_mises_error);
    EXPECT_TRUE(test::warns(result.warnings, "is uncertain by"));
    EXPECT_GT(*result.parts[0].max_von_mises_error, 0.9);  // it shows 1.6 of 101
}

}  // namespace abut::largest_stress_test
