// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/read_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/scene/load_cases.hpp"
#include "src/scene/read_sketch.hpp"
#include "src/scene/scene.hpp"
#include "src/scene/selection.hpp"
#include "tests/src/io/temporary_folder.hpp"

namespace abut::read_scene_test {

namespace {

constexpr double pi = std::numbers::pi;

/// Reads a scene given as text.
Scene scene_of(const std::string& text) {
    const TemporaryFolder folder;
    return read_scene(folder.write("s.json", text));
}

/// A scene with one part of that geometry (and what follows it in the part).
Scene with_geometry(const std::string& geometry) {
    return scene_of(R"({"abut": 1, "parameters": {"R": 2}, "materials": {"m": {"E": 1, "nu": 0}},
                        "parts": [{"name": "p", "material": "m", "geometry": )" +
                    geometry + "}]}");
}

/// A scene with a unit square "p" and these members.
Scene with_members(const std::string& members) {
    return scene_of(R"({"abut": 1, "materials": {"m": {"E": 1, "nu": 0, "density": 3}},
                        "parts": [{"name": "p", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}}}], )" +
                    members + "}");
}

double area_of(const Scene& scene) {
    return geometry::area(scene.parts.at(0).part);
}

std::vector<std::string> edge_names(const geometry::Part& part) {
    std::vector<std::string> names;
    for (const geometry::Edge& edge : part.edges) names.push_back(edge.name);
    std::sort(names.begin(), names.end());
    return names;
}

using Names = std::vector<std::string>;
const std::string drawing = std::string(ABUT_SOURCE_DIR) + "/data/sketches/pin_bracket_r14.dxf";

}  // namespace

TEST(ReadScene, general_entries) {
    const Scene scene = scene_of(R"({
        "abut": 1, "title": "Vise", "units": {"length": "mm", "force": "N"}, "analysis": "plane_strain", "thickness": "h",
        "parameters": {"a": 2, "h": "a^2+1"},   // h may use a
        "materials": {"steel": {"E": 2.1e5, "nu": 0.3, "density": 7.85e-9, "expansion": 1.2e-5, "yield": 250}, "brass": {"E": 1e5, "nu": 0.35}},
        "parts": [{"name": "one", "material": "brass", "geometry": {"circle": {"center": [0, 0], "radius": "a"}}},
                  {"name": "two", "material": "steel", "thickness": 3, "geometry": {"circle": {"center": [9, 0], "radius": "a"}}}]})");
    EXPECT_EQ(scene.title, "Vise");
    EXPECT_EQ(scene.length_unit, "mm");
    EXPECT_EQ(scene.force_unit, "N");
    EXPECT_EQ(scene.analysis, Analysis::plane_strain);
    ASSERT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.materials[0].name, "steel");
    EXPECT_EQ(scene.materials[0].E, 2.1e5);
    EXPECT_EQ(scene.materials[0].nu, 0.3);
    EXPECT_EQ(scene.materials[0].density, 7.85e-9);
    EXPECT_TRUE(scene.materials[0].has_density);
    EXPECT_EQ(scene.materials[0].yield, 250);
    EXPECT_FALSE(scene.materials[1].has_density);
    ASSERT_EQ(scene.parts.size(), 2u);
    EXPECT_EQ(scene.parts[0].name, "one");
    EXPECT_EQ(scene.parts[0].part.name, "one");
    EXPECT_EQ(scene.parts[0].material, 1);
    EXPECT_EQ(scene.parts[0].thickness, 5);
    EXPECT_EQ(scene.parts[1].material, 0);
    EXPECT_EQ(scene.parts[1].thickness, 3);
    EXPECT_EQ(scene.parts[1].where, "/parts/1");
}

TEST(ReadScene, defaults) {
    const Scene scene = with_members(R"("supports": [])");
    EXPECT_EQ(scene.analysis, Analysis::plane_stress);
    EXPECT_EQ(scene.parts[0].thickness, 1);
    EXPECT_TRUE(scene.contacts.detect);
    EXPECT_FALSE(scene.contacts.search_distance);
    EXPECT_EQ(scene.accuracy.level, "standard");
    EXPECT_EQ(scene.accuracy.degree, 2);
    EXPECT_EQ(scene.output.formats, Names({"json", "csv", "html"}));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(ReadScene, the_schema_that_editors_are_told_is_a_text_and_nothing_else) {
    EXPECT_EQ(with_members(R"("$schema": "no/such/file.json", "title": "t")").title, "t");
    EXPECT_THROW(with_members(R"("$schema": 1)"), InputError);
}

TEST(ReadScene, geometry_nodes) {
    EXPECT_NEAR(area_of(with_geometry(R"({"rectangle": {"min": [0, 0], "max": ["R", 3]}})")), 6, 1e-12);
    EXPECT_NEAR(area_of(with_geometry(R"({"circle": {"center": [5, 5], "radius": "R"}})")), 4 * pi, 1e-12);
    EXPECT_NEAR(area_of(with_geometry(R"({"polygon": [[0, 0], [0, 3], [4, 0]]})")), 6, 1e-12);
    const std::string square = R"({"rectangle": {"min": [0, 0], "max": [2, 2]}, "name": "plate"})";
    const std::string disc = R"({"circle": {"center": [1, 1], "radius": 0.5}, "name": "hole"})";
    const Scene holed = with_geometry(R"({"difference": [)" + square + ", " + disc + "]}");
    EXPECT_NEAR(area_of(holed), 4 - 0.25 * pi, 1e-12);
    EXPECT_EQ(edge_names(holed.parts[0].part),
              Names({"hole/circle", "plate/bottom", "plate/left", "plate/right", "plate/top"}));
    EXPECT_NEAR(
        area_of(with_geometry(R"({"intersection": [)" + square + R"(, {"half_plane": {"point": [1, 0], "normal": [1, 0]}}]})")),
        2, 1e-12);
    EXPECT_NEAR(area_of(with_geometry(R"({"union": [)" + square + R"(, {"rectangle": {"min": [1, 0], "max": [3, 2]}}]})")), 6,
                1e-12);
}

TEST(ReadScene, place_as_a_node_and_of_a_part) {
    // Turned by 90 degrees about (1, 0), then moved by (10, 0): (0..2, 0..1) goes to (0..1, -1..1) and on to (10..11, -1..1).
    const std::string place = R"("rotate": 90, "about": [1, 0], "translate": [10, 0])";
    const std::string rectangle = R"({"rectangle": {"min": [0, 0], "max": [2, 1]}})";
    for (const Scene& scene : {with_geometry(R"({"place": {"of": )" + rectangle + ", " + place + "}}"),
                               with_geometry(rectangle + R"(, "place": {)" + place + "}")}) {
        const geometry::Box2 box = geometry::bounding_box(scene.parts[0].part);
        EXPECT_NEAR(box.min.x(), 10, 1e-12);
        EXPECT_NEAR(box.max.x(), 11, 1e-12);
        EXPECT_NEAR(box.min.y(), -1, 1e-12);
        EXPECT_NEAR(box.max.y(), 1, 1e-12);
    }
}

TEST(ReadScene, an_array_is_a_part_for_each_copy) {
    const std::string disc = R"({"circle": {"center": [4, 0], "radius": 1}}, "place": {"translate": [1, 0]})";
    const Scene round = with_geometry(disc + R"(, "array": {"count": "1 + 3", "about": [0, 0]})"),
                half = with_geometry(disc + R"(, "array": {"count": 3, "about": [0, 0], "angle": 90})"),
                row = with_geometry(disc + R"(, "array": {"count": 3, "step": [10, 2]})");
    ASSERT_EQ(round.parts.size(), 4u);
    ASSERT_EQ(half.parts.size(), 3u);
    ASSERT_EQ(row.parts.size(), 3u);
    const auto center = [](const Scene& scene, std::size_t k) {
        const geometry::Box2 box = geometry::bounding_box(scene.parts[k].part);
        return Vec2(0.5 * (box.min + box.max));
    };
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(row.parts[k].name, "p[" + std::to_string(k) + "]");
        EXPECT_LT((center(row, k) - Vec2(5 + 10.0 * static_cast<double>(k), 2.0 * static_cast<double>(k))).norm(), 1e-12);
        EXPECT_LT((center(half, k) - center(round, k)).norm(), 1e-12);
    }
    EXPECT_LT((center(round, 1) - Vec2(0, 5)).norm(), 1e-12);
    EXPECT_LT((center(round, 3) - Vec2(0, -5)).norm(), 1e-12);
    EXPECT_EQ(edge_names(round.parts[2].part), Names({"circle"}));
    Selector second;
    second.pattern = "p[1]/*";
    EXPECT_EQ(select(row, {second}).size(), 1u);
}

TEST(ReadScene, arcs_of_loops_in_both_forms) {
    const std::string line = R"({"line": {"from": [-1, 0], "to": [1, 0]}, "name": "flat"})";
    const auto area = [&](const std::string& arc) {
        return area_of(with_geometry(R"({"loops": [[)" + line + R"(, {"arc": )" + arc + "}]]}"));
    };
    EXPECT_NEAR(area(R"({"from": [1, 0], "to": [-1, 0], "center": [0, 0], "ccw": true})"), pi / 2, 1e-12);
    EXPECT_NEAR(area(R"({"from": [1, 0], "to": [-1, 0], "center": [0, 0]})"), pi / 2, 1e-12);
    EXPECT_NEAR(area(R"({"from": [-1, 0], "to": [1, 0], "center": [0, 0], "ccw": false})"), pi / 2, 1e-12);
    EXPECT_NEAR(area(R"({"from": [1, 0], "via": [0, 1], "to": [-1, 0]})"), pi / 2, 1e-12);
    EXPECT_NEAR(area(R"({"from": [-1, 0], "via": [0, -1], "to": [1, 0]})"), pi / 2, 1e-12);
    // Through (0, 0.5): radius 1.25, centre (0, -0.75); through (0, 2): the same circle upside down, its greater part.
    const double sector = 1.25 * 1.25 * std::asin(0.8), triangle = 0.75;
    EXPECT_NEAR(area(R"({"from": [1, 0], "via": [0, 0.5], "to": [-1, 0]})"), sector - triangle, 1e-12);
    EXPECT_NEAR(area(R"({"from": [1, 0], "via": [0, 2], "to": [-1, 0]})"), 1.25 * 1.25 * pi - (sector - triangle), 1e-12);
}

TEST(ReadScene, edges_of_loops_have_names_in_file_order) {
    const Scene scene = with_geometry(R"({"loops": [
        [{"line": {"from": [0, 0], "to": [4, 0]}}, {"line": {"from": [4, 0], "to": [0, 4]}, "name": "slope"}, {"line": {"from": [0, 4], "to": [0, 0]}}],
        [{"arc": {"from": [1.5, 1], "to": [1.5, 1], "center": [1, 1], "ccw": true}}]]})");
    EXPECT_EQ(edge_names(scene.parts[0].part), Names({"e0", "e2", "e3", "slope"}));
    EXPECT_NEAR(area_of(scene), 8 - 0.25 * pi, 1e-12);
}

TEST(ReadScene, ellipses_and_slots) {
    EXPECT_NEAR(area_of(with_geometry(R"({"ellipse": {"center": [1, 2], "radii": ["R", 1]}})")), 2 * pi, 1e-12);
    const Scene turned = with_geometry(R"({"ellipse": {"center": [0, 0], "radii": [3, 1], "angle": 90}})");
    const geometry::Box2 box = geometry::bounding_box(turned.parts[0].part);
    EXPECT_NEAR(box.max.x(), 1, 1e-12);
    EXPECT_NEAR(box.max.y(), 3, 1e-12);
    EXPECT_EQ(edge_names(turned.parts[0].part), Names({"ellipse"}));
    EXPECT_EQ(geometry::kind_name(turned.parts[0].part.edges[0].curve), "ellipse");
    const Scene slot = with_geometry(R"({"slot": {"from": [0, 0], "to": [3, 4], "radius": "R/4"}})");
    EXPECT_NEAR(area_of(slot), 5 + 0.25 * pi, 1e-12);
    EXPECT_EQ(edge_names(slot.parts[0].part), Names({"end0", "end1", "side0", "side1"}));
}

TEST(ReadScene, place_scales_and_mirrors_before_it_turns) {
    // (1..3, 0..1) about (1, 0): doubled (1..5, 0..2), mirrored (-3..1, 0..2), turned by 90 degrees (-1..1, -4..0).
    const std::string rectangle = R"({"rectangle": {"min": [1, 0], "max": [3, 1]}})";
    const std::string place = R"("scale": 2, "mirror": "x", "rotate": 90, "about": [1, 0], "translate": [0, 10])";
    for (const Scene& scene : {with_geometry(R"({"place": {"of": )" + rectangle + ", " + place + "}}"),
                               with_geometry(rectangle + R"(, "place": {)" + place + "}")}) {
        const geometry::Box2 box = geometry::bounding_box(scene.parts[0].part);
        EXPECT_NEAR(box.min.x(), -1, 1e-12);
        EXPECT_NEAR(box.max.x(), 1, 1e-12);
        EXPECT_NEAR(box.min.y(), 6, 1e-12);
        EXPECT_NEAR(box.max.y(), 10, 1e-12);
        EXPECT_NEAR(area_of(scene), 8, 1e-12);  // positive: the material stays on the left
    }
    const geometry::Box2 box = geometry::bounding_box(with_geometry(rectangle + R"(, "place": {"mirror": "y"})").parts[0].part);
    EXPECT_NEAR(box.min.y(), -1, 1e-12);
}

TEST(ReadScene, selections_know_the_outside_of_a_mirrored_part) {
    const std::string half = R"({"difference": [{"ellipse": {"center": [0, 0], "radii": [2, 1]}},
                                                {"half_plane": {"point": [0, 0], "normal": [1, 0]}}]})";
    for (const std::string& mirror : {std::string(), std::string(R"(, "place": {"mirror": "x"})")}) {
        const Scene scene = with_geometry(half + mirror);
        Selector selector;
        selector.part = "p";
        selector.facing = Vec2(mirror.empty() ? -1 : 1, 0);
        // The cut lies at x = 0, the round side beyond it: all that faces away from the kept half.
        const std::vector<EdgePortion> flat = select(scene, {selector});
        ASSERT_EQ(flat.size(), 1u) << mirror;
        EXPECT_EQ(geometry::kind_name(scene.parts[0].part.edges[static_cast<std::size_t>(flat[0].edge)].curve), "line");
        selector.facing = Vec2(-*selector.facing);
        const std::vector<EdgePortion> round = select(scene, {selector});
        ASSERT_EQ(round.size(), 1u) << mirror;
        const geometry::Curve& curve = scene.parts[0].part.edges[static_cast<std::size_t>(round[0].edge)].curve;
        for (const double t : {round[0].t0, round[0].t1}) {
            const Vec2 normal = geometry::outward_normal(curve, t);
            EXPECT_NEAR(normal.dot(*selector.facing), std::cos(5 * pi / 180), 1e-12);
            EXPECT_GT(geometry::point(curve, t).dot(*selector.facing), 1.9);
        }
    }
}

TEST(ReadScene, elliptic_arcs_of_loops) {
    const auto area = [](const std::string& first, const std::string& second) {
        return area_of(with_geometry(R"({"loops": [[)" + first + ", " + second + "]]}"));
    };
    const std::string flat = R"({"line": {"from": [3, 0], "to": [-3, 0]}})";
    EXPECT_NEAR(area(flat, R"({"elliptic_arc": {"center": [0, 0], "radii": [3, 2], "start": 0, "end": 180}})"), 3 * pi, 1e-12);
    EXPECT_NEAR(area(flat, R"({"elliptic_arc": {"center": [0, 0], "radii": [3, 2], "start": 180, "end": 0}})"), 3 * pi, 1e-12);
    // Half axes exchanged and turned by a quarter: the same curve, from -90 to 90 degrees.
    EXPECT_NEAR(
        area(flat, R"({"elliptic_arc": {"center": [0, 0], "radii": ["R", 3], "angle": 90, "start": -90, "end": "180/2"}})"),
        3 * pi, 1e-12);
    for (const char* end : {"360", "0", "-360"})
        EXPECT_NEAR(
            area_of(with_geometry(R"({"loops": [[{"elliptic_arc": {"center": [1, 1], "radii": [3, 2], "start": 0, "end": )" +
                                  std::string(end) + "}}]]}")),
            6 * pi, 1e-12)
            << end;
}

TEST(ReadScene, splines_of_loops) {
    // Under the parabola y = 1 - x^2.
    EXPECT_NEAR(area_of(with_geometry(R"({"loops": [[{"line": {"from": [-1, 0], "to": [1, 0]}},
                                                     {"bezier": {"points": [[1, 0], [0, "R"], [-1, 0]]}}]]})")),
                4.0 / 3, 1e-14);
    const Scene half = with_geometry(R"({"loops": [[{"line": {"from": [-1, 0], "to": [1, 0]}},
        {"bezier": {"points": [[1, 0], [1, 1], [0, 1]], "weights": [1, "sqrt(2)/2", 1]}},
        {"bezier": {"points": [[0, 1], [-1, 1], [-1, 0]], "weights": [1, "sqrt(2)/2", 1]}, "name": "round"}]]})");
    EXPECT_NEAR(area_of(half), pi / 2, 1e-13);
    EXPECT_EQ(edge_names(half.parts[0].part), Names({"e0", "e1", "round"}));
    EXPECT_EQ(geometry::kind_name(half.parts[0].part.edges[1].curve), "bezier");
    const Scene circle = with_geometry(R"({"loops": [[{"nurbs": {"degree": 2, "knots": [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4],
        "points": [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [1, 0]],
        "weights": [1, "sqrt(2)/2", 1, "sqrt(2)/2", 1, "sqrt(2)/2", 1, "sqrt(2)/2", 1]}}]]})");
    EXPECT_NEAR(area_of(circle), pi, 1e-13);
    EXPECT_NEAR(geometry::perimeter(circle.parts[0].part), 2 * pi, 1e-12);
    EXPECT_EQ(edge_names(circle.parts[0].part), Names({"e0"}));
    EXPECT_EQ(geometry::kind_name(circle.parts[0].part.edges[0].curve), "nurbs");
}

TEST(ReadScene, a_nurbs_with_corners_is_numbered_pieces) {
    const Scene scene = with_geometry(R"({"loops": [[{"nurbs": {"degree": 1, "knots": [0, 0, 1, 2, 3, 3],
        "points": [[0, 0], [2, 0], [2, 2], [0, 2]]}, "name": "cam"}, {"line": {"from": [0, 2], "to": [0, 0]}}]]})");
    EXPECT_NEAR(area_of(scene), 4, 1e-14);
    EXPECT_EQ(edge_names(scene.parts[0].part), Names({"cam#0", "cam#1", "cam#2", "e1"}));
    Selector selector;
    selector.pattern = "p/cam";
    EXPECT_EQ(select(scene, {selector}).size(), 3u);
    selector.pattern = "p/cam#1";
    ASSERT_EQ(select(scene, {selector}).size(), 1u);
    const auto right = static_cast<std::size_t>(select(scene, {selector})[0].edge);
    EXPECT_EQ(geometry::point(scene.parts[0].part.edges[right].curve, 0.5), Vec2(2, 1));
}

TEST(ReadScene, faults_of_curves_have_place_and_hint) {
    const auto fault = [](const std::string& geometry) -> std::string {
        try {
            with_geometry(geometry);
        } catch (const InputError& error) { return error.what(); }
        return "no error";
    };
    struct Case {
        std::string geometry;
        std::vector<std::string> words;
    };
    const auto edge = [](const std::string& text) { return R"({"loops": [[)" + text + "]]}"; };
    const std::string at = "/parts/0/geometry", at_edge = at + "/loops/0/0";
    const std::vector<Case> cases{
        {R"({"ellipse": {"center": [0, 0], "radii": [1, 0]}})", {at + "/ellipse/radii", "greater than 0"}},
        {R"({"ellipse": {"center": [0, 0], "radii": 3}})", {at + "/ellipse/radii", "two numbers"}},
        {R"({"ellipse": {"center": [0, 0], "radii": [1, 2], "radius": 3}})",
         {at + "/ellipse/radius", "unknown key", "'radii'"}},
        {R"({"slot": {"from": [1, 1], "to": [1, 1], "radius": 1}})", {at + "/slot", "begins where it ends", "circle"}},
        {R"({"slot": {"from": [1, 1], "to": [2, 1], "radius": -1}})", {at + "/slot/radius", "greater than 0"}},
        {R"({"mesh": {"file": "a.stl"}})", {at + "/mesh/file", "there is no such file"}},
        {R"({"place": {"of": {"circle": {"center": [0, 0], "radius": 1}}, "scale": 0}})",
         {at + "/place/scale", "greater than 0"}},
        {R"({"place": {"of": {"circle": {"center": [0, 0], "radius": 1}}, "mirror": "z"}})",
         {at + "/place/mirror", R"("x", "y")"}},
        {R"({"circle": {"center": [0, 0], "radius": 1}}, "place": {"scale": -1})", {"/parts/0/place/scale", "greater than 0"}},
        {R"({"circle": {"center": [0, 0], "radius": 1}}, "array": {"about": [0, 0]})", {"/parts/0/array", "count"}},
        {R"({"circle": {"center": [0, 0], "radius": 1}}, "array": {"count": 0, "about": [0, 0]})",
         {"/parts/0/array/count", "1"}},
        {R"({"circle": {"center": [0, 0], "radius": 1}}, "array": {"count": 2})", {"/parts/0/array", "step", "about"}},
        {R"({"circle": {"center": [0, 0], "radius": 1}}, "array": {"count": 2, "step": [1, 0], "angle": 9})",
         {"/parts/0/array/angle", "not turned"}},
        {edge(R"({"elliptic_arc": {"center": [0, 0], "radii": [1, 2], "start": 0}})"),
         {at_edge + "/elliptic_arc", "'end' is missing"}},
        {edge(R"({"elliptic_arc": {"center": [0, 0], "radii": [-1, 2], "start": 0, "end": 1}})"),
         {at_edge + "/elliptic_arc/radii", "greater than 0"}},
        {edge(R"({"bezier": {"points": [[0, 0]]}})"), {at_edge + "/bezier", "not valid"}},
        {edge(R"({"bezier": {"points": [[0, 0], [1, 1]], "weights": [1]}})"), {at_edge + "/bezier", "not valid"}},
        {edge(R"({"bezier": {"points": [[0, 0], [1, 1]], "weights": [1, -1]}})"), {at_edge + "/bezier", "not valid"}},
        {edge(R"({"bezier": {"points": [[0, 0], [1, "a"]]}})"), {at_edge + "/bezier/points/1/1", "'a'"}},
        {edge(R"({"nurbs": {"degree": 3, "knots": [0, 0, 1, 1], "points": [[0, 0], [1, 1]]}})"),
         {at_edge + "/nurbs", "not valid"}},
        {edge(R"({"nurbs": {"degree": 1, "knots": [0, 1, 0, 1], "points": [[0, 0], [1, 1]]}})"),
         {at_edge + "/nurbs", "not valid"}},
        {edge(R"({"nurbs": {"degree": 9, "knots": [0, 1], "points": [[0, 0], [1, 1]]}})"),
         {at_edge + "/nurbs/degree", "from 1 to 8"}},
        {edge(R"({"nurbs": {"knots": [0, 1], "points": [[0, 0], [1, 1]]}})"), {at_edge + "/nurbs", "'degree' is missing"}},
        {edge(R"({"nurb": {}})"), {at_edge + "/nurb", "unknown key", "'nurbs'"}},
        {edge(R"({"bezier": {"points": [[0, 0], [1, 1]]}, "line": {"from": [0, 0], "to": [1, 1]}})"),
         {at_edge, "cannot be combined"}},
    };
    for (const Case& c : cases) {
        const std::string message = fault(c.geometry);
        for (const std::string& word : c.words)
            EXPECT_NE(message.find(word), std::string::npos) << c.geometry << "\n" << message;
        EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 0) << message;
    }
}

TEST(ReadScene, supports) {
    const Scene scene = with_members(R"("supports": [
        {"on": "p/bottom", "fix": ["y"]},
        {"on": ["p/left", {"part": "p", "box": [[1, 1], [0.5, 0]]}], "displacement": {"x": "2*y"}},
        {"on": {"part": "p", "near": [0.5, 2]}, "roller": true},
        {"part": "p", "rigid": {"translation": [1, null], "rotation": 90}}])");
    ASSERT_EQ(scene.supports.size(), 4u);
    EXPECT_EQ(scene.supports[0].kind, Support::Kind::fix);
    EXPECT_FALSE(scene.supports[0].x);
    EXPECT_TRUE(scene.supports[0].y);
    EXPECT_EQ(scene.supports[0].on[0].pattern, "p/bottom");
    EXPECT_EQ(scene.supports[1].kind, Support::Kind::displacement);
    EXPECT_TRUE(scene.supports[1].x);
    EXPECT_FALSE(scene.supports[1].y);
    EXPECT_EQ(scene.supports[1].value[0](7, 3), 6);
    ASSERT_EQ(scene.supports[1].on.size(), 2u);
    EXPECT_EQ((*scene.supports[1].on[1].box)[0], Vec2(0.5, 0));  // corners in either order
    EXPECT_EQ(scene.supports[1].on[1].where, "/supports/1/on/1");
    EXPECT_EQ(scene.supports[2].kind, Support::Kind::symmetry);
    EXPECT_EQ(*scene.supports[2].on[0].near, Vec2(0.5, 2));
    EXPECT_EQ(scene.supports[3].kind, Support::Kind::rigid);
    EXPECT_EQ(scene.supports[3].part, "p");
    EXPECT_EQ(scene.supports[3].rigid_x, 1);
    EXPECT_FALSE(scene.supports[3].rigid_y);
    EXPECT_NEAR(*scene.supports[3].rigid_rotation, pi / 2, 1e-15);
}

TEST(ReadScene, loads) {
    const Scene scene = with_members(R"("loads": [
        {"on": "p/top", "pressure": "x"}, {"on": {"part": "p", "facing": [1, 0]}, "traction": ["x", "y"]}, {"on": "p/*", "force": [1, 2]},
        {"part": "p", "force": [3, 4]}, {"part": "*", "body_force": [0, "x+1"]}, {"gravity": [0, -9.81]}])");
    ASSERT_EQ(scene.loads.size(), 6u);
    EXPECT_EQ(scene.loads[0].kind, Load::Kind::pressure);
    EXPECT_EQ(scene.loads[0].value[0](5, 0), 5);
    EXPECT_EQ(scene.loads[1].kind, Load::Kind::traction);
    EXPECT_EQ(scene.loads[1].value[1](5, 6), 6);
    EXPECT_EQ(scene.loads[1].on[0].within, 5);
    EXPECT_EQ(scene.loads[2].kind, Load::Kind::edge_force);
    EXPECT_EQ(scene.loads[2].value[1].constant(), 2);
    EXPECT_EQ(scene.loads[3].kind, Load::Kind::part_force);
    EXPECT_EQ(scene.loads[3].part, "p");
    EXPECT_EQ(scene.loads[4].kind, Load::Kind::body_force);
    EXPECT_EQ(scene.loads[4].part, "*");
    EXPECT_EQ(scene.loads[4].value[1](2, 0), 3);
    EXPECT_EQ(scene.loads[5].kind, Load::Kind::gravity);
    EXPECT_EQ(scene.loads[5].where, "/loads/5");
}

TEST(ReadScene, gravity_needs_densities) {
    const auto scene = [](const std::string& density) {
        return R"({"abut": 1, "materials": {"m": {"E": 1, "nu": 0)" + density + R"(}}, "loads": [{"gravity": [0, -1]}],
                   "parts": [{"name": "p", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}}}]})";
    };
    EXPECT_THROW(scene_of(scene("")), InputError);
    EXPECT_NO_THROW(scene_of(scene(R"(, "density": 0)")));
}

TEST(ReadScene, contacts) {
    const ContactOptions contacts =
        with_members(R"("contacts": {"detect": false, "search_distance": 0.5, "formulation": "mortar", "friction": 0,
        "overlap": "press_fit", "pairs": [{"between": [["p/left", "p/top"], {"part": "p", "near": [1, 0.5]}], "kind": "ignore"},
                                          {"between": ["p/top", "p/bottom"], "interference": "1/100"}]})")
            .contacts;
    EXPECT_FALSE(contacts.detect);
    EXPECT_EQ(contacts.search_distance, 0.5);
    EXPECT_EQ(contacts.overlap, "press_fit");
    ASSERT_EQ(contacts.pairs.size(), 2u);
    EXPECT_EQ(contacts.pairs[0].kind, PairRule::Kind::ignore);
    ASSERT_EQ(contacts.pairs[0].between[0].size(), 2u);
    EXPECT_EQ(contacts.pairs[0].between[0][1].pattern, "p/top");
    EXPECT_EQ(contacts.pairs[0].between[1].front().part, "p");
    EXPECT_EQ(contacts.pairs[1].kind, PairRule::Kind::contact);
    EXPECT_EQ(contacts.pairs[1].interference, 0.01);
    EXPECT_FALSE(with_members(R"("contacts": {"search_distance": "auto"})").contacts.search_distance);
    EXPECT_EQ(contacts.friction, 0);
    EXPECT_FALSE(contacts.pairs[1].friction);
}

TEST(ReadScene, friction) {
    const auto read = [](const std::string& contacts) { return with_members("\"contacts\": {" + contacts + "}"); };
    const std::string between = R"("between": ["p/top", "p/bottom"])";
    EXPECT_EQ(read(R"("friction": "3/10")").contacts.friction, 0.3);
    EXPECT_TRUE(std::isinf(read(R"("friction": "rough")").contacts.friction));
    const Scene of_pair = read(R"("friction": 0.1, "pairs": [{)" + between + R"(, "friction": 0}, {)" + between + "}]");
    EXPECT_EQ(of_pair.contacts.pairs[0].friction, 0.0);
    EXPECT_FALSE(of_pair.contacts.pairs[1].friction);
    EXPECT_TRUE(of_pair.warnings.empty());
    const Scene large = read(R"("friction": 5.1)");
    ASSERT_EQ(large.warnings.size(), 1u);
    EXPECT_NE(large.warnings[0].find("/contacts/friction: a coefficient of friction of 5.1"), std::string::npos);
    for (const std::string& wrong :
         {std::string(R"("friction": -0.1)"), R"("pairs": [{)" + between + R"(, "kind": "bonded", "friction": 0.1}])",
          R"("pairs": [{)" + between + R"(, "kind": "ignore", "friction": 0.1}])",
          std::string(R"("formulation": "penalty", "friction": 0.1)"),
          R"("formulation": "penalty", "pairs": [{)" + between + R"(, "friction": 0.1}])"})
        EXPECT_THROW(read(wrong), InputError) << wrong;
    EXPECT_NO_THROW(read(R"("formulation": "penalty", "friction": 0)"));
    EXPECT_THROW(with_members(R"("contacts": {"friction": 0.2}, "accuracy": {"method": "dissertation"})"), InputError);
}

TEST(ReadScene, steps) {
    const std::string loads = R"("loads": [{"name": "pull", "on": "p/top", "pressure": 1}], )";
    const Scene scene = with_members(loads + R"("steps": [{"name": "a", "loads": {"pull": 1}}, {"name": "b", "loads": {}}])");
    EXPECT_TRUE(scene.in_steps);
    ASSERT_EQ(scene.cases.size(), 2u);
    const LoadCase middle = between(scene.cases[0], scene.cases[1], 0.25);
    EXPECT_EQ(middle.factors.at("pull"), 0.75);
    EXPECT_THROW(with_members(loads + R"("steps": [])"), InputError);
    EXPECT_THROW(with_members(loads + R"("steps": [{"name": "a", "loads": {"push": 1}}])"), InputError);
    EXPECT_THROW(with_members(loads + R"("steps": [{"name": "a", "loads": {}}], "cases": [{"name": "a", "loads": {}}])"),
                 InputError);
    EXPECT_THROW(case_named(scene, "b"), InputError) << "a step needs those before";
}

TEST(ReadScene, accuracy) {
    const Accuracy accuracy =
        with_members(R"("accuracy": {"level": "fine", "degree": 3, "cell_size": 0.1, "basis": "web", "dirichlet": "nitsche",
        "adapt": true, "solver": "cholmod", "refine": [{"near": [0, 1], "radius": 0.2, "cell_size": 0.01}],
        "grids": {"p": {"cells": [4, 8], "offset": [0.1, 0], "angle": 45, "degree": [2, 3],
            "refine": [{"from": [1, 0], "to": [0.5, 2], "levels": 3}, {"from": [0, 0], "to": [1, 1]}]}}})")
            .accuracy;
    EXPECT_EQ(accuracy.level, "fine");
    EXPECT_EQ(accuracy.degree, 3);
    EXPECT_EQ(accuracy.cell_size, 0.1);
    EXPECT_EQ(accuracy.basis, "web");
    EXPECT_EQ(accuracy.dirichlet, "nitsche");
    EXPECT_EQ(accuracy.adapt, true);
    EXPECT_TRUE(accuracy.by_cholmod);
    ASSERT_EQ(accuracy.refine.size(), 1u);
    EXPECT_EQ(accuracy.refine[0].near, Vec2(0, 1));
    EXPECT_EQ(accuracy.refine[0].radius, 0.2);
    const GridOptions& grid = accuracy.grids.at("p");
    EXPECT_EQ(grid.cells, (std::array<int, 2>{4, 8}));
    EXPECT_EQ(grid.offset, Vec2(0.1, 0));
    EXPECT_NEAR(grid.angle, pi / 4, 1e-15);
    EXPECT_EQ(grid.degree, (std::array<int, 2>{2, 3}));
    ASSERT_EQ(grid.refine.size(), 2u);
    EXPECT_EQ(grid.refine[0].low, Vec2(0.5, 0));
    EXPECT_EQ(grid.refine[0].high, Vec2(1, 2));
    EXPECT_EQ(grid.refine[0].levels, 3);
    EXPECT_EQ(grid.refine[1].levels, 1);
    EXPECT_FALSE(accuracy.target);
    EXPECT_EQ(with_members(R"("accuracy": {"target": 0.003})").accuracy.target, 0.003);
    EXPECT_FALSE(accuracy.budget.is_given());
    EXPECT_EQ(with_members(R"("accuracy": {"budget": "30 s, 2 GB"})").accuracy.budget.bytes, 2e9);
    const Accuracy knots =
        with_members(R"("accuracy": {"level": "fine", "grids": {"p": {"x": [0, 0.5, 1], "y": [0, 1]}}})").accuracy;
    EXPECT_EQ(knots.level, "fine");
    EXPECT_EQ(knots.grids.at("p").x, (std::vector<double>{0, 0.5, 1}));
    EXPECT_EQ(knots.grids.at("p").cells, (std::array<int, 2>{0, 0}));
}

TEST(ReadScene, output) {
    const Output output =
        with_members(R"("output": {"probes": [{"part": "p", "at": [0.5, 0.25]}], "formats": ["csv", "csv"]})").output;
    ASSERT_EQ(output.probes.size(), 1u);
    EXPECT_EQ(output.probes[0].at, Vec2(0.5, 0.25));
    EXPECT_EQ(output.formats, Names({"csv"}));
}

TEST(ReadScene, assembly_renames_ignores_and_assigns) {
    const Scene scene =
        scene_of(R"({"abut": 1, "thickness": 2, "materials": {"steel": {"E": 1, "nu": 0}, "brass": {"E": 1, "nu": 0}},
        "assembly": {"file": ")" +
                 drawing + R"(", "parts_by": "layer", "material": "steel",
                     "parts": {"pin": {"name": "bolt", "material": "brass", "thickness": 7}, "base": "ignore", "NOTES": "ignore"}}})");
    ASSERT_EQ(scene.parts.size(), 2u);
    EXPECT_EQ(scene.parts[0].name, "bracket");
    EXPECT_EQ(scene.parts[0].material, 0);
    EXPECT_EQ(scene.parts[0].thickness, 2);
    EXPECT_EQ(scene.parts[1].name, "bolt");
    EXPECT_EQ(scene.parts[1].part.name, "bolt");
    EXPECT_EQ(scene.parts[1].material, 1);
    EXPECT_EQ(scene.parts[1].thickness, 7);
    ASSERT_EQ(scene.imports.size(), 1u);
    EXPECT_EQ(scene.imports[0].unit, "mm");
    EXPECT_EQ(scene.imports[0].factor, 1);
}

TEST(ReadScene, assembly_faults) {
    const auto fault = [](const std::string& more) -> std::string {
        try {
            scene_of(R"({"abut": 1, "materials": {"m": {"E": 1, "nu": 0}}, "assembly": {"file": ")" + drawing + "\"" + more +
                     "}}");
        } catch (const InputError& error) { return error.what(); }
        return "no error";
    };
    EXPECT_EQ(fault(R"(, "material": "m")"), "no error");
    EXPECT_NE(fault("").find("the part 'bracket' has no material"), std::string::npos);
    EXPECT_NE(fault(R"(, "material": "m", "parts": {"bolt": {"name": "x"}})")
                  .find("/assembly/parts/bolt: the drawing has no part 'bolt'"),
              std::string::npos);
    EXPECT_NE(
        fault(R"(, "material": "m", "parts": {"pin": {"name": "base"}})").find("there are two parts with the name 'base'"),
        std::string::npos);
    EXPECT_NE(fault(R"(, "material": "m", "parts": {"pin": "ignored"})").find("expected one of \"ignore\""), std::string::npos);
    EXPECT_NE(fault(R"(, "material": "m", "parts_by": "component")").find("expected one of \"auto\""), std::string::npos);
}

TEST(ReadScene, imports_are_converted_where_both_units_are_stated) {
    const auto pin = [](const std::string& units) {
        const Scene scene = scene_of(R"({"abut": 1, )" + units + R"("materials": {"m": {"E": 1, "nu": 0}},
            "parts": [{"name": "p", "material": "m", "geometry": {"dxf": {"file": ")" +
                                     drawing + R"(", "layer": "pin"}}}]})");
        return std::pair(area_of(scene), scene.imports.at(0).factor);
    };
    const auto [drawn, one] = pin("");
    EXPECT_EQ(one, 1);
    EXPECT_NEAR(drawn, 100 * pi, 1e-9);  // the sketch's pin has radius 10
    const auto [converted, factor] = pin(R"("units": {"length": "cm"}, )");
    EXPECT_NEAR(factor, 0.1, 1e-15);
    EXPECT_NEAR(converted, pi, 1e-11);
    EXPECT_THROW(pin(R"("units": {"length": "parsec"}, )"), InputError);
}

TEST(ReadScene, a_dxf_node_stands_for_one_part) {
    try {
        with_geometry(R"({"dxf": {"file": ")" + drawing + R"("}})");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("the file bounds 3 parts here, not one: bracket, pin, base"),
                  std::string::npos)
            << error.what();
    }
    EXPECT_THROW(with_geometry(R"({"dxf": {"file": ")" + drawing + R"(", "layer": "bolt"}})"), InputError);
}

TEST(ReadScene, files_are_relative_to_the_scene) {
    const TemporaryFolder folder;
    std::filesystem::copy_file(drawing, folder.path("a.dxf"));
    const std::string scene = folder.write(
        "s.json", R"({"abut": 1, "materials": {"m": {"E": 1, "nu": 0}}, "assembly": {"file": "a.dxf", "material": "m"}})");
    EXPECT_EQ(read_scene(scene).parts.size(), 3u);
}

TEST(ReadScene, a_bare_sketch_becomes_a_scene_without_materials) {
    const SketchReading reading = read_sketch(drawing, {});
    ASSERT_EQ(reading.scene.parts.size(), 3u);
    EXPECT_EQ(reading.scene.parts[1].name, "pin");
    EXPECT_EQ(reading.scene.parts[1].material, -1);
    EXPECT_EQ(reading.scene.length_unit, "mm");
    EXPECT_EQ(reading.sketch.parts.size(), 3u);
    EXPECT_EQ(reading.scene.imports.size(), 1u);
    ImportOptions inches;
    inches.units = "in";
    EXPECT_EQ(read_sketch(drawing, inches).scene.length_unit, "in");
    EXPECT_THROW(read_sketch("/nowhere.dxf", {}), InputError);
}

}  // namespace abut::read_scene_test
