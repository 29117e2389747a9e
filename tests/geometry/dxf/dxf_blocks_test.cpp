// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/dxf/dxf_blocks.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "tests/geometry/dxf/dxf_text.hpp"

namespace abut::geometry::dxf_blocks_test {
namespace {

constexpr double pi = std::numbers::pi;

std::string file_of(const std::string& blocks, const std::string& entities, const std::string& before = "") {
    return before + dxf_section("BLOCKS", blocks) + dxf_section("ENTITIES", entities) + "0\nEOF\n";
}

void expect_near(const Vec2& a, const Vec2& b, double tolerance = 1e-12) {
    EXPECT_LE((a - b).norm(), tolerance) << a.transpose() << " | " << b.transpose();
}

/// The one problem that the drawing has.
std::string problem_of(const Drawing& drawing) {
    EXPECT_EQ(drawing.problems.size(), 1u);
    return drawing.problems.empty() ? "" : drawing.problems[0].what;
}

bool has(const std::string& text, const std::string& piece) {
    return text.find(piece) != std::string::npos;
}

// ---- places ----

struct RandomInsert {
    double x, y, sx, sy, degrees, base_x, base_y, normal;

    std::string text(const std::string& block) const {
        return dxf_insert("", "0", block, x, y,
                          {{41, sx}, {42, sy}, {43, 1}, {50, degrees}, {210, 0}, {220, 0}, {230, normal}});
    }
    /// What the DXF reference says of an INSERT, factor by factor.
    Eigen::Affine2d map() const {
        return Eigen::Affine2d(Eigen::Scaling(normal, 1.0)) * Eigen::Translation2d(x, y) *
               Eigen::Rotation2Dd(degrees * pi / 180) * Eigen::Scaling(sx, sy) * Eigen::Translation2d(-base_x, -base_y);
    }
};

RandomInsert random_insert(std::mt19937& random) {
    const auto number = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    const auto sign = [&] { return random() % 2 ? 1.0 : -1.0; };
    const double scale = number(0.3, 3), other = random() % 2 ? scale : number(0.3, 3);
    const double degrees = random() % 3 ? number(-400, 400) : 90.0 * static_cast<double>(random() % 5);
    return {number(-50, 50), number(-50, 50), sign() * scale,  sign() * other,
            degrees,         number(-50, 50), number(-50, 50), random() % 3 ? 1.0 : -1.0};
}

std::string kinds_of_entities() {
    const std::string all = dxf_of_every_kind();
    const std::size_t begin = all.find("0\nSECTION\n2\nENTITIES\n") + 21, end = all.find("0\nINSERT", begin);
    return all.substr(begin, end - begin) +
           dxf_record("ARC", "", "A", {{10, 1}, {20, 2}, {40, 3}, {50, 20}, {51, 310}, {210, 0}, {220, 0}, {230, -1}});
}

/// Points of the block's curves, mapped by the test's own matrices, are those of the curves that are read.
void check_random_placement(std::mt19937& random) {
    const std::string kinds = kinds_of_entities();
    const Drawing plain = read_drawing(dxf_file(kinds));
    const RandomInsert inner = random_insert(random), outer = random_insert(random);
    const Drawing drawing = read_drawing(file_of(
        dxf_block("IN", inner.base_x, inner.base_y, kinds) + dxf_block("OUT", outer.base_x, outer.base_y, inner.text("IN")),
        outer.text("OUT")));
    ASSERT_TRUE(drawing.problems.empty()) << drawing.problems[0].what;
    ASSERT_EQ(drawing.entities.size(), plain.entities.size());
    const Eigen::Affine2d map = outer.map() * inner.map();
    for (std::size_t i = 0; i < plain.entities.size(); ++i)
        for (const double t : {0.0, 0.17, 0.5, 0.81, 1.0})
            expect_near(point(drawing.entities[i].curve, t), map * point(plain.entities[i].curve, t), 1e-10);
}

TEST(DxfBlocks, StandWhereTheirInsertsPutThem) {
    std::mt19937 random(11);
    for (int i = 0; i < 60; ++i) check_random_placement(random);
}

TEST(LongDxfBlocks, StandWhereTheirInsertsPutThem) {
    std::mt19937 random(12);
    for (int i = 0; i < 10'000 && !::testing::Test::HasFailure(); ++i) check_random_placement(random);
}

TEST(DxfBlocks, CirclesStayCirclesWhereTheyCan) {
    const auto kind = [](double sx, double sy) {
        const Drawing drawing = read_drawing(file_of(dxf_block("B", 0, 0, dxf_circle("", "A", 1, 2, 3)),
                                                     dxf_insert("", "A", "B", 5, 5, {{41, sx}, {42, sy}, {50, 33}})));
        return kind_name(drawing.entities.at(0).curve);
    };
    EXPECT_EQ(kind(1, 1), "arc");
    EXPECT_EQ(kind(-2.54, 2.54), "arc");
    EXPECT_EQ(kind(-0.1, -0.1), "arc");
    EXPECT_EQ(kind(1, 1 + 1e-9), "ellipse");
    EXPECT_EQ(kind(1, -3), "ellipse");
    const Drawing back = read_drawing(file_of(  // squeezed, and stretched back by the block around it
        dxf_block("B", 0, 0, dxf_circle("", "A", 1, 2, 3)) + dxf_block("C", 0, 0, dxf_insert("", "0", "B", 0, 0, {{42, 0.3}})),
        dxf_insert("", "A", "C", 0, 0, {{42, 1 / 0.3}})));
    EXPECT_EQ(kind_name(back.entities.at(0).curve), "arc");
    EXPECT_NEAR(std::get<Arc>(back.entities[0].curve).radius, 3, 1e-14);
}

TEST(DxfBlocks, KeepDigitsFarFromTheOrigin) {
    const double far = 123456789;
    const Drawing drawing = read_drawing(file_of(dxf_block("B", far, far, dxf_line("", "A", far, far, far + 0.5, far + 0.25)),
                                                 dxf_insert("", "A", "B", 0.1, 0.2, {{41, 2}, {42, 2}, {50, 90}})));
    EXPECT_EQ(point(drawing.entities.at(0).curve, 0), Vec2(0.1, 0.2));
    EXPECT_EQ(point(drawing.entities.at(0).curve, 1), Vec2(0.1 - 0.5, 0.2 + 1));
}

TEST(DxfBlocks, ArraysTurnWithTheInsertAndAreNotScaled) {
    const Drawing drawing = read_drawing(
        file_of(dxf_block("B", 0, 0, dxf_circle("", "A", 0, 0, 1)),
                dxf_insert("", "A", "B", 100, 0, {{41, 3}, {42, 3}, {50, 90}, {70, 3}, {71, 2}, {44, 10}, {45, 20}})));
    ASSERT_EQ(drawing.entities.size(), 6u);
    std::set<std::pair<double, double>> places, wanted;
    for (const SketchEntity& entity : drawing.entities) {
        const Vec2 center = std::get<Arc>(entity.curve).center;
        places.insert({center.x(), center.y()});
    }
    for (const double row : {0.0, 1.0})
        for (const double column : {0.0, 1.0, 2.0}) wanted.insert({100 - 20 * row, 10 * column});
    EXPECT_EQ(places, wanted);
    EXPECT_EQ(drawing.entities[0].instance, "B#0");
    EXPECT_EQ(drawing.entities[5].instance, "B#5");
}

// ---- looks and names ----

TEST(DxfBlocks, NameBlocksAndInstances) {
    const Drawing drawing = read_drawing(
        file_of(dxf_block("Pin", 0, 0, dxf_circle("A1", "0", 0, 0, 1)) +
                    dxf_block("CLAMP", 0, 0, dxf_line("A2", "0", 0, 0, 1, 0) + dxf_insert("", "0", "PIN", 0, 0)) +
                    dxf_block("UNUSED", 0, 0, dxf_line("A3", "0", 0, 0, 1, 0)),
                dxf_insert("B1", "X", "clamp", 0, 0) + dxf_insert("B2", "X", "Pin", 9, 0) + dxf_line("B3", "X", 0, 0, 1, 1)));
    ASSERT_EQ(drawing.entities.size(), 4u);
    const auto told = [&](std::size_t i) {
        const SketchEntity& e = drawing.entities[i];
        return e.name + " " + e.block + " " + e.instance;
    };
    EXPECT_EQ(told(0), "hA2 CLAMP ");
    EXPECT_EQ(told(1), "hA1 CLAMP/Pin Pin#0");
    EXPECT_EQ(told(2), "hA1 Pin Pin#1");
    EXPECT_EQ(told(3), "hB3  ");
    EXPECT_EQ(drawing.counts.at("INSERT").used, 2);  // counts are of the model space itself
    EXPECT_EQ(drawing.counts.count("CIRCLE"), 0u);
}

TEST(DxfBlocks, InheritLayerAndColour) {
    const std::string layers =
        dxf_section("TABLES", "0\nLAYER\n2\n0\n62\n7\n0\nLAYER\n2\nRED\n62\n1\n0\nLAYER\n2\nBLUE\n62\n5\n");
    const std::string content = dxf_circle("1", "0", 0, 0, 1) + dxf_circle("2", "BLUE", 0, 0, 2) +
                                dxf_circle("3", "0", 0, 0, 3) + "62\n0\n" + dxf_circle("4", "BLUE", 0, 0, 4) + "62\n3\n";
    const Drawing drawing =
        read_drawing(file_of(dxf_block("B", 0, 0, content) + dxf_block("C", 0, 0, dxf_insert("5", "0", "B", 0, 0) + "62\n0\n"),
                             dxf_insert("6", "RED", "C", 0, 0) + "62\n4\n" + dxf_insert("7", "BLUE", "B", 0, 0), layers));
    ASSERT_EQ(drawing.entities.size(), 8u);
    const auto look = [&](std::size_t i) { return drawing.entities[i].layer + std::to_string(drawing.entities[i].color); };
    EXPECT_EQ(look(0), "RED1");  // layer 0: the insert's, through both blocks; colour by that layer
    EXPECT_EQ(look(1), "BLUE5");
    EXPECT_EQ(look(2), "RED4");  // by block, which is by block again: the outer insert's
    EXPECT_EQ(look(3), "BLUE3");
    EXPECT_EQ(look(4), "BLUE5");
    EXPECT_EQ(look(6), "BLUE5");
}

TEST(DxfBlocks, ListWhatIsIgnoredForEachInstance) {
    const std::string layers = dxf_section("TABLES", "0\nLAYER\n2\nOFF\n62\n-7\n0\nLAYER\n2\nICE\n70\n1\n");
    const std::string content = dxf_circle("1", "0", 0, 0, 1) + dxf_record("TEXT", "2", "0", {}) +
                                dxf_line("3", "OFF", 0, 0, 1, 1) + dxf_line("4", "0", 0, 0, 1, 1) + "6\nBYBLOCK\n" +
                                dxf_record("ATTDEF", "5", "0", {});
    const Drawing drawing = read_drawing(file_of(dxf_block("B", 0, 0, content),
                                                 dxf_insert("6", "A", "B", 0, 0) + "6\nCENTER\n" +
                                                     "0\nATTRIB\n8\nA\n0\nSEQEND\n8\nA\n" + dxf_insert("7", "A", "B", 9, 0) +
                                                     dxf_insert("8", "ICE", "B", 0, 0) + dxf_insert("9", "OFF", "B", 0, 0),
                                                 layers));
    EXPECT_EQ(drawing.entities.size(), 3u);  // two circles, and the line where its line type by block is none of construction
    std::set<std::string> told;
    for (const Ignored& i : drawing.ignored) told.insert(std::to_string(i.count) + " " + i.what + ": " + i.why);
    EXPECT_EQ(told, (std::set<std::string>{"2 TEXT in block B: annotation", "2 LINE on layer OFF in block B: layer is off",
                                           "1 LINE in block B: line type CENTER", "2 ATTDEF in block B: annotation",
                                           "1 ATTRIB: annotation", "1 INSERT on layer ICE: layer is frozen",
                                           "1 INSERT on layer OFF: layer is off"}));
    EXPECT_EQ(drawing.counts.at("INSERT").read, 4);
    EXPECT_EQ(drawing.counts.at("INSERT").used, 2);
    EXPECT_EQ(drawing.counts.at("INSERT").ignored, 2);
}

// ---- faults ----

TEST(DxfBlocks, FaultsAreProblemsWithAPlace) {
    const std::string block = dxf_block("B", 0, 0, dxf_circle("1", "0", 0, 0, 1));
    const auto problem = [&](const std::string& blocks, const std::string& insert) {
        return problem_of(read_drawing(file_of(blocks, insert)));
    };
    EXPECT_TRUE(has(problem(block, dxf_insert("2", "A", "NONE", 0, 0)), "'NONE'"));
    EXPECT_TRUE(has(problem(block, dxf_insert("2", "A", "B", 0, 0, {{41, 0}})), "scale is zero"));
    EXPECT_TRUE(has(problem(block, dxf_insert("2", "A", "B", 0, 0, {{41, 1e-100}})), "no sensible size"));
    EXPECT_TRUE(has(problem(block, dxf_insert("2", "A", "B", 0, 0, {{41, 1e300}})), "no sensible size"));
    EXPECT_TRUE(has(problem(block, dxf_record("INSERT", "2", "A", {{20, 0}}) + "2\nB\n"), "group 10 is missing"));
    EXPECT_TRUE(has(problem(dxf_block("B", 0, 0, dxf_insert("1", "0", "B", 1, 1)), dxf_insert("2", "A", "B", 0, 0)),
                    "contains itself"));
    EXPECT_TRUE(has(
        problem(dxf_block("B", 0, 0, dxf_insert("1", "0", "C", 1, 1)) + dxf_block("C", 0, 0, dxf_insert("3", "0", "b", 1, 1)),
                dxf_insert("2", "A", "B", 0, 0)),
        "contains itself"));
    const Drawing damaged = read_drawing(file_of(dxf_block("B", 0, 0, dxf_circle("1", "0", 3, 4, -1)),
                                                 dxf_insert("2", "A", "B", 10, 20) + dxf_insert("3", "A", "B", 0, 0)));
    EXPECT_TRUE(has(problem_of(damaged), "radius is negative"));  // once, however often the block is inserted
    expect_near(damaged.problems[0].at, {13, 24});
    EXPECT_EQ(damaged.problems[0].entity, "h1");
}

TEST(DxfBlocks, ExternalReferencesAreListed) {
    const Drawing drawing =
        read_drawing(file_of(dxf_block("X", 0, 0, "", 4), dxf_line("1", "A", 0, 0, 1, 1) + dxf_insert("2", "A", "X", 0, 0)));
    EXPECT_TRUE(drawing.problems.empty());
    ASSERT_EQ(drawing.ignored.size(), 1u);
    EXPECT_TRUE(has(drawing.ignored[0].why, "in another file"));
}

/// n levels of blocks, each inserting the one below it `width` times.
std::string tower(int n, int width, const std::string& foundation) {
    std::string blocks = dxf_block("L0", 0, 0, foundation);
    for (int level = 1; level <= n; ++level) {
        std::string inserts;
        for (int k = 0; k < width; ++k) inserts += dxf_insert("", "0", "L" + std::to_string(level - 1), k, level);
        blocks += dxf_block("L" + std::to_string(level), 0, 0, inserts);
    }
    return file_of(blocks, dxf_insert("", "A", "L" + std::to_string(n), 0, 0));
}

TEST(DxfBlocks, DoNotBlowUp) {
    EXPECT_EQ(read_drawing(tower(3, 10, dxf_line("", "0", 0, 0, 1, 0))).entities.size(), 1000u);
    EXPECT_TRUE(read_drawing(tower(dxf::deepest_nesting - 1, 1, dxf_line("", "0", 0, 0, 1, 0))).problems.empty());
    EXPECT_TRUE(has(problem_of(read_drawing(tower(dxf::deepest_nesting, 1, dxf_line("", "0", 0, 0, 1, 0)))), "nested deeper"));
    // Nothing is drawn, 1e40 times: that this ends at all is the test.
    EXPECT_TRUE(has(problem_of(read_drawing(tower(40, 10, ""))), "more than"));
}

TEST(LongDxfBlocks, DrawingsBeyondTheLimitAreRefused) {
    const auto array = [](int columns, int rows) {
        const double x = columns, y = rows;
        return read_drawing(file_of(dxf_block("B", 0, 0, dxf_line("", "0", 0, 0, 1, 0)),
                                    dxf_insert("", "A", "B", 0, 0, {{70, x}, {71, y}, {44, 2}, {45, 2}})));
    };
    const Drawing large = array(600, 500);
    EXPECT_EQ(large.entities.size(), 300'000u);
    EXPECT_TRUE(large.problems.empty());
    EXPECT_TRUE(has(problem_of(array(32767, 32767)), "more than"));
    EXPECT_LE(array(32767, 32767).entities.size(), dxf::most_entities);
}

}  // namespace
}  // namespace abut::geometry::dxf_blocks_test
