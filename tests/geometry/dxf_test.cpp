// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>

#include "geometry/input_error.hpp"
#include "geometry/sketch.hpp"
#include "tests/geometry/dxf_text.hpp"
#include "tests/src/temporary_folder.hpp"

namespace abut::geometry {
namespace {

constexpr double pi = std::numbers::pi;
const std::string pin_bracket = std::string(ABUT_SOURCE_DIR) + "/data/sketches/pin_bracket_r14.dxf";

std::string read_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

Drawing read(const std::string& text) {
    const TemporaryFolder folder;
    return read_dxf(folder.write("test.dxf", text));
}

/// The one problem of a file that is refused; empty if it is read.
Problem refusal(const std::string& text) {
    const TemporaryFolder folder;
    try {
        read_dxf(folder.write("test.dxf", text));
    } catch (const InputError& error) { return error.problems().at(0); }
    return {};
}

bool has(const std::string& text, const std::string& piece) {
    return text.find(piece) != std::string::npos;
}

void expect_near(const Vec2& a, const Vec2& b, double tolerance = 1e-12) {
    EXPECT_LE((a - b).norm(), tolerance) << a.transpose() << " | " << b.transpose();
}

void expect_same_entities(const Drawing& a, const Drawing& b) {
    ASSERT_EQ(a.entities.size(), b.entities.size());
    for (std::size_t i = 0; i < a.entities.size(); ++i) {
        EXPECT_EQ(a.entities[i].kind, b.entities[i].kind);
        EXPECT_EQ(a.entities[i].layer, b.entities[i].layer);
        for (double t : {0.0, 0.3, 1.0}) EXPECT_EQ(point(a.entities[i].curve, t), point(b.entities[i].curve, t));
    }
}

TEST(Dxf, ReadsTheEntitiesOfADrawing) {
    const Drawing drawing = read_dxf(pin_bracket);
    EXPECT_EQ(drawing.format, "DXF AC1014");
    EXPECT_EQ(drawing.unit, "mm");
    ASSERT_EQ(drawing.entities.size(), 18u);
    EXPECT_TRUE(drawing.ignored.empty());
    EXPECT_TRUE(drawing.problems.empty());
    EXPECT_EQ(drawing.counts.at("LINE").used, 11);
    EXPECT_EQ(drawing.counts.at("ARC").used, 3);
    EXPECT_EQ(drawing.counts.at("CIRCLE").used, 4);

    const SketchEntity& line = drawing.entities[0];
    EXPECT_EQ(line.name, "hA08");
    EXPECT_EQ(line.layer, "bracket");
    expect_near(point(line.curve, 0), {-26, 12}, 0);
    expect_near(point(line.curve, 1), {-60, 12}, 0);
    const Arc fillet = std::get<Arc>(drawing.entities[1].curve);  // written from -90 to 0 degrees
    expect_near(point(fillet, 0), {-26, 12});
    expect_near(point(fillet, 1), {-20, 18});
}

TEST(Dxf, KnowsTheLineOfEachEntity) {
    std::istringstream file(read_text(pin_bracket));
    std::vector<std::string> lines{""};
    for (std::string line; std::getline(file, line);) lines.push_back(line.substr(0, line.find('\r')));
    for (const SketchEntity& entity : read_dxf(pin_bracket).entities) {
        ASSERT_LT(static_cast<std::size_t>(entity.line), lines.size());
        EXPECT_EQ(lines[static_cast<std::size_t>(entity.line)], entity.kind);
    }
}

TEST(Dxf, RefusesWhatIsNoDrawing) {
    EXPECT_TRUE(has(refusal("").what, "empty"));
    EXPECT_TRUE(has(refusal(std::string("AutoCAD Binary DXF\r\n\x1a\0rest", 26)).what, "binary DXF is not read yet"));
    EXPECT_TRUE(has(refusal(std::string("AutoCAD Binary DXF\r\n\x1a\0rest", 26)).hint, "ASCII"));
    EXPECT_TRUE(has(refusal("AC1032 and so on").what, "DWG"));
    EXPECT_TRUE(has(refusal("solid part\nfacet\n").what, "no DXF file"));
    EXPECT_TRUE(has(refusal("2\nENTITIES\n0\nEOF\n").what, "does not begin with a section"));
    EXPECT_TRUE(has(refusal("0\nEOF\n").what, "no section"));
    EXPECT_THROW(read_dxf("no_such_file.dxf"), InputError);
    EXPECT_THROW(read_dxf(std::filesystem::temp_directory_path().string()), InputError);
}

TEST(Dxf, NamesTheLineOfDamage) {
    const std::string good = dxf_file(dxf_line("1", "A", 0, 0, 1, 0));
    ASSERT_EQ(refusal(good).what, "");
    const Problem truncated = refusal(good.substr(0, good.find("0\nENDSEC")));
    EXPECT_TRUE(has(truncated.what, "truncated")) << truncated.what;
    EXPECT_TRUE(has(truncated.what, "ENTITIES"));
    EXPECT_TRUE(has(truncated.where, "test.dxf:18")) << truncated.where;

    std::string unclosed = good;
    unclosed.erase(unclosed.find("0\nENDSEC\n"), 9);
    EXPECT_TRUE(has(refusal(unclosed).what, "has no ENDSEC"));
    EXPECT_TRUE(has(refusal(unclosed).where, "test.dxf:20")) << refusal(unclosed).where;

    std::string shifted = good;
    shifted.insert(shifted.find("10\n"), "stray\n");
    EXPECT_TRUE(has(refusal(shifted).what, "'stray'"));
    EXPECT_TRUE(has(refusal(shifted).where, "test.dxf:11")) << refusal(shifted).where;
}

TEST(Dxf, AcceptsLineEndsPaddingAndDecimalCommas) {
    const std::string text = dxf_file(dxf_line("1", "A", 0.25, 0, 1, 0) + dxf_arc("2", "B", 1, 2, 3.5, 10, 100));
    const Drawing plain = read(text);
    const auto replaced = [&](const std::string& from, const std::string& to) {
        std::string changed;
        for (char c : text) changed += from[0] == c ? to : std::string(1, c);
        return changed;
    };
    expect_same_entities(read(replaced("\n", "\r\n")), plain);
    expect_same_entities(read(replaced("\n", "\r")), plain);
    expect_same_entities(read(replaced("\n", "  \t\r\n   ")), plain);
    expect_same_entities(read(replaced(".", ",")), plain);
    expect_same_entities(read("\xEF\xBB\xBF" + text), plain);
    expect_same_entities(read("999\nwritten by hand\n" + text), plain);
}

TEST(Dxf, NormalisesTheAnglesOfArcs) {
    const auto sweep = [](double from, double to) {
        return std::get<Arc>(read(dxf_file(dxf_arc("1", "A", 0, 0, 1, from, to))).entities.at(0).curve).sweep * 180 / pi;
    };
    EXPECT_NEAR(sweep(-90, 0), 90, 1e-12);
    EXPECT_NEAR(sweep(350, 10), 20, 1e-12);
    EXPECT_NEAR(sweep(270, 180), 270, 1e-12);
    EXPECT_NEAR(sweep(0, 540), 180, 1e-12);
    EXPECT_NEAR(sweep(180, -90), 90, 1e-12);
    EXPECT_NEAR(sweep(30, 30), 360, 1e-12);
    EXPECT_NEAR(sweep(0, 360), 360, 1e-12);
}

TEST(Dxf, SplitsPolylinesIntoSegmentsAndArcs) {
    // a slot: two sides and two half circles (bulge 1), the closing one among them
    const std::string light = dxf_record(
        "LWPOLYLINE", "2f", "A",
        {{90, 4}, {70, 1}, {10, 0}, {20, 0}, {10, 6}, {20, 0}, {42, 1}, {10, 6}, {20, 2}, {10, 0}, {20, 2}, {42, 1}});
    const std::string heavy =
        dxf_record("POLYLINE", "2F", "A", {{66, 1}, {70, 1}, {10, 0}, {20, 0}}) +
        dxf_record("VERTEX", "30", "A", {{10, 0}, {20, 0}}) + dxf_record("VERTEX", "31", "A", {{10, 6}, {20, 0}, {42, 1}}) +
        dxf_record("VERTEX", "32", "A", {{10, 6}, {20, 2}}) + dxf_record("VERTEX", "33", "A", {{10, 0}, {20, 2}, {42, 1}}) +
        dxf_record("SEQEND", "34", "A", {});
    for (const std::string& text : {light, heavy}) {
        const Drawing drawing = read(dxf_file(text + dxf_circle("40", "B", 0, 0, 1)));
        ASSERT_EQ(drawing.entities.size(), 5u);
        EXPECT_EQ(drawing.entities[0].name, "h2F.0");
        EXPECT_EQ(drawing.entities[3].name, "h2F.3");
        EXPECT_EQ(drawing.entities[4].name, "h40");
        EXPECT_EQ(drawing.entities[0].layer, "A");
        const Arc right = std::get<Arc>(drawing.entities[1].curve), left = std::get<Arc>(drawing.entities[3].curve);
        expect_near(right.center, {6, 1});
        expect_near(left.center, {0, 1});
        EXPECT_NEAR(right.radius, 1, 1e-12);
        EXPECT_NEAR(right.sweep, pi, 1e-12);
        expect_near(point(left, 0), {0, 2});
        expect_near(point(left, 1), {0, 0});
        expect_near(point(left, 0.5), {-1, 1});
        EXPECT_EQ(drawing.counts.at(drawing.entities[0].kind).read, 1);  // counted once, not by segment or vertex
    }
}

TEST(Dxf, BulgesTurnTheWayOfTheirSign) {
    for (double bulge : {0.2, -0.2, 1.7, -1.7}) {
        const Drawing drawing = read(
            dxf_file(dxf_record("LWPOLYLINE", "1", "A", {{90, 2}, {70, 0}, {10, 1}, {20, 2}, {42, bulge}, {10, 4}, {20, 6}})));
        ASSERT_EQ(drawing.entities.size(), 1u);
        const Curve& arc = drawing.entities[0].curve;
        expect_near(point(arc, 0), {1, 2});
        expect_near(point(arc, 1), {4, 6});
        // the sagitta is bulge times half the chord, to the right of the chord where the arc turns left
        expect_near(point(arc, 0.5), Vec2(2.5, 4) + bulge * 2.5 * Vec2(0.8, -0.6));
    }
}

TEST(Dxf, TurnsEntitiesSeenFromBelow) {
    const Drawing drawing = read(
        dxf_file(dxf_record("ARC", "1", "A", {{10, -3}, {20, 1}, {40, 2}, {50, 0}, {51, 90}, {210, 0}, {220, 0}, {230, -1}}) +
                 dxf_record("LINE", "2", "A", {{10, 1}, {20, 1}, {11, 2}, {21, 2}, {230, -1}}) +
                 dxf_record("CIRCLE", "3", "A", {{10, 1}, {20, 1}, {40, 2}, {210, 1}, {230, 0}})));
    ASSERT_EQ(drawing.entities.size(), 2u);
    expect_near(point(drawing.entities[0].curve, 0), {1, 1});  // at angle 0 of its own plane: x = -3 + 2, mirrored
    expect_near(point(drawing.entities[0].curve, 1), {3, 3});
    expect_near(point(drawing.entities[1].curve, 1), {2, 2});  // lines are in the drawing's coordinates
    ASSERT_EQ(drawing.ignored.size(), 1u);
    EXPECT_EQ(drawing.ignored[0].why, "not in the drawing's plane");
}

TEST(Dxf, CountsWhatIsLeftOutAndSaysWhy) {
    const std::string layers = dxf_section("TABLES",
                                           "0\nTABLE\n2\nLAYER\n0\nLAYER\n2\nOff\n62\n-7\n0\nLAYER\n2\nFrozen\n70\n1\n"
                                           "0\nLAYER\n2\nAxes\n6\nCENTER2\n0\nENDTAB\n");
    const Drawing drawing = read(dxf_file(
        dxf_line("1", "A", 0, 0, 1, 0) + dxf_line("2", "OFF", 0, 0, 1, 0) + dxf_line("3", "Frozen", 0, 0, 1, 0) +
            dxf_line("4", "Axes", 0, 0, 1, 0) + dxf_record("SPLINE", "5", "A", {}) + dxf_record("SPLINE", "6", "A", {}) +
            dxf_record("TEXT", "7", "A", {}) + dxf_record("LINE", "8", "A", {{67, 1}, {10, 0}, {20, 0}, {11, 1}, {21, 1}}) +
            dxf_record("CIRCLE", "9", "A", {{60, 1}, {10, 0}, {20, 0}, {40, 1}}),
        layers));
    const auto why = [&](const std::string& what) {
        for (const Ignored& ignored : drawing.ignored)
            if (ignored.what == what) return std::to_string(ignored.count) + " " + ignored.why;
        return std::string("not ignored");
    };
    EXPECT_EQ(drawing.entities.size(), 1u);
    EXPECT_EQ(why("LINE on layer OFF"), "1 layer is off");
    EXPECT_EQ(why("LINE on layer Frozen"), "1 layer is frozen");
    EXPECT_EQ(why("SPLINE"), "2 not read by this version");
    EXPECT_EQ(why("TEXT"), "1 annotation");
    EXPECT_EQ(why("CIRCLE"), "1 invisible");
    EXPECT_TRUE(std::any_of(drawing.ignored.begin(), drawing.ignored.end(),
                            [](const Ignored& i) { return i.why == "line type CENTER2"; }));
    EXPECT_TRUE(std::any_of(drawing.ignored.begin(), drawing.ignored.end(),
                            [](const Ignored& i) { return i.why == "in paper space"; }));
    EXPECT_EQ(drawing.counts.at("LINE").read, 4);  // the one in paper space is not of this drawing
    int read = 0;
    for (const auto& [type, count] : drawing.counts) {
        EXPECT_EQ(count.read, count.used + count.ignored) << type;
        read += count.read;
    }
    EXPECT_EQ(read, 8);
}

TEST(Dxf, FindsTheUnit) {
    const auto unit = [](const std::string& header) {
        return read(dxf_file(dxf_line("1", "A", 0, 0, 1, 0), dxf_section("HEADER", header))).unit;
    };
    EXPECT_EQ(unit("9\n$INSUNITS\n70\n4\n"), "mm");
    EXPECT_EQ(unit("9\n$INSUNITS\n70\n1\n9\n$MEASUREMENT\n70\n1\n"), "in");
    EXPECT_EQ(unit("9\n$INSUNITS\n70\n0\n9\n$MEASUREMENT\n70\n0\n"), "in");
    EXPECT_EQ(unit("9\n$MEASUREMENT\n70\n1\n"), "mm");
    EXPECT_EQ(unit("9\n$ACADVER\n1\nAC1015\n"), "");
}

TEST(Dxf, ReportsUnreadableEntitiesAndReadsOn) {
    const Drawing drawing = read(
        dxf_file(dxf_circle("1", "A", 3, 4, -1) + dxf_record("LINE", "2", "A", {{10, 0}, {20, 0}, {11, 1}}) +
                 "0\nARC\n5\n3\n8\nA\n10\n0\n20\n0\n40\none\n50\n0\n51\n90\n" +
                 dxf_record("LWPOLYLINE", "4", "A", {{90, 2}, {10, 0}, {10, 1}, {20, 1}}) + dxf_line("5", "A", 0, 0, 1, 1)));
    ASSERT_EQ(drawing.entities.size(), 1u);
    EXPECT_EQ(drawing.entities[0].name, "h5");
    ASSERT_EQ(drawing.problems.size(), 4u);
    EXPECT_TRUE(has(drawing.problems[0].what, "radius is negative"));
    EXPECT_EQ(drawing.problems[0].entity, "h1");
    EXPECT_EQ(drawing.problems[0].line, 6);
    expect_near(drawing.problems[0].at, {3, 4});
    EXPECT_TRUE(has(drawing.problems[1].what, "group 21 is missing"));
    EXPECT_TRUE(has(drawing.problems[2].what, "'one'"));
    EXPECT_TRUE(has(drawing.problems[3].what, "lack coordinates"));
}

TEST(Dxf, NamesEntitiesByLineWhereHandlesFail) {
    const Drawing drawing =
        read(dxf_file(dxf_line("", "A", 0, 0, 1, 0) + dxf_line("1f", "A", 0, 0, 1, 0) + dxf_line("1F", "A", 0, 0, 1, 0)));
    ASSERT_EQ(drawing.entities.size(), 3u);
    EXPECT_EQ(drawing.entities[0].name, "l6");
    EXPECT_EQ(drawing.entities[1].name, "h1F");
    EXPECT_EQ(drawing.entities[2].name, "l" + std::to_string(drawing.entities[2].line));
}

TEST(Dxf, GivesLayerNamesAsUtf8) {
    const std::string umlaut = "Tr\xC3\xA4ger";
    for (const char* name : {"Tr\xC3\xA4ger", "Tr\xE4ger", "Tr\\U+00E4ger"})
        EXPECT_EQ(read(dxf_file(dxf_line("1", name, 0, 0, 1, 0))).entities.at(0).layer, umlaut);
}

TEST(Dxf, SurvivesDamagedFiles) {
    const std::string good = read_text(pin_bracket);
    const TemporaryFolder folder;
    const auto try_to_read = [&](const std::string& text) {
        try {
            parts_by_layer(read_dxf(folder.write("damaged.dxf", text)), {});
            return true;
        } catch (const InputError&) { return false; }
    };
    ASSERT_TRUE(try_to_read(good));
    const std::size_t end = good.rfind("EOF");
    for (std::size_t n = 1; n < end; n += 211) EXPECT_FALSE(try_to_read(good.substr(0, n))) << n;
    std::mt19937 random(7);
    const std::string bytes = "0123456789-.,eE \n\rAZ\xFF";
    for (int i = 0; i < 120; ++i) {
        std::string damaged = good;
        for (int k = 0; k < 5; ++k) damaged[random() % damaged.size()] = bytes[random() % bytes.size()];
        try_to_read(damaged);  // must neither crash nor throw anything else
    }
}

}  // namespace
}  // namespace abut::geometry
