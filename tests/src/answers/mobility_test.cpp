// SPDX-License-Identifier: GPL-3.0-or-later
// Functional interfaces recognised from geometry, and what they leave the parts to do.
#include "src/answers/mobility.hpp"

#include <gtest/gtest.h>

#include "src/analysis/analysis.hpp"
#include "src/contact/detect.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::mobility_test {
namespace {

Scene scene_of(const std::string& parts, const std::string& supports, const std::string& more = "") {
    return read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3}}, "parts": [)" + parts +
                               R"(], "supports": [)" + supports + "]" + more + "}",
                           "scene.json");
}

std::string part(const std::string& name, const std::string& geometry) {
    return R"({"name": ")" + name + R"(", "material": "m", "geometry": )" + geometry + "}";
}

std::string block(const std::string& name, const std::string& min, const std::string& max) {
    return part(name, R"({"rectangle": {"min": )" + min + R"(, "max": )" + max + "}}");
}

MobilityResult drawn(const Scene& scene) {
    return mobility_as_drawn(scene, resolve_conditions(scene), find_candidates(scene, 1));
}

std::vector<std::string> motions(const MobilityResult& m, const std::string& name) {
    for (const PartMobility& p : m.parts)
        if (p.part == name) return p.motions;
    return {"no such part"};
}

void expect_counts(const MobilityResult& m, int freedom, int gruebler, int redundant) {
    EXPECT_EQ(m.degrees_of_freedom, freedom);
    EXPECT_EQ(m.gruebler, gruebler);
    EXPECT_EQ(m.redundant, redundant);
}

FunctionalInterface detected(const std::string& parts) {
    const Detection found = detect_contacts(scene_of(parts, ""), std::nullopt);
    EXPECT_EQ(found.pairs.size(), 1U);
    return found.pairs.empty() ? FunctionalInterface{} : found.pairs[0].functional;
}

const std::string hole =
    R"({"difference": [{"rectangle": {"min": [0, 0], "max": [10, 6]}}, {"circle": {"center": [4, 3], "radius": 1.01}}]})";
const std::string pin = R"({"circle": {"center": [4, 3], "radius": 1}})";
using Words = std::vector<std::string>;

}  // namespace

TEST(FunctionalInterface, PinInHole) {
    const FunctionalInterface f = detected(part("plate", hole) + "," + part("pin", pin));
    EXPECT_EQ(f.kind, "pin-in-hole");
    ASSERT_TRUE(f.diameter[0] && f.diameter[1] && f.clearance && f.center);
    EXPECT_DOUBLE_EQ(*f.diameter[0], 2.02);
    EXPECT_DOUBLE_EQ(*f.diameter[1], 2);
    EXPECT_NEAR(*f.clearance, 0.02, 1e-14);
    EXPECT_EQ(*f.center, Vec2(4, 3));
    ASSERT_EQ(f.twists.size(), 1U);
    EXPECT_LT((f.twists[0] - Screw(3, -4, 1)).norm(), 1e-12);
    EXPECT_EQ(f.wrenches.size(), 2U);
}

TEST(FunctionalInterface, FaceOnFaceSlides) {
    const FunctionalInterface f = detected(block("a", "[0, 0]", "[4, 1]") + "," + block("b", "[1, 1]", "[3, 2]"));
    EXPECT_EQ(f.kind, "flat-on-flat");
    ASSERT_TRUE(f.at && f.normal);
    EXPECT_LT((*f.at - Vec2(2, 1)).norm(), 1e-12);
    EXPECT_LT((*f.normal - Vec2(0, 1)).norm(), 1e-12);
    ASSERT_EQ(f.twists.size(), 1U);
    EXPECT_LT((f.twists[0] - Screw(1, 0, 0)).norm(), 1e-12);
}

TEST(FunctionalInterface, TheFacesOfASlotAddUp) {
    // a block in a U: held sideways and against turning by the walls, downwards by the floor
    const std::string u = R"({"polygon": [[0, 0], [6, 0], [6, 4], [4.01, 4], [4.01, 1], [1.99, 1], [1.99, 4], [0, 4]]})";
    const std::string parts = part("u", u) + "," + block("key", "[2, 1]", "[4, 5]");
    std::vector<Screw> wrenches;
    for (const DetectedPair& row : detect_contacts(scene_of(parts, ""), std::nullopt).pairs)
        wrenches.insert(wrenches.end(), row.functional.wrenches.begin(), row.functional.wrenches.end());
    EXPECT_EQ(geometry::wrench_space(wrenches, {{3, 2.5}, 8}).size(), 3U);
    EXPECT_EQ(motions(drawn(scene_of(parts, R"({"on": "u/*", "fix": ["x", "y"]})")), "key"), Words{});
}

TEST(FunctionalInterface, ARoundPartRollsAndSlidesOnAFace) {
    const FunctionalInterface f =
        detected(part("roller", R"({"circle": {"center": [5, 2], "radius": 1}})") + "," + block("floor", "[0, 0]", "[10, 1]"));
    EXPECT_EQ(f.kind, "round-on-flat");
    ASSERT_TRUE(f.at && f.normal);
    EXPECT_LT((*f.at - Vec2(5, 1)).norm(), 1e-7);
    EXPECT_LT((*f.normal - Vec2(0, -1)).norm(), 1e-7);
    EXPECT_EQ(f.wrenches.size(), 1U);
    EXPECT_EQ(f.twists.size(), 2U);
}

TEST(Mobility, WhatSupportsAndContactsLeaveIsNamed) {
    const Scene scene = scene_of(part("plate", hole) + "," + part("pin", pin), R"({"on": "plate/left", "fix": ["x", "y"]})");
    const MobilityResult m = drawn(scene);
    expect_counts(m, 1, 1, 0);
    EXPECT_EQ(motions(m, "plate"), Words{});
    EXPECT_EQ(motions(m, "pin"), Words{"rotates about (4, 3)"});
}

TEST(Mobility, OfABeamOnFourPins) {
    const Scene scene = read_scene(std::string(ABUT_SOURCE_DIR) + "/data/scenes/four_pin_beam.json");
    const MobilityResult m = drawn(scene);
    EXPECT_EQ(m.degrees_of_freedom, 0);
    EXPECT_EQ(m.redundant, 5);
}

TEST(Mobility, EverySupportCounts) {
    const std::string b = block("b", "[0, 0]", "[2, 1]");
    const auto one = [&](const std::string& supports) { return drawn(scene_of(b, supports)); };
    expect_counts(one(""), 3, 3, 0);
    expect_counts(one(R"({"on": "b/left", "fix": ["x"]})"), 1, 1, 0);
    EXPECT_EQ(motions(one(R"({"on": "b/left", "fix": ["x"]})"), "b"), Words{"slides along (0, 1)"});
    expect_counts(one(R"({"on": "b/left", "fix": ["x", "y"]})"), 0, 0, 0);
    expect_counts(one(R"({"on": ["b/left", "b/bottom"], "symmetry": true})"), 0, 0, 0);
    expect_counts(one(R"({"on": "b/left", "symmetry": true}, {"on": "b/right", "symmetry": true})"), 1, -1, 2);
    expect_counts(one(R"({"part": "b", "rigid": {"translation": [0, 0], "rotation": null}})"), 1, 1, 0);
    expect_counts(one(R"({"part": "b", "at": [[0.5, 0.5]], "fix": ["x", "y"]})"), 1, 1, 0);
    expect_counts(one(R"({"on": "b/bottom", "spring": {"normal": 10}})"), 1, 1, 0);
    expect_counts(one(R"({"on": "b/bottom", "spring": {"normal": 10, "tangential": 1}})"), 0, 0, 0);
}

TEST(Mobility, UnderLoadCountsContactsThatCarry) {
    // the block lies between a floor and a ceiling that it leaves
    const Scene scene = scene_of(block("floor", "[0, 0]", "[10, 2]") + "," + block("b", "[4, 2]", "[6, 3]") + "," +
                                     block("ceiling", "[0, 3]", "[10, 5]"),
                                 R"({"on": "floor/bottom", "fix": ["x", "y"]}, {"on": "ceiling/top", "fix": ["x", "y"]},
                                    {"on": "b/left", "fix": ["x"]})",
                                 R"(, "loads": [{"part": "b", "force": [0, -10]}], "accuracy": {"level": "draft"})");
    const Result r = analyze(scene, {});
    ASSERT_EQ(r.status, "ok") << r.message;
    ASSERT_TRUE(r.under_load);
    EXPECT_EQ(r.as_drawn.redundant, r.under_load->redundant + 2);
    EXPECT_EQ(r.under_load->degrees_of_freedom, 0);
}

}  // namespace abut::mobility_test
