// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/dxf/dxf.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>

#include "geometry/brep/input_error.hpp"
#include "geometry/sketch/sketch.hpp"
#include "tests/geometry/dxf/dxf_text.hpp"
#include "tests/src/io/temporary_folder.hpp"

namespace abut::geometry::dxf_test {
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
    EXPECT_TRUE(has(refusal("AutoCAD Binary DXF\n\x1a").what, "damaged"));
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

TEST(Dxf, FindsTheUnit) {
    const auto unit = [](const std::string& header) {
        return read(dxf_file(dxf_line("1", "A", 0, 0, 1, 0), dxf_section("HEADER", header))).unit;
    };
    EXPECT_EQ(unit("9\n$INSUNITS\n70\n4\n"), "mm");
    EXPECT_EQ(unit("9\n$INSUNITS\n70\n1\n9\n$MEASUREMENT\n70\n1\n"), "in");
    EXPECT_EQ(unit("9\n$INSUNITS\n70\n0\n9\n$MEASUREMENT\n70\n0\n"), "");  // stated to have none
    EXPECT_EQ(unit("9\n$MEASUREMENT\n70\n0\n"), "in");
    EXPECT_EQ(unit("9\n$MEASUREMENT\n70\n1\n"), "mm");
    EXPECT_EQ(unit("9\n$ACADVER\n1\nAC1015\n"), "");
    EXPECT_EQ(unit("9\n$INSUNITS\n70\n18\n9\n$MEASUREMENT\n70\n1\n"), "");  // astronomical units have no name here
    for (int code = 1; code <= 24; ++code) {
        const std::string name = unit("9\n$INSUNITS\n70\n" + std::to_string(code) + "\n");
        EXPECT_EQ(name.empty(), code == 11 || (code >= 17 && code <= 20)) << code;
        EXPECT_EQ(name.empty(), unit_factor(name, "mm") == 0) << name;
    }
    EXPECT_EQ(unit_factor("yd", "in"), 36);
    EXPECT_EQ(unit_factor("mi", "ft"), 5280);
    EXPECT_EQ(unit_factor("dm", "mm"), 100);
    EXPECT_NEAR(unit_factor("ft_us", "m") * 3937, 1200, 1e-12 * 1200);
    EXPECT_EQ(unit_factor("parsec", "mm"), 0);
    EXPECT_EQ(unit_factor("mm", "parsec"), 0);
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

TEST(Dxf, ReadsEllipses) {
    const auto ellipse = [](std::initializer_list<std::pair<int, double>> numbers) {
        return read(dxf_file(dxf_record("ELLIPSE", "1", "A", numbers))).entities.at(0).curve;
    };
    const Curve quarter = ellipse({{10, 1}, {20, 2}, {11, 4}, {21, 0}, {40, 0.5}, {41, 0}, {42, pi / 2}});
    EXPECT_EQ(kind_name(quarter), "ellipse");
    expect_near(point(quarter, 0), {5, 2});
    expect_near(point(quarter, 0.5), Vec2(1, 2) + std::sqrt(0.5) * Vec2(4, 2));
    expect_near(point(quarter, 1), {1, 4});
    const Curve below =
        ellipse({{10, 1}, {20, 2}, {11, 4}, {21, 0}, {40, 0.5}, {41, 0}, {42, pi / 2}, {210, 0}, {220, 0}, {230, -1}});
    expect_near(point(below, 0), {5, 2});  // in the drawing's coordinates; only the second axis points the other way
    expect_near(point(below, 1), {1, 0});
    const Curve slender = ellipse({{10, 0}, {20, 0}, {11, 0}, {21, 1}, {40, 3}, {41, pi / 2}, {42, pi}});  // ratio beyond 1
    expect_near(point(slender, 0), {-3, 0});
    expect_near(point(slender, 1), {0, -1});
    for (const double end : {2 * pi, 6.283185, 6.2831854, 0.0}) {  // a full turn as exporters write it
        const Curve full = ellipse({{10, 0}, {20, 0}, {11, 2}, {21, 0}, {40, 0.5}, {41, 0}, {42, end}});
        EXPECT_EQ(std::get<EllipticArc>(full).sweep, 2 * pi) << end;
    }
    EXPECT_NEAR(std::get<EllipticArc>(ellipse({{10, 0}, {20, 0}, {11, 2}, {21, 0}, {40, 0.5}, {41, 5}, {42, 1}})).sweep,
                2 * pi - 4, 1e-12);
    const Curve round = ellipse({{10, 3}, {20, 0}, {11, 0}, {21, 2}, {40, 1}, {41, 0}, {42, pi}});
    ASSERT_TRUE(std::holds_alternative<Arc>(round));
    expect_near(point(round, 0), {3, 2});
    expect_near(point(round, 0.5), {1, 0});
    EXPECT_EQ(read(dxf_file(dxf_record("ELLIPSE", "1", "A", {{10, 0}, {20, 0}, {11, 2}, {21, 0}, {40, 0}}))).problems.size(),
              1u);
}

TEST(Dxf, ClosesPolylinesOnce) {
    const auto n_pieces = [](std::initializer_list<std::pair<int, double>> numbers) {
        return read(dxf_file(dxf_record("LWPOLYLINE", "1", "A", numbers))).entities.size();
    };
    EXPECT_EQ(n_pieces({{70, 0}, {10, 0}, {20, 0}, {10, 1}, {20, 0}, {10, 0}, {20, 1}}), 2u);
    EXPECT_EQ(n_pieces({{70, 1}, {10, 0}, {20, 0}, {10, 1}, {20, 0}, {10, 0}, {20, 1}}), 3u);
    EXPECT_EQ(n_pieces({{70, 1}, {10, 0}, {20, 0}, {10, 1}, {20, 0}, {10, 0}, {20, 1}, {10, 0}, {20, 0}}), 3u);
    EXPECT_EQ(n_pieces({{70, 1}, {10, 0}, {20, 0}, {42, 1}, {10, 1}, {20, 0}, {42, 1}}), 2u);
    EXPECT_EQ(n_pieces({{70, 0}, {10, 5}, {20, 5}}), 1u);  // a point: a segment of no length, for the sketch to report
}

TEST(Dxf, KeepsTheDigitsOfLargeCoordinates) {
    const Drawing drawing = read(
        "0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n1234567890.1234567\n20\n-1e11\n11\n+1.5E6\n21\n1000000.000001\n"
        "0\nENDSEC\n0\nEOF\n");
    EXPECT_EQ(point(drawing.entities.at(0).curve, 0), Vec2(1234567890.1234567, -1e11));
    EXPECT_EQ(point(drawing.entities.at(0).curve, 1), Vec2(1.5e6, 1000000.000001));
}

TEST(Dxf, RefusesAbsurdNumbers) {
    for (const char* x : {"1e13", "1e400", "nan", "inf", "-1e308", "0x10", "1.0.0", "--1", "1e", ""}) {
        const Drawing drawing = read(std::string("0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n90\n2000000000\n10\n") + x +
                                     "\n20\n0\n40\n1\n0\nENDSEC\n0\nEOF\n");
        EXPECT_TRUE(drawing.entities.empty()) << x;
        EXPECT_EQ(drawing.problems.size(), 1u) << x;
    }
}

/// Damages the text at n random places and reads it. Nothing but InputError may be thrown.
void read_damaged(const std::string& good, int n, std::mt19937& random) {
    static const std::string bytes = "0123456789-.,eE \n\rAZ\xFF";
    std::string damaged = good;
    for (int k = 0; k < n; ++k) damaged[random() % damaged.size()] = bytes[random() % bytes.size()];
    try {
        for (const SketchEntity& entity : read_dxf_bytes("damaged.dxf", damaged).entities) EXPECT_TRUE(is_finite(entity.curve));
    } catch (const InputError&) {}
}

TEST(Dxf, SurvivesDamagedFiles) {
    const std::string good = read_text(pin_bracket);
    const std::size_t end = good.rfind("EOF");
    for (std::size_t n = 1; n < end; n += 211) EXPECT_THROW(read_dxf_bytes("cut.dxf", good.substr(0, n)), InputError) << n;
    std::mt19937 random(7);
    for (int i = 0; i < 120; ++i) read_damaged(good, 5, random);
}

TEST(LongDxf, SurvivesDamagedFiles) {
    std::mt19937 random(8);
    const std::string good = dxf_of_every_kind();
    ASSERT_TRUE(read_dxf_bytes("good.dxf", good).problems.empty());
    for (int i = 0; i < 10'000; ++i) read_damaged(good, 1 + i % 6, random);
}

}  // namespace
}  // namespace abut::geometry::dxf_test
