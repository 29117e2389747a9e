// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/dxf/dxf.hpp"
#include "tests/geometry/dxf/dxf_text.hpp"
#include "tests/geometry/sketch/drawings.hpp"
#include "tests/src/io/temporary_folder.hpp"

namespace abut::geometry::sketch_test {
namespace {

constexpr double pi = std::numbers::pi;
/// Base, web, half disc and two fillets, less the bores, from the drawing's dimensions.
const double bracket_area = 120 * 12 + 40 * 38 + 200 * pi + 2 * (36 - 9 * pi) - pi * (9 + 9 + 10.05 * 10.05);

Drawing pin_bracket() {
    return read_dxf(std::string(ABUT_SOURCE_DIR) + "/data/sketches/pin_bracket_r14.dxf");
}

SketchParts parts_by_layer(const Drawing& drawing, double tolerance = 0) {
    return parts_of(drawing, {.tolerance = tolerance, .parts_by = PartsBy::layer});
}

SketchParts parts_of(const std::string& entities, double tolerance = 0) {
    const TemporaryFolder folder;
    return parts_by_layer(read_dxf(folder.write("test.dxf", dxf_file(entities))), tolerance);
}

bool has(const std::string& text, const std::string& piece) {
    return text.find(piece) != std::string::npos;
}

TEST(Sketch, FindsThePartsOfAnAssembly) {
    const SketchParts sketch = parts_by_layer(pin_bracket());
    ASSERT_EQ(sketch.parts.size(), 3u);
    EXPECT_TRUE(sketch.repairs.empty());
    EXPECT_TRUE(sketch.problems.empty());
    EXPECT_EQ(sketch.parts[0].name, "bracket");
    EXPECT_EQ(sketch.parts[1].name, "pin");
    EXPECT_EQ(sketch.parts[2].name, "base");
    EXPECT_EQ(sketch.layers, (std::vector<std::string>{"bracket", "pin", "base"}));
    EXPECT_NEAR(area(sketch.parts[0]), bracket_area, 1e-9);
    EXPECT_NEAR(area(sketch.parts[1]), 100 * pi, 1e-9);
    EXPECT_NEAR(area(sketch.parts[2]), 160 * 15, 1e-9);
    EXPECT_EQ(count_holes(sketch.parts[0]), 3);
    for (const Part& part : sketch.parts) expect_sound(part);
}

TEST(Sketch, NamesEdgesAfterEntitiesAndKnowsTheirDirection) {
    const Drawing drawing = pin_bracket();
    for (const Part& part : parts_by_layer(drawing).parts)
        for (const Edge& edge : part.edges) {
            const auto entity = std::find_if(drawing.entities.begin(), drawing.entities.end(),
                                             [&](const auto& e) { return e.name == edge.name; });
            ASSERT_NE(entity, drawing.entities.end());
            EXPECT_EQ(edge.source, edge.name);
            EXPECT_EQ(edge.source_begin, 0);
            const Curve own = edge.along_source ? edge.curve : reversed(edge.curve);
            for (double t : {0.0, 0.25, 1.0}) EXPECT_LE((point(own, t) - point(entity->curve, t)).norm(), 1e-12);
        }
}

TEST(Sketch, KeepsACircleAsOneArcFromAngleZero) {
    const SketchParts sketch = parts_of(dxf_circle("1", "A", 2, 3, 4) + dxf_circle("2", "A", 2, 3, 1));
    ASSERT_EQ(sketch.parts.size(), 1u);
    ASSERT_EQ(sketch.parts[0].edges.size(), 2u);
    const Arc outer = std::get<Arc>(sketch.parts[0].edges[0].curve), hole = std::get<Arc>(sketch.parts[0].edges[1].curve);
    EXPECT_EQ(outer.start, 0);
    EXPECT_EQ(outer.sweep, 2 * pi);
    EXPECT_EQ(hole.sweep, -2 * pi);
    EXPECT_FALSE(sketch.parts[0].edges[1].along_source);
    expect_sound(sketch.parts[0]);
}

TEST(Sketch, DoesNotDependOnOrderAndDirectionOfEntities) {
    const Drawing drawing = pin_bracket();
    std::mt19937 random(3);
    for (int trial = 0; trial < 20; ++trial) {
        Drawing shuffled = drawing;
        std::shuffle(shuffled.entities.begin(), shuffled.entities.end(), random);
        for (SketchEntity& entity : shuffled.entities)
            if (random() % 2 == 0) entity.curve = reversed(entity.curve);
        const SketchParts sketch = parts_by_layer(shuffled);
        ASSERT_EQ(sketch.parts.size(), 3u);
        double sum = 0;
        for (const Part& part : sketch.parts) {
            expect_sound(part);
            sum += area(part);
        }
        EXPECT_NEAR(sum, bracket_area + 100 * pi + 2400, 1e-9);
    }
}

TEST(Sketch, RestoresCornersAndReportsTheGap) {
    const double gap = 1e-4;  // the default tolerance is 2e-5 of the diagonal, 2.8e-4
    const SketchParts sketch = parts_of(dxf_line("1", "A", 0, 0, 10 - gap, 0) + dxf_line("2", "A", 10, 0, 10, 10) +
                                        dxf_line("3", "A", 10, 10, 0, 10) + dxf_line("4", "A", 0, 10, 0, 0));
    ASSERT_EQ(sketch.parts.size(), 1u);
    EXPECT_EQ(area(sketch.parts[0]), 100);
    ASSERT_EQ(sketch.repairs.size(), 1u);
    EXPECT_EQ(sketch.repairs[0].what, "gap closed between h1 and h2");
    EXPECT_NEAR(sketch.repairs[0].size, gap, 1e-12);
    EXPECT_LE((sketch.repairs[0].at - Vec2(10, 0)).norm(), 1e-12);
}

TEST(Sketch, LeavesArcsWhereLinesMissThem) {
    // A half disc whose diameter misses the arc's ends a little, along and across.
    const SketchParts sketch = parts_of(dxf_arc("1", "A", 0, 0, 10, 0, 180) + dxf_line("2", "A", -10.0001, 0, 10, 0.0001));
    ASSERT_EQ(sketch.parts.size(), 1u);
    EXPECT_EQ(sketch.repairs.size(), 2u);
    EXPECT_NEAR(area(sketch.parts[0]), 50 * pi, 1e-9);
    expect_sound(sketch.parts[0]);
}

TEST(Sketch, MovesArcsThatMissEachOther) {
    const double gap = 1e-4;
    // two half circles, and two pieces of which one is well above a half turn
    for (const std::string& text : {dxf_arc("1", "A", 0, 0, 10, 0, 180) + dxf_arc("2", "A", 0, -gap, 10, 180, 360),
                                    dxf_arc("1", "A", 0, 0, 10, 40, 320) + dxf_arc("2", "A", gap, 0, 10, 320, 40)}) {
        const SketchParts sketch = parts_of(text);
        ASSERT_EQ(sketch.parts.size(), 1u);
        ASSERT_EQ(sketch.repairs.size(), 2u);
        expect_sound(sketch.parts[0]);
        EXPECT_NEAR(area(sketch.parts[0]), 100 * pi, 20 * pi * gap);
        for (const Edge& edge : sketch.parts[0].edges) EXPECT_NEAR(std::get<Arc>(edge.curve).radius, 10, 2 * gap);
    }
}

TEST(Sketch, ReportsGapsThatAreTooWide) {
    const std::string open = dxf_line("1", "A", 0, 0, 10, 0) + dxf_line("2", "A", 10, 0.02, 10, 10) +
                             dxf_line("3", "A", 10, 10, 0, 10) + dxf_line("4", "A", 0, 10, 0, 0);
    const SketchParts sketch = parts_of(open);
    EXPECT_TRUE(sketch.parts.empty());
    ASSERT_EQ(sketch.problems.size(), 1u);
    const SketchProblem& problem = sketch.problems[0];
    EXPECT_TRUE(has(problem.what, "layer A")) << problem.what;
    EXPECT_TRUE(has(problem.what, "0.02 apart")) << problem.what;
    EXPECT_EQ(problem.entity, "h1, h2");
    EXPECT_EQ(problem.line, 6);
    EXPECT_LE((problem.at - Vec2(10, 0.01)).norm(), 1e-12);
    EXPECT_TRUE(has(problem.hint, "larger tolerance"));

    const SketchParts closed = parts_of(open, 0.05);
    EXPECT_TRUE(closed.problems.empty());
    EXPECT_EQ(closed.tolerance, 0.05);
    ASSERT_EQ(closed.parts.size(), 1u);
    EXPECT_EQ(area(closed.parts[0]), 100);
}

TEST(Sketch, TellsOfManyOpenEndsBriefly) {
    std::string strokes;
    for (int i = 0; i < 100; ++i) strokes += dxf_line(std::to_string(i + 10), "A", i, 0, i, 10);
    const SketchParts sketch = parts_of(strokes);
    ASSERT_EQ(sketch.problems.size(), 21u);
    EXPECT_TRUE(has(sketch.problems.back().what, "more gaps of open outlines")) << sketch.problems.back().what;
}

TEST(Sketch, SetsAsideWhatBranchesOff) {
    const SketchParts sketch =
        parts_of(dxf_rectangle("A", "P", 0, 0, 10, 10) + dxf_line("B", "P", 10, 10, 20, 20) + dxf_circle("C", "Q", 0, 0, 1));
    ASSERT_EQ(sketch.parts.size(), 2u);
    EXPECT_TRUE(sketch.problems.empty());
    ASSERT_EQ(sketch.warnings.size(), 1u);
    EXPECT_EQ(sketch.warnings[0].entity, "hB");
    EXPECT_TRUE(has(sketch.warnings[0].what, "LINE on layer P bounds nothing (ending on an outline"))
        << sketch.warnings[0].what;
    EXPECT_LE((sketch.warnings[0].at - Vec2(15, 15)).norm(), 1e-12);
}

TEST(Sketch, RemovesWhatIsDrawnTwice) {
    const std::string square = dxf_rectangle("A", "P", 0, 0, 10, 10);
    const std::string again = dxf_line("B", "P", 10, 0, 0, 0) + dxf_circle("D", "P", 5, 5, 2);  // one reversed
    const std::string pieces =
        dxf_line("E", "P", 10, 2, 10, 7) + dxf_line("F", "P", 10, 10, 10, 9);  // parts of a side, one to its end
    const SketchParts sketch = parts_of(square + dxf_circle("C", "P", 5, 5, 2) + again + pieces);
    EXPECT_TRUE(sketch.problems.empty());
    ASSERT_EQ(sketch.parts.size(), 1u);
    EXPECT_NEAR(area(sketch.parts[0]), 100 - 4 * pi, 1e-9);
    ASSERT_EQ(sketch.repairs.size(), 4u);
    EXPECT_EQ(sketch.repairs[0].what, "LINE hB removed: it lies on hA0");
    EXPECT_EQ(sketch.repairs[0].size, 10);
}

TEST(Sketch, RemovesEntitiesWithoutLength) {
    const SketchParts sketch =
        parts_of(dxf_rectangle("A", "P", 0, 0, 10, 10) + dxf_line("B", "P", 10, 10, 10, 10) + dxf_circle("C", "P", 3, 3, 0));
    EXPECT_EQ(sketch.parts.size(), 1u);
    EXPECT_TRUE(sketch.problems.empty());
    ASSERT_EQ(sketch.repairs.size(), 2u);
    EXPECT_EQ(sketch.repairs[0].what, "LINE hB without length removed");
}

TEST(Sketch, NestsOutlinesOfOneLayer) {
    // plate with a bore, a pin in the bore, which is bored too, and another plate beside
    const SketchParts sketch =
        parts_of(dxf_circle("1", "0", 0, 0, 3) + dxf_rectangle("A", "0", -20, -20, 20, 20) + dxf_circle("2", "0", 0, 0, 10) +
                 dxf_circle("3", "0", 0, 0, 9) + dxf_rectangle("B", "0", 30, -20, 50, 20));
    ASSERT_EQ(sketch.parts.size(), 3u);
    EXPECT_EQ(sketch.parts[0].name, "0#0");
    EXPECT_EQ(sketch.parts[2].name, "0#2");
    EXPECT_NEAR(area(sketch.parts[0]), 1600 - 100 * pi, 1e-9);
    EXPECT_NEAR(area(sketch.parts[1]), 72 * pi, 1e-9);
    EXPECT_NEAR(area(sketch.parts[2]), 800, 1e-9);
    for (const Part& part : sketch.parts) expect_sound(part);
}

TEST(Sketch, NestsWhereRaysPassThroughVertices) {
    // Corner lugs joined by a large circle. The bores' centres are as high as the joints, whose angles are rounded as written
    // by CAD.
    std::string text = dxf_circle("1", "P", 0, 0, 18);
    for (int sx : {-1, 1})
        for (int sy : {-1, 1})
            text += dxf_circle("2" + std::to_string(sx + 1) + std::to_string(sy + 1), "P", 16 * sx, 16 * sy, 3);
    text += dxf_arc("31", "P", 16, 16, 4, 270, 180) + dxf_arc("32", "P", 0, 0, 20, 53.13010235415597, 126.86989764584403) +
            dxf_arc("33", "P", -16, 16, 4, 360, 270) + dxf_arc("34", "P", 0, 0, 20, 323.130102354156, 36.869897645844006) +
            dxf_arc("35", "P", 16, -16, 4, 180, 90.00000000000006) +
            dxf_arc("36", "P", 0, 0, 20, 233.13010235415598, 306.869897645844) +
            dxf_arc("37", "P", 0, 0, 20, 143.130102354156, 216.869897645844) + dxf_arc("38", "P", -16, -16, 4, 90, 0);
    const SketchParts sketch = parts_of(text);
    ASSERT_EQ(sketch.parts.size(), 1u);
    EXPECT_EQ(count_holes(sketch.parts[0]), 5);
}

TEST(Sketch, LetsPartsOfOneLayerTouch) {
    // a short side on a long one, and a pin that rests in its bore
    const SketchParts sketch = parts_of(dxf_rectangle("A", "0", 0, 0, 40, 10) + dxf_rectangle("B", "0", 10, 10, 30, 40) +
                                        dxf_circle("C", "0", 20, 25, 6) + dxf_circle("D", "0", 20, 24.5, 5.5));
    EXPECT_TRUE(sketch.problems.empty());
    ASSERT_EQ(sketch.parts.size(), 3u);
    EXPECT_EQ(count_holes(sketch.parts[1]), 1);
}

TEST(Sketch, ReportsOutlinesThatCross) {
    const SketchParts two =
        parts_of(dxf_rectangle("A", "0", 0, 0, 10, 10) + dxf_rectangle("B", "0", 8, 3, 12, 7) + dxf_circle("C", "0", 50, 5, 2));
    EXPECT_EQ(two.parts.size(), 1u);
    ASSERT_EQ(two.problems.size(), 1u);
    EXPECT_TRUE(has(two.problems[0].what, "two outlines on layer 0 cross")) << two.problems[0].what;
    EXPECT_EQ(two.problems[0].entity, "hA1, hB0");
    EXPECT_LE((two.problems[0].at - Vec2(10, 3)).norm(), 1e-9);

    const SketchParts bow = parts_of(dxf_line("1", "0", 0, 0, 10, 10) + dxf_line("2", "0", 10, 10, 10, 0) +
                                     dxf_line("3", "0", 10, 0, 0, 10) + dxf_line("4", "0", 0, 10, 0, 0));
    EXPECT_TRUE(bow.parts.empty());
    ASSERT_EQ(bow.problems.size(), 1u);
    EXPECT_TRUE(has(bow.problems[0].what, "crosses or touches itself"));
    EXPECT_LE((bow.problems[0].at - Vec2(5, 5)).norm(), 1e-9);
}

TEST(Sketch, KeepsEdgesShorterThanTheTolerance) {
    // A chamfer of 1e-3 where the tolerance asked for is 0.05: it must not collapse.
    const double c = 1e-3;
    const SketchParts sketch =
        parts_of(dxf_line("1", "A", 0, 0, 10 - c, 0) + dxf_line("2", "A", 10 - c, 0, 10, c) +
                     dxf_line("3", "A", 10, c, 10, 10) + dxf_line("4", "A", 10, 10, 0, 10) + dxf_line("5", "A", 0, 10, 0, 0),
                 0.05);
    ASSERT_EQ(sketch.parts.size(), 1u);
    EXPECT_EQ(sketch.parts[0].edges.size(), 5u);
    EXPECT_NEAR(area(sketch.parts[0]), 100 - c * c / 2, 1e-12);
    EXPECT_LE(sketch.tolerance, c * std::sqrt(0.5) + 1e-15);
}

TEST(Sketch, WorksFarFromTheOrigin) {
    const Vec2 far(1e6, -3e6);
    Drawing drawing = pin_bracket();
    for (SketchEntity& entity : drawing.entities) entity.curve = transformed(entity.curve, 1, 0, far);
    const SketchParts sketch = parts_by_layer(drawing);
    ASSERT_EQ(sketch.parts.size(), 3u);
    EXPECT_TRUE(sketch.repairs.empty());
    EXPECT_NEAR(area(sketch.parts[0]), bracket_area, 1e-6);  // ulp of 3e6 is 5e-10, times the perimeter of 460
}

TEST(Units, ConvertsLengths) {
    EXPECT_EQ(unit_factor("in", "mm"), 25.4);
    EXPECT_EQ(unit_factor("mm", "mm"), 1);
    EXPECT_EQ(unit_factor("m", "mm"), 1000);
    EXPECT_EQ(unit_factor("mm", "m"), 1e-3);
    EXPECT_EQ(unit_factor("cm", "um"), 1e4);
    EXPECT_EQ(unit_factor("ft", "in"), 12);
    EXPECT_EQ(unit_factor("parsec", "mm"), 0);
    EXPECT_EQ(unit_factor("mm", ""), 0);
}

}  // namespace
}  // namespace abut::geometry::sketch_test
