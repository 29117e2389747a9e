// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/inspection/inspect.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "src/scene/read_drawing.hpp"
#include "tests/geometry/dxf/dxf_text.hpp"
#include "tests/src/io/temporary_folder.hpp"

namespace abut::inspect_test {
namespace {

abut::ImportOptions in_unit(const std::string& unit) {
    abut::ImportOptions options;
    options.units = unit;
    return options;
}

using geometry::dxf_circle;
using geometry::dxf_file;
using geometry::dxf_line;
using geometry::dxf_record;
using geometry::dxf_rectangle;
using Json = nlohmann::json;

constexpr double pi = std::numbers::pi;
const std::string pin_bracket = std::string(ABUT_SOURCE_DIR) + "/data/sketches/pin_bracket_r14.dxf";

Inspection inspect(const std::string& entities) {
    const TemporaryFolder folder;
    return inspect_file(folder.write("drawing.dxf", dxf_file(entities)), in_unit("mm"));
}

/// A sound plate, a gap that is closed, one that is not, and a text that is left out.
Inspection inspect_mixture() {
    return inspect(dxf_rectangle("A", "plate", 0, 0, 100, 50) + dxf_circle("B", "plate", 50, 25, 10) +
                   dxf_line("C0", "lid", 0, 60, 99.9999, 60) + dxf_line("C1", "lid", 100, 60, 100, 70) +
                   dxf_line("C2", "lid", 100, 70, 0, 70) + dxf_line("C3", "lid", 0, 70, 0, 60) +
                   dxf_line("D0", "open", 0, 80, 100, 80) + dxf_line("D1", "open", 100, 80, 50, 95) +
                   dxf_line("D2", "open", 50, 95, 0, 81) + dxf_record("TEXT", "E", "plate", {}));
}

int count(const std::string& text, const std::string& piece) {
    int n = 0;
    for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++n;
    return n;
}

bool has(const std::string& text, const std::string& piece) {
    return count(text, piece) > 0;
}

TEST(Inspect, DescribesADrawingAsJson) {
    const Json json = Json::parse(inspection_json(inspect_file(pin_bracket, {})));
    EXPECT_EQ(json["abut"], 1);
    EXPECT_EQ(json["file"], pin_bracket);
    EXPECT_EQ(json["format"], "DXF AC1014");
    EXPECT_EQ(json["unit"], "mm");
    EXPECT_EQ(json["size"], Json::parse("[160, 85]"));
    EXPECT_EQ(json["entities"]["LINE"], Json::parse(R"({"read": 11, "used": 11, "ignored": 0})"));
    ASSERT_EQ(json["parts"].size(), 3u);
    const Json& pin = json["parts"][1];
    EXPECT_EQ(pin["name"], "pin");
    EXPECT_NEAR(pin["area"].get<double>(), 100 * pi, 1e-9);
    EXPECT_NEAR(pin["perimeter"].get<double>(), 20 * pi, 1e-9);
    EXPECT_NEAR(pin["centroid"][1].get<double>(), 49.95, 1e-9);
    EXPECT_EQ(pin["holes"], 0);
    EXPECT_EQ(json["parts"][0]["holes"], 3);
    const Json& edge = json["parts"][0]["edges"][0];
    EXPECT_EQ(edge["name"], "hA08");
    EXPECT_EQ(edge["kind"], "line");
    EXPECT_EQ(edge["length"], 34);
    EXPECT_EQ(edge["from"], Json::parse("[-26, 12]"));
    EXPECT_EQ(edge["to"], Json::parse("[-60, 12]"));
    EXPECT_EQ(pin["edges"][0]["kind"], "arc");
    for (const char* list : {"repairs", "ignored", "problems"}) EXPECT_EQ(json[list], Json::array()) << list;
}

TEST(Inspect, TellsOfRepairsProblemsAndOmissions) {
    const Json json = Json::parse(inspection_json(inspect_mixture()));
    EXPECT_EQ(json["unit"], "mm");
    ASSERT_EQ(json["repairs"].size(), 1u);
    EXPECT_NEAR(json["repairs"][0]["size"].get<double>(), 1e-4, 1e-10);
    EXPECT_NEAR(json["repairs"][0]["at"][0].get<double>(), 100, 1e-9);
    ASSERT_EQ(json["problems"].size(), 1u);
    EXPECT_EQ(json["problems"][0]["entity"], "hD0, hD2");
    EXPECT_NEAR(json["problems"][0]["at"][1].get<double>(), 80.5, 1e-9);
    EXPECT_GT(json["problems"][0]["line"], 0);
    EXPECT_EQ(json["ignored"], Json::parse(R"([{"what": "TEXT", "count": 1, "why": "annotation"}])"));
    EXPECT_EQ(json["entities"]["TEXT"]["ignored"], 1);
}

TEST(Inspect, PrintsATableForPeople) {
    const std::string table = inspection_table(inspect_mixture());
    EXPECT_TRUE(has(table, "plate  100 x 50")) << table;
    EXPECT_TRUE(has(table, "plate/: hA0, hA1, hA2, hA3, hB")) << table;
    EXPECT_TRUE(has(table, "1 TEXT: annotation")) << table;
    EXPECT_TRUE(has(table, "gap closed between hC0 and hC1, 0.0001, at (100, 60)")) << table;
    EXPECT_TRUE(has(table, "the ends of hD0, hD2 are 1 apart")) << table;
    EXPECT_TRUE(has(table, "drawing.dxf:")) << table;
}

TEST(Inspect, TellsOfUnitsAndOfHowPartsWereToldApart) {
    const TemporaryFolder folder;
    const std::string plate = dxf_rectangle("A", "plate", 0, 0, 10, 5);
    const std::string bare = folder.write("bare.dxf", dxf_file(plate));
    const std::string inches =
        folder.write("in.dxf", dxf_file(plate, geometry::dxf_section("HEADER", "9\n$INSUNITS\n70\n1\n")));
    EXPECT_TRUE(has(inspection_table(inspect_file(bare, {})), ": the file states no unit of length; --units mm"));
    EXPECT_TRUE(has(inspection_table(inspect_file(bare, {})), "parts by loop: layer plate alone holds closed outlines"));
    EXPECT_FALSE(has(inspection_table(inspect_file(bare, in_unit("mm"))), "states"));
    EXPECT_TRUE(has(inspection_table(inspect_file(inches, {})), "in, 10 x 5 (254 x 127 mm)"));
    const std::string replaced = inspection_table(inspect_file(inches, in_unit("mm")));
    EXPECT_TRUE(has(replaced, "the file states in; its numbers are taken as mm")) << replaced;
    EXPECT_TRUE(has(replaced, "mm, 10 x 5\n")) << replaced;
}

TEST(Inspect, AFileThatHoldsNothingIsAFault) {
    for (const std::string& entities : {std::string(), dxf_record("TEXT", "E", "plate", {})}) {
        const Inspection inspection = inspect(entities);
        ASSERT_EQ(inspection.problems.size(), 1u);
        EXPECT_TRUE(has(inspection.problems[0].what, "holds no line, arc or other curve"));
        EXPECT_FALSE(has(inspection_table(inspection), "at (0, 0)"));
    }
}

TEST(Inspect, SaysThatThereAreNoParts) {
    const Inspection inspection = inspect(dxf_record("SPLINE", "E", "plate", {}));
    EXPECT_TRUE(has(inspection_table(inspection), "no parts"));
    EXPECT_EQ(Json::parse(inspection_json(inspection))["parts"], Json::array());
    EXPECT_TRUE(has(inspection_svg(inspection), "</svg>"));
}

/// An elliptic cam that a flat follower touches, and a NURBS edge on the follower's back.
Inspection inspect_cam(const std::string& more = "") {
    const TemporaryFolder folder;
    return inspect_file(folder.write("cam.json", R"({"abut": 1, "materials": {"m": {"E": 1, "nu": 0}}, "parts": [
        {"name": "cam", "material": "m", "geometry": {"ellipse": {"center": [0, -1], "radii": [3, 1]}}},
        {"name": "flat", "material": "m", "geometry": {"loops": [[
            {"line": {"from": [-2, 0], "to": [2, 0]}}, {"line": {"from": [2, 0], "to": [2, 1]}},
            {"nurbs": {"degree": 2, "knots": [0, 0, 0, 1, 2, 2, 2], "points": [[2, 1], [1, 2], [-1, 2], [-2, 1]]}},
            {"bezier": {"points": [[-2, 1], [-2.5, 0.5], [-2, 0]]}, "name": "side"}]]}}])" +
                                                     more + "}"),
                        {});
}

TEST(Inspect, TellsTheKindsOfCurves) {
    const Json json = Json::parse(inspection_json(inspect_cam()));
    std::map<std::string, std::string> kinds;
    for (const Json& part : json["parts"])
        for (const Json& edge : part["edges"]) kinds[edge["name"]] = edge["kind"];
    EXPECT_EQ(kinds, (std::map<std::string, std::string>{
                         {"ellipse", "ellipse"}, {"e0", "line"}, {"e1", "line"}, {"e2", "nurbs"}, {"side", "bezier"}}));
    EXPECT_NEAR(json["parts"][0]["area"].get<double>(), 3 * pi, 1e-12);
}

TEST(Inspect, ShowsRepairsOfTheScenesOwnGeometry) {
    Inspection inspection = inspect_cam();
    inspection.scene.parts[1].repairs = {{"sliver left out", {1, 2}, 1e-9}};
    const Json json = Json::parse(inspection_json(inspection));
    ASSERT_EQ(json["repairs"].size(), 1u);
    EXPECT_EQ(json["repairs"][0], Json::parse(R"({"what": "part flat: sliver left out", "at": [1, 2], "size": 1e-9})"));
    EXPECT_TRUE(has(inspection_table(inspection), "part flat: sliver left out, 1e-09, at (1, 2)"));
    EXPECT_TRUE(has(inspection_svg(inspection), "repair: part flat: sliver left out"));
}

std::string picture(const Inspection& inspection, const std::string& file) {
    for (const InspectionPicture& p : stage_pictures(inspection))
        if (p.file == file) return p.svg;
    return "";
}

TEST(Inspect, DrawsTheCellsOfTheFirstGrids) {
    const Inspection inspection =
        inspect_cam(R"(, "accuracy": {"grids": {"cam": {"cells": [6, 2]}, "flat": {"cells": [4, 4]}}})");
    const std::string svg = picture(inspection, "inspect_cells.svg");
    // The ellipse with half axes 3 and 1 runs through every cell of side 1 around its middle.
    EXPECT_TRUE(has(svg, "cam: 6 x 2 cells, 0 inner, 12 boundary, 0 outer")) << svg.substr(svg.size() - 600);
    EXPECT_TRUE(has(svg, "flat: 4 x 4 cells, "));
    for (const char* name : {"class=\"inner\"", "class=\"boundary\"", "class=\"outer\"", "class=\"outline\""})
        EXPECT_EQ(count(svg, name), 2) << name;
}

TEST(Inspect, DrawsEveryBoundaryPieceWithItsEnds) {
    const Inspection inspection =
        inspect_cam(R"(, "accuracy": {"grids": {"cam": {"cells": [6, 2]}, "flat": {"cells": [2, 1]}}})");
    const std::string svg = picture(inspection, "inspect_pieces.svg");
    EXPECT_TRUE(has(svg, "cam: 12 pieces of 1 edges") || has(svg, "cam: 13 pieces of 1 edges")) << svg.substr(svg.size() - 600);
    EXPECT_EQ(count(svg, "class=\"tick_mark\""), 2);
}

TEST(Inspect, DrawsWherePartsFaceEachOther) {
    const std::string svg = picture(inspect_cam(), "inspect_candidates.svg");
    EXPECT_EQ(count(svg, "class=\"zone\""), 1);
    EXPECT_TRUE(has(svg, "cam/ellipse - flat/e0: gap ")) << svg.substr(svg.size() - 600);
    EXPECT_TRUE(has(svg, "ended by the search distance"));
    EXPECT_GE(count(svg, "class=\"pair\""), 3);
}

TEST(Inspect, StagesNeedPartsAndCandidatesTwo) {
    EXPECT_TRUE(stage_pictures(inspect(dxf_record("SPLINE", "E", "plate", {}))).empty());
    EXPECT_EQ(stage_pictures(inspect(dxf_rectangle("A", "plate", 0, 0, 100, 50))).size(), 2u);
    EXPECT_EQ(stage_pictures(inspect_cam()).size(), 3u);
}

TEST(Inspect, DrawsPartsEdgesAndMarks) {
    const std::string svg = inspection_svg(inspect_mixture());
    EXPECT_EQ(count(svg, "class=\"part\""), 2);
    EXPECT_EQ(count(svg, "class=\"loose\""), 3);  // the lines of the outline that is open
    EXPECT_EQ(count(svg, "class=\"way\""), 9);    // a head on every edge tells its direction
    for (const char* name : {">hA0<", ">hA2<", ">hB<", ">hC2<", ">plate<", ">x [mm]<"}) EXPECT_EQ(count(svg, name), 1) << name;
    EXPECT_EQ(count(svg, "class=\"problem\""), 2);  // at its place and in the legend
    EXPECT_EQ(count(svg, "class=\"repair\""), 2);
    EXPECT_TRUE(has(svg, "problem: open outline on layer open"));
    EXPECT_TRUE(has(svg, "repair: gap closed between hC0 and hC1"));
}

TEST(Inspect, LabelsOnlyAsManyEdgesAsAreReadable) {
    std::string comb;
    constexpr int n = 400;  // teeth of less than two pixels
    for (int i = 0; i < n; ++i) {
        const std::string id = std::to_string(10000 + 10 * i);
        comb += dxf_line(id + "1", "comb", i, 0, i + 0.5, 10) + dxf_line(id + "2", "comb", i + 0.5, 10, i + 1, 0);
    }
    comb += dxf_line("A", "comb", n, 0, n, -50) + dxf_line("B", "comb", n, -50, 0, -50) + dxf_line("C", "comb", 0, -50, 0, 0);
    const std::string svg = inspection_svg(inspect(comb));
    for (const char* name : {">hA<", ">hB<", ">hC<"}) EXPECT_EQ(count(svg, name), 1) << name;
    EXPECT_LT(count(svg, "class=\"edge\""), 100);
}

TEST(Inspect, EscapesNames) {
    const std::string svg = inspection_svg(inspect(dxf_rectangle("A", "a<b&c", 0, 0, 100, 50)));
    EXPECT_TRUE(has(svg, "a&lt;b&amp;c"));
    EXPECT_FALSE(has(svg, "a<b"));
}

TEST(Inspect, RefusesUnknownKindsOfFiles) {
    try {
        inspect_file("part.iges", {});
        FAIL() << "not refused";
    } catch (const InputError& error) {
        EXPECT_EQ(error.problems().at(0).where, "part.iges");
        EXPECT_TRUE(has(error.what(), ".iges"));
    }
}

TEST(Inspect, DescribesAScene) {
    const TemporaryFolder folder;
    const std::string path = folder.write("scene.json", R"({
        "abut": 1, "units": {"length": "mm", "force": "N"}, "materials": {"steel": {"E": 210000, "nu": 0.3}},
        "parts": [{"name": "block", "material": "steel", "geometry": {"rectangle": {"min": [0, 0], "max": [4, 2]}}}],
        "supports": [{"on": "block/bottom", "fix": ["x", "y"]}]})");
    const Json json = Json::parse(inspection_json(inspect_file(path, {})));
    EXPECT_EQ(json["unit"], "mm");
    ASSERT_EQ(json["parts"].size(), 1u);
    EXPECT_NEAR(json["parts"][0]["area"].get<double>(), 8, 1e-12);
    EXPECT_EQ(json["parts"][0]["edges"].size(), 4u);
    EXPECT_EQ(json["entities"], Json::object());
}

}  // namespace
}  // namespace abut::inspect_test
