// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/contact/detect.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "geometry/brep/closest_points.hpp"
#include "geometry/csg/overlap.hpp"
#include "geometry/interfaces/cell_case.hpp"
#include "geometry/interfaces/interface_kind.hpp"
#include "src/inspection/detect_pictures.hpp"
#include "src/scene/read_sketch.hpp"
#include "src/scene/selection.hpp"

namespace abut::detect_test {
namespace {

using geometry::Arc;
using geometry::Edge;
using geometry::Part;
using geometry::Segment;

constexpr double pi = std::numbers::pi;
constexpr double exact = 1e-11;

void add_loop(Part& part, const std::vector<geometry::Curve>& curves, const std::vector<std::string>& names) {
    geometry::Loop loop;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        loop.edges.push_back(static_cast<int>(part.edges.size()));
        Edge edge;
        edge.curve = curves[i];
        edge.name = edge.source = names[i];
        part.edges.push_back(edge);
    }
    part.loops.push_back(loop);
}

Part block(double x0, double y0, double x1, double y1) {
    const Vec2 a(x0, y0), b(x1, y0), c(x1, y1), d(x0, y1);
    Part part;
    add_loop(part, {Segment{a, b}, Segment{b, c}, Segment{c, d}, Segment{d, a}}, {"bottom", "right", "top", "left"});
    return part;
}

Part disc(const Vec2& center, double radius) {
    Part part;
    add_loop(part, {Arc{center, radius, 0, 2 * pi}}, {"circle"});
    return part;
}

/// Those of a pattern, as a rule's side.
Selection edges(const std::string& pattern) {
    Selector selector;
    selector.pattern = pattern;
    return {selector};
}

Part plate_with_hole(double half, const Vec2& center, double radius) {
    Part part = block(-half, -half, half, half);
    add_loop(part, {Arc{center, radius, 0, -2 * pi}}, {"hole"});
    return part;
}

Part turned(const Part& part, double degrees, const Vec2& d = {0, 0}) {
    return transformed(part, std::cos(degrees * pi / 180), std::sin(degrees * pi / 180), d);
}

/// A diamond standing on its lowest corner.
Part diamond(const Vec2& lowest, double side) {
    return turned(block(0, 0, side, side), 45, lowest);
}

Scene scene_of(const std::vector<std::pair<std::string, Part>>& parts) {
    Scene scene;
    scene.length_unit = "mm";
    for (const auto& [name, part] : parts) {
        scene.parts.push_back({name, part, -1, 1, ""});
        scene.parts.back().part.name = name;
    }
    return scene;
}

std::vector<DetectedPair> pairs_of(const Part& first, const Part& second) {
    return detect_contacts(scene_of({{"a", first}, {"b", second}}), {}).pairs;
}

DetectedPair only_pair(const Part& first, const Part& second, std::optional<double> distance = {}) {
    const Detection found = detect_contacts(scene_of({{"a", first}, {"b", second}}), distance);
    EXPECT_EQ(found.pairs.size(), 1u);
    return found.pairs.empty() ? DetectedPair{} : found.pairs[0];
}

// ---- common area ----

TEST(Overlap, KnownAreas) {
    const auto area = [](const Part& a, const Part& b) {
        const double there = geometry::overlap(a, b, 1e-9).area;
        EXPECT_NEAR(geometry::overlap(b, a, 1e-9).area, there, 1e-12);
        return there;
    };
    EXPECT_NEAR(area(block(0, 0, 2, 1), block(1.5, -1, 3, 0.25)), 0.125, exact);
    EXPECT_NEAR(area(block(-2, -0.5, 2, 0.5), block(-0.25, -3, 0.25, 3)), 0.5, exact);  // a cross
    EXPECT_NEAR(area(block(-0.5, -0.5, 0.5, 0.5), turned(block(-0.5, -0.5, 0.5, 0.5), 45)), 2 * (std::sqrt(2.0) - 1), exact);
    // a lens: two unit circles one radius apart
    EXPECT_NEAR(area(disc({0, 0}, 1), disc({1, 0}, 1)), 2 * pi / 3 - std::sqrt(3.0) / 2, exact);
    // a pin bigger than its hole: an annulus, also where it is off centre
    EXPECT_NEAR(area(disc({0, 0}, 1.1), plate_with_hole(3, {0, 0}, 1)), pi * 0.21, exact);
    EXPECT_NEAR(area(disc({0.05, 0.02}, 1.1), plate_with_hole(3, {0, 0}, 1)), pi * 0.21, exact);
    // one inside the other, and one on the other
    EXPECT_NEAR(area(disc({0, 0}, 1), block(-2, -2, 2, 2)), pi, exact);
    EXPECT_NEAR(area(block(0, 0, 2, 1), block(0, 0, 2, 1)), 2, exact);
    EXPECT_NEAR(area(block(0, 0, 2, 1), block(0.5, 0, 1.5, 1)), 1, exact);
}

TEST(Overlap, WhatIsFarStaysAround) {
    // Of eight arcs most do not come near the small part, and of the holes only one does.
    Part wheel;
    std::vector<geometry::Curve> arcs;
    for (int k = 0; k < 8; ++k) arcs.push_back(Arc{{0, 0}, 10, k * pi / 4, pi / 4});
    add_loop(wheel, arcs, {"a0", "a1", "a2", "a3", "a4", "a5", "a6", "a7"});
    for (const Vec2& at : {Vec2(0, 0), Vec2(0, 8), Vec2(-8, 0)}) add_loop(wheel, {Arc{at, 1, 0, -2 * pi}}, {"hole"});
    EXPECT_NEAR(overlap(block(4, -1, 6, 1), wheel, 1e-9).area, 4, exact) << "off everything, and inside";
    EXPECT_NEAR(overlap(block(-2, -2, 2, 2), wheel, 1e-9).area, 16 - pi, exact) << "around a hole";
    EXPECT_EQ(overlap(block(11, -1, 12, 1), wheel, 1e-9).area, 0);
    const double segment = 100 * std::acos(0.9) - 9 * std::sqrt(19);
    EXPECT_NEAR(overlap(wheel, block(9, -5, 12, 5), 1e-9).area, segment, 1e-9);
}

TEST(Overlap, TouchingIsNothing) {
    EXPECT_EQ(geometry::overlap(block(0, 0, 1, 1), block(1, 0.2, 2, 3), 1e-9).area, 0);
    EXPECT_EQ(geometry::overlap(disc({0, 1}, 1), block(-2, -1, 2, 0), 1e-9).area, 0);
    EXPECT_EQ(geometry::overlap(disc({0, 0}, 1), plate_with_hole(3, {0, 0}, 1), 1e-9).area, 0);
    // within the tolerance too: drawn a little into each other
    EXPECT_EQ(geometry::overlap(block(0, 0, 1, 1), block(1 - 1e-7, 0.2, 2, 3), 1e-6).area, 0);
    EXPECT_GT(geometry::overlap(block(0, 0, 1, 1), block(1 - 1e-5, 0.2, 2, 3), 1e-6).area, 0);
}

TEST(Overlap, AgreesWithCountedPoints) {
    const Part a = turned(plate_with_hole(1, {0.3, 0.2}, 0.5), 20), b = turned(block(-0.4, -0.9, 1.2, 0.7), -33, {0.2, 0.1});
    constexpr int n = 400;
    int inside = 0;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k) {
            const Vec2 p(-2 + 4 * (i + 0.5) / n, -2 + 4 * (k + 0.5) / n);
            inside += contains(a, p) && contains(b, p);
        }
    // counting errs by far less than the perimeter times half a cell
    EXPECT_NEAR(geometry::overlap(a, b, 1e-9).area, inside * 16.0 / (n * n), 0.01);
    EXPECT_GT(inside, 1000);
}

// ---- closest points ----

TEST(ClosestPoints, OfCurvesAgainstDenseSampling) {
    const std::vector<geometry::Curve> curves{
        Segment{{0, 0}, {3, 1}},      Segment{{4, -1}, {4.5, 2}},     Segment{{1, 0}, {2, 0.9}},       Arc{{6, 0}, 1, 0.5, 4},
        Arc{{0, 4}, 2, pi, 1.2 * pi}, Arc{{6, 0.2}, 0.5, 0, -2 * pi}, Arc{{2, -3}, 1.5, 0.3, 0.5 * pi}};
    constexpr int n = 1500;
    for (std::size_t i = 0; i < curves.size(); ++i)
        for (std::size_t k = i + 1; k < curves.size(); ++k) {
            double sampled = 1e9;
            for (int j = 0; j <= n; ++j) {
                const Vec2 p = point(curves[i], static_cast<double>(j) / n);
                sampled = std::min(sampled, (point(curves[k], closest_parameter(curves[k], p)) - p).norm());
            }
            const auto found = geometry::closest_points(curves[i], curves[k]);
            EXPECT_LE(found.distance, sampled + exact) << i << " " << k;
            EXPECT_GE(found.distance, sampled - length(curves[i]) / n) << i << " " << k;
            EXPECT_NEAR((point(curves[k], found.t2) - point(curves[i], found.t1)).norm(), found.distance, exact);
        }
}

TEST(ClosestPoints, OfPartsWithinALimit) {
    const Part a = block(0, 0, 1, 1), b = diamond({2, 1.5}, 1);
    const auto near = geometry::closest_points(a, b, 2);
    ASSERT_TRUE(near);
    EXPECT_NEAR(near->distance, 1.5 / std::sqrt(2.0), exact);  // of the corner (1, 1) from the line x + y = 3.5
    EXPECT_NEAR((near->x1 - Vec2(1, 1)).norm(), 0, exact);
    EXPECT_FALSE(geometry::closest_points(a, b, near->distance * 0.99));
}

// ---- the dissertation's cells ----

TEST(CellCase, AllFive) {
    using geometry::cell_case;
    // boundaries within one cell
    EXPECT_EQ(cell_case(block(0, 0, 1.05, 1), block(1.06, 0, 2, 1), 0.1), 'a');
    // cells side by side, neither on a grid line
    EXPECT_EQ(cell_case(block(0, 0, 1.05, 1), block(1.15, 0, 2, 1), 0.1), 'b');
    // the first ends on a grid line, so that its last cells are inner ones; the second's boundary cells are next to them
    EXPECT_EQ(cell_case(block(0, 0, 1, 1), block(1.05, 0, 2, 1), 0.1), 'c');
    EXPECT_EQ(cell_case(block(1.05, 0, 2, 1), block(0, 0, 1, 1), 0.1), 'c');
    // both end on the same grid line
    EXPECT_EQ(cell_case(block(0, 0, 1, 1), block(1, 0, 2, 1), 0.1), 'd');
    // a cell between them
    EXPECT_EQ(cell_case(block(0, 0, 1.05, 1), block(1.25, 0, 2, 1), 0.1), 'e');
    EXPECT_EQ(cell_case(disc({0, 0}, 1), disc({50, 0}, 1), 0.1), 'e');
    EXPECT_EQ(cell_case(disc({0, 0}, 1), disc({2, 0}, 1), 0.15), 'a');
    EXPECT_EQ(cell_case(disc({0, 0}, 1), disc({2, 0}, 1), 0.1), 'b');  // they touch on a grid line
}

TEST(CellCase, DeepInsideCountsAsInner) {
    EXPECT_EQ(geometry::cell_case(disc({0, 0}, 1), block(-50, -50, 50, 50), 0.1), 'c');
}

// ---- kinds of interfaces ----

TEST(InterfaceKind, ByShape) {
    const Part base = block(-2, -1, 2, 0), ball = disc({0, 1}, 1), plate = plate_with_hole(5, {0, 0}, 2);
    EXPECT_EQ(geometry::interface_kind(base, 2, block(-1, 0, 1, 1), 0), "flat-on-flat");
    EXPECT_EQ(geometry::interface_kind(base, 2, ball, 0), "flat-on-round");
    EXPECT_EQ(geometry::interface_kind(ball, 0, base, 2), "round-on-flat");
    EXPECT_EQ(geometry::interface_kind(ball, 0, ball, 0), "round-on-round");
    EXPECT_EQ(geometry::interface_kind(ball, 0, plate, 4), "pin-in-hole");
    EXPECT_EQ(geometry::interface_kind(plate, 4, ball, 0), "pin-in-hole");
    EXPECT_EQ(geometry::interface_kind(base, 2, plate, 4), "general");
}

TEST(InterfaceKind, AHoleIsMoreThanHalfATurn) {
    // a block with a groove of radius 1 whose opening is at the top: half a turn, or a little more
    const auto grooved = [](double beyond) {  // radians more than a half turn on either side
        const Vec2 left(-std::cos(beyond), std::sin(beyond)), right(std::cos(beyond), std::sin(beyond));
        Part part;
        add_loop(part,
                 {Arc{{0, 0}, 1, pi - beyond, pi / 2 + beyond}, Arc{{0, 0}, 1, -pi / 2, pi / 2 + beyond},
                  Segment{right, {3, right.y()}}, Segment{{3, right.y()}, {3, -3}}, Segment{{3, -3}, {-3, -3}},
                  Segment{{-3, -3}, {-3, left.y()}}, Segment{{-3, left.y()}, left}},
                 {"g0", "g1", "t1", "r", "b", "l", "t0"});
        for (Edge& edge : part.edges) edge.curve = reversed(edge.curve);  // material on the left
        std::reverse(part.loops[0].edges.begin(), part.loops[0].edges.end());
        return part;
    };
    EXPECT_GT(area(grooved(0.2)), 0);
    EXPECT_EQ(geometry::interface_kind(disc({0, 0}, 1), 0, grooved(0.0), 0), "round-in-groove");
    EXPECT_EQ(geometry::interface_kind(disc({0, 0}, 1), 0, grooved(0.2), 1), "pin-in-hole");
}

// ---- pairs ----

TEST(Detect, FlatOnFlat) {
    const DetectedPair p = only_pair(block(0, 0, 2, 1), block(0.5, 1, 3, 2));
    EXPECT_EQ(p.status, "touching");
    EXPECT_EQ(p.interface, "flat-on-flat");
    EXPECT_EQ(p.between, (std::array<std::string, 2>{"a/top", "b/bottom"}));
    EXPECT_EQ(p.edges[0], std::vector<std::string>{"a/top"});
    EXPECT_NEAR(p.length, 1.5, exact);
    EXPECT_NEAR(p.gap_min, 0, exact);
    EXPECT_EQ(p.overlap_area, 0);
}

TEST(Detect, PinInHole) {
    const DetectedPair p = only_pair(plate_with_hole(20, {0, 0}, 10), disc({0, -0.05}, 9.95));
    EXPECT_EQ(p.status, "touching");
    EXPECT_EQ(p.interface, "pin-in-hole");
    EXPECT_NEAR(p.gap_max, 0.1, exact);
    EXPECT_NEAR(p.length, 20 * pi, exact);
    EXPECT_EQ(p.between, (std::array<std::string, 2>{"a/hole", "b/circle"}));
}

TEST(Detect, PinBiggerThanItsHole) {
    const DetectedPair p = only_pair(disc({0, 0}, 10.05), plate_with_hole(20, {0, 0}, 10));
    EXPECT_EQ(p.status, "overlap");
    EXPECT_EQ(p.interface, "pin-in-hole");
    EXPECT_NEAR(p.gap_min, -0.05, exact);
    EXPECT_NEAR(p.overlap_area, pi * (10.05 * 10.05 - 100), 1e-9);
}

TEST(Detect, DeepOverlaps) {
    const DetectedPair cross = only_pair(block(-2, -0.5, 2, 0.5), block(-0.25, -3, 0.25, 3));
    EXPECT_EQ(cross.status, "overlap");
    EXPECT_NEAR(cross.overlap_area, 0.5, exact);
    EXPECT_LT(cross.gap_min, -0.1);
    const DetectedPair inside = only_pair(disc({0, 0}, 1), block(-20, -20, 20, 20));
    EXPECT_EQ(inside.status, "overlap");
    EXPECT_NEAR(inside.overlap_area, pi, exact);
}

TEST(Detect, CornerOnAFace) {
    // a row for each flank
    const std::vector<DetectedPair> on = pairs_of(block(-2, -1, 2, 0), diamond({0.3, 0}, 1));
    ASSERT_EQ(on.size(), 2U);
    for (const DetectedPair& p : on) {
        EXPECT_EQ(p.status, "touching");
        EXPECT_EQ(p.interface, "edge-on-flat");
        EXPECT_EQ(p.between[0], "a/top");
        EXPECT_NEAR(p.gap_min, 0, exact);
    }
    const std::vector<DetectedPair> above = pairs_of(diamond({0.3, 0.02}, 1), block(-2, -1, 2, 0));
    ASSERT_EQ(above.size(), 2U);
    for (const DetectedPair& p : above) {
        EXPECT_EQ(p.status, "gap");
        EXPECT_EQ(p.interface, "edge-on-flat");
        EXPECT_NEAR(p.gap_min, 0.02, exact);
    }
    // flush faces and a small tilt are no corners
    EXPECT_EQ(only_pair(block(-2, -1, 2, 0), turned(block(0, 0, 1, 1), 0.5)).interface, "flat-on-flat");
    EXPECT_EQ(only_pair(block(-2, -1, 2, 0), turned(block(0, 0, 1, 1), 5)).interface, "edge-on-flat");
}

TEST(Detect, SharpCornerWithoutFacingEdges) {
    Part wedge;  // 40 degrees: its flanks are steeper than any that face the block
    const double w = std::tan(20 * pi / 180);
    add_loop(wedge, {Segment{{0, 0}, {w, 1}}, Segment{{w, 1}, {-w, 1}}, Segment{{-w, 1}, {0, 0}}}, {"right", "top", "left"});
    const DetectedPair p = only_pair(block(-2, -1, 2, 0), wedge);
    EXPECT_EQ(p.status, "touching");
    EXPECT_EQ(p.interface, "edge-on-flat");
    EXPECT_EQ(p.length, 0);
    ASSERT_EQ(p.marks.size(), 1u);
    EXPECT_NEAR(p.marks[0][0].norm(), 0, exact);
}

TEST(Detect, CornersThatMeet) {
    const DetectedPair p = only_pair(block(0, 0, 1, 1), block(1, 1, 2, 2));
    EXPECT_EQ(p.status, "touching");
    EXPECT_EQ(p.interface, "general");
    EXPECT_NEAR(p.length, 0, exact);
}

TEST(Detect, DistanceDecidesBetweenPairsAndNearMisses) {
    const Scene scene = scene_of({{"a", block(0, 0, 1, 1)}, {"b", block(1.05, 0, 2, 1)}, {"c", block(0, 1.3, 1, 2)}});
    // 2 % of the smaller diagonal are 0.028, 10 % 0.14
    const Detection standard = detect_contacts(scene, {});
    EXPECT_TRUE(standard.pairs.empty());
    ASSERT_EQ(standard.near_misses.size(), 1u);
    EXPECT_EQ(standard.near_misses[0].parts[1], "b");
    EXPECT_EQ(standard.near_misses[0].interface, "flat-on-flat");
    EXPECT_NEAR(standard.near_misses[0].gap_min, 0.05, exact);
    const Detection wide = detect_contacts(scene, 0.31);
    ASSERT_EQ(wide.pairs.size(), 3u);
    EXPECT_EQ(wide.pairs[0].status, "gap");
    EXPECT_NEAR(wide.pairs[1].gap_min, 0.3, exact);
    EXPECT_EQ(wide.pairs[2].parts, (std::array<std::string, 2>{"b", "c"}));  // closest at their corners
    EXPECT_EQ(wide.distance, 0.31);
}

TEST(Detect, TouchingToleranceIsAMillionthOfTheSmallerPart) {
    EXPECT_EQ(only_pair(block(0, 0, 3, 4), block(3 + 4e-6, 0, 6, 4)).status, "touching");
    EXPECT_EQ(only_pair(block(0, 0, 3, 4), block(3 - 4e-6, 0, 6, 4)).status, "touching");
    EXPECT_EQ(only_pair(block(0, 0, 3, 4), block(3 + 6e-6, 0, 6, 4)).status, "gap");
    EXPECT_EQ(only_pair(block(0, 0, 3, 4), block(3 - 6e-6, 0, 6, 4)).status, "overlap");
}

TEST(Detect, IgnoredPairsAreLeftOut) {
    Scene scene = scene_of({{"a", block(0, 0, 1, 1)}, {"b", block(1, 0, 2, 1)}, {"c", block(0, 1, 2, 2)}});
    EXPECT_EQ(detect_contacts(scene, {}).pairs.size(), 3u);
    PairRule rule;
    rule.kind = PairRule::Kind::ignore;
    const auto add = [&] {
        resolve(scene, rule);
        scene.contacts.pairs.push_back(rule);
    };
    rule.between = {edges("b/left"), edges("a/right")};
    add();
    const Detection fewer = detect_contacts(scene, {});
    ASSERT_EQ(fewer.pairs.size(), 2u);
    EXPECT_EQ(fewer.pairs[0].parts[1], "c");
    rule.between = {edges("c/*"), edges("a/*")};
    add();
    EXPECT_EQ(detect_contacts(scene, {}).pairs.size(), 1u);
    const Selection two{edges("b/left").front(), edges("b/top").front()};
    rule.between = {two, edges("c/*")};
    add();
    EXPECT_EQ(detect_contacts(scene, {}).pairs.size(), 0u);
}

TEST(Detect, PartsOfARealDrawing) {
    // distances and lengths as an independent kernel gives them
    const auto reading = read_sketch(std::string(ABUT_SOURCE_DIR) + "/data/sketches/pin_bracket_r14.dxf", {});
    const Detection found = detect_contacts(reading.scene, {});
    ASSERT_EQ(found.pairs.size(), 2u);
    EXPECT_TRUE(found.near_misses.empty());
    EXPECT_EQ(found.pairs[0].parts, (std::array<std::string, 2>{"bracket", "pin"}));
    EXPECT_EQ(found.pairs[0].status, "touching");
    EXPECT_EQ(found.pairs[0].interface, "pin-in-hole");
    EXPECT_EQ(found.pairs[1].parts, (std::array<std::string, 2>{"bracket", "base"}));
    EXPECT_EQ(found.pairs[1].interface, "flat-on-flat");
    EXPECT_NEAR(found.pairs[1].length, 120, 1e-6);
}

// ---- what is written ----

TEST(DetectJson, HasTheKeysOfTheFormat) {
    const Scene scene = scene_of({{"a", block(0, 0, 1, 1)}, {"b", block(1, 0, 2, 1)}, {"c", block(0, 1.1, 1, 2)}});
    const auto json = nlohmann::ordered_json::parse(detection_json(scene, detect_contacts(scene, {})));
    EXPECT_EQ(json["abut"], 1);
    EXPECT_EQ(json["unit"], "mm");
    ASSERT_EQ(json["pairs"].size(), 1u);
    ASSERT_EQ(json["near_misses"].size(), 2u);
    std::vector<std::string> keys;
    for (const auto& item : json["pairs"][0].items()) keys.push_back(item.key());
    EXPECT_EQ(keys, (std::vector<std::string>{"parts", "between", "edges", "status", "interface", "gap", "overlap_area",
                                              "length", "shared_length", "cells_case", "why", "functional_interface"}));
    EXPECT_EQ(json["pairs"][0]["edges"][1], nlohmann::ordered_json::array({"b/left"}));
    EXPECT_NEAR(json["pairs"][0]["length"].get<double>(), 1, exact);
}

TEST(DetectPicture, ShowsEveryPairAndNearMiss) {
    const Scene scene = scene_of({{"a<b", block(0, 0, 1, 1)}, {"b", block(1, 0, 2, 1)}, {"c", block(0, 1.1, 1, 2)}});
    const std::string svg = detection_svg(scene, detect_contacts(scene, {}));
    const auto count = [&](const std::string& what) {
        int n = 0;
        for (auto at = svg.find(what); at != std::string::npos; at = svg.find(what, at + 1)) ++n;
        return n;
    };
    EXPECT_EQ(count("class=\"badge touching\""), 1);
    EXPECT_EQ(count("class=\"part\""), 3);
    EXPECT_EQ(count("class=\"miss\""), 4);  // two lines and their two legend samples
    EXPECT_EQ(count("a<b"), 0);
    EXPECT_EQ(count("nan"), 0);
    EXPECT_EQ(count("<svg"), 1);
}

TEST(DetectTable, NamesPairsAndNearMisses) {
    const Scene scene = scene_of({{"jaw", block(0, 0, 1, 1)}, {"pad", block(1, 0, 2, 1)}, {"lid", block(0, 1.1, 1, 2)}});
    const std::string table = detection_table(scene, detect_contacts(scene, {}));
    EXPECT_NE(table.find("jaw - pad"), std::string::npos);
    EXPECT_NE(table.find("near misses\n  jaw - lid: 0.1 mm apart"), std::string::npos);
    const Scene alone = scene_of({{"jaw", block(0, 0, 1, 1)}});
    EXPECT_NE(detection_table(alone, detect_contacts(alone, {})).find("no contacts"), std::string::npos);
}

class Expectation : public ::testing::Test {
protected:
    std::string file(const std::string& text) {
        std::ofstream(path_) << text;
        return path_;
    }
    void TearDown() override { std::filesystem::remove(path_); }

    const std::string path_ =
        (std::filesystem::temp_directory_path() / ("abut_expectation_" + std::to_string(::getpid()) + ".json")).string();
    const Detection found_ =
        detect_contacts(scene_of({{"a", block(0, 0, 1, 1)}, {"b", block(1, 0, 2, 1)}, {"c", block(0, 1.1, 1, 2)}}), {});
};

TEST_F(Expectation, MetInEitherOrderAndByEdges) {
    EXPECT_TRUE(compare_detection(found_, file(R"({"pairs": [["b", "a"]]})")).empty());
    EXPECT_TRUE(compare_detection(found_, file(R"({"pairs": [["a/right", "b/left"]]})")).empty());
    EXPECT_TRUE(compare_detection(
                    found_, file(R"({"pairs": [{"parts": ["a", "b"], "status": "touching", "interface": "flat-on-flat"}]})"))
                    .empty());
}

TEST_F(Expectation, DifferencesAreNamed) {
    const auto missing = compare_detection(found_, file(R"({"pairs": [["a", "b"], ["a", "c"]]})"));
    ASSERT_EQ(missing.size(), 1u);
    EXPECT_NE(missing[0].find("a - c"), std::string::npos);
    EXPECT_NE(missing[0].find("0.1 mm apart"), std::string::npos);
    const auto extra = compare_detection(found_, file(R"({"pairs": []})"));
    ASSERT_EQ(extra.size(), 1u);
    EXPECT_NE(extra[0].find("not expected"), std::string::npos);
    EXPECT_EQ(compare_detection(found_, file(R"({"pairs": [["a/left", "b/left"]]})")).size(), 2u);
    EXPECT_EQ(compare_detection(found_, file(R"({"pairs": [{"parts": ["a", "b"], "status": "gap", "interface": "general"}]})"))
                  .size(),
              2u);
}

TEST_F(Expectation, FaultsOfTheFileAreAllReported) {
    try {
        compare_detection(found_, file(R"({"pairs": [["a"], {"parts": ["a", "b"], "statsu": "gap"}], "other": 1})"));
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_EQ(error.problems().size(), 3u);
        EXPECT_NE(std::string(error.what()).find("status"), std::string::npos);
    }
    EXPECT_THROW(compare_detection(found_, "/nonexistent/expected.json"), InputError);
    EXPECT_THROW(compare_detection(found_, file("[]")), InputError);
}

}  // namespace
}  // namespace abut::detect_test
