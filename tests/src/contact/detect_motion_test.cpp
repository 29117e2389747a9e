// SPDX-License-Identifier: GPL-3.0-or-later
// What is found does not depend on where an assembly is drawn, which way it is turned, and in which unit.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>

#include "src/contact/detect.hpp"
#include "src/scene/read_sketch.hpp"

namespace abut::detect_motion_test {
namespace {

const std::string source = ABUT_SOURCE_DIR;
const std::string inputs = source + "/../shared/inputs/";

Scene moved(Scene scene, double scale, double angle, const Vec2& shift) {
    geometry::Similarity map;
    map.scale = scale;
    map.c = std::cos(angle);
    map.s = std::sin(angle);
    map.d = shift;
    for (ScenePart& part : scene.parts)
        for (geometry::Edge& edge : part.part.edges) edge.curve = transformed(edge.curve, map);
    return scene;
}

/// Lengths agree to this fraction of the assembly and its distance from the origin: rounding of coordinates, through some
/// steps.
constexpr double rounding = 1e-11;

struct Tolerance {
    double length, scale;
};

void expect_same(const DetectedPair& found, const DetectedPair& original, const Tolerance& tolerance) {
    const std::string who = original.parts[0] + " - " + original.parts[1];
    EXPECT_EQ(found.parts, original.parts);
    EXPECT_EQ(found.status, original.status) << who;
    // Outlines that cross, with nothing that faces each other, are closest in several points: any of them is named.
    if (original.status != "overlap" || original.length > 0) {
        EXPECT_EQ(found.interface, original.interface) << who;
        EXPECT_EQ(found.between, original.between) << who;
        EXPECT_EQ(found.edges, original.edges) << who;
    }
    const double s = tolerance.scale, length = tolerance.length;
    EXPECT_NEAR(found.gap_min, s * original.gap_min, length) << who;
    EXPECT_NEAR(found.overlap_area, s * s * original.overlap_area, length * s * (1 + original.length)) << who;
    EXPECT_NEAR(found.shared_length, s * original.shared_length, 1e-6 * s * (1 + original.shared_length)) << who;
}

void expect_same(const std::vector<DetectedPair>& found, const std::vector<DetectedPair>& original,
                 const Tolerance& tolerance) {
    ASSERT_EQ(found.size(), original.size());
    for (std::size_t k = 0; k < found.size(); ++k) expect_same(found[k], original[k], tolerance);
}

void expect_unmoved_answers(const std::string& file) {
    SCOPED_TRACE(file);
    const Scene scene = read_sketch(file, {}).scene;
    const Detection original = detect_contacts(scene, std::nullopt);
    EXPECT_FALSE(original.pairs.empty());
    geometry::Box2 box;
    for (const ScenePart& part : scene.parts) box.extend(bounding_box(part.part));
    std::mt19937 random(20);
    std::uniform_real_distribution<double> turn(0, 2 * std::numbers::pi), far(-20, 20);
    for (const double scale : {1.0, 25.4, 1 / 25.4, 1e-3, 1e3})
        for (const double angle : {0.0, std::numbers::pi / 2, turn(random)}) {
            const Vec2 shift = scale * box.diagonal() * Vec2(far(random), far(random));
            const Detection found = detect_contacts(moved(scene, scale, angle, shift), std::nullopt);
            const Tolerance tolerance{rounding * (shift.norm() + scale * (box.diagonal() + box.center().norm())), scale};
            expect_same(found.pairs, original.pairs, tolerance);
            expect_same(found.near_misses, original.near_misses, tolerance);
        }
}

TEST(DetectMotion, APinBracketIsFoundTheSameAnywhere) {
    expect_unmoved_answers(source + "/data/sketches/pin_bracket_r14.dxf");
}

TEST(DetectMotion, AnyAssemblyIsFoundTheSameAnywhere) {
    if (!std::filesystem::exists(inputs)) GTEST_SKIP() << "the files are not here";
    for (const char* file :
         {"generated/vise_clamp_r14.dxf", "public/dxf/derived_vslot_three.dxf", "public/dxf/dxfjs__issue39.dxf"})
        expect_unmoved_answers(inputs + file);
}

}  // namespace
}  // namespace abut::detect_motion_test
