// SPDX-License-Identifier: GPL-3.0-or-later
// Slots, scaled and mirrored placements, and deep trees.
#include <cmath>

#include "tests/geometry/csg/csg_nodes.hpp"

namespace csg_placement_test {

namespace {

using namespace abut::geometry;
using namespace abut::geometry::csg_nodes;

/// The same map in doubles, step by step as the format says.
Vec2 mapped(const Placed& place, Vec2 p) {
    p = place.scale * (p - place.about);
    if (place.mirror == Mirror::x) p.x() = -p.x();
    if (place.mirror == Mirror::y) p.y() = -p.y();
    const double a = place.rotate * pi / 180;
    return place.about + place.translate +
           Vec2(std::cos(a) * p.x() - std::sin(a) * p.y(), std::sin(a) * p.x() + std::cos(a) * p.y());
}

/// A part of every kind of edge, with a cut circle, a cut ellipse and a cut spline.
CsgNode bracket() {
    return less({join({rectangle(0, 0, 10, 6, "base"), slot(9, 1, 14, 5, 0.8), node(Polygon{{{0, 6}, {0, 9}, {3, 6}}}, "fin")}),
                 circle(0, 0, 2, "pin"), ellipse(5, 6, 2, 1, 15), loop_of({blob({5, 0}, 1.1)}), circle(8, 3, 0.5, "hole")});
}

double tolerance_of(const Part& part) {
    return 2e-12 * (bounding_box(part).diagonal() + bounding_box(part).max.norm() + bounding_box(part).min.norm());
}

/// The placed tree has the same edges under the same names, mapped, with the same places along their sources.
void expect_image(const CsgNode& tree, const CsgNode& placed_tree) {
    const Placed& map = std::get<Placed>(placed_tree.shape);
    const Part part = good(tree), image = good(placed_tree);
    ASSERT_EQ(names(image), names(part));
    EXPECT_EQ(image.loops.size(), part.loops.size());
    EXPECT_NEAR(area(image), map.scale * map.scale * area(part), 1e-12 * area(image));
    const double tolerance = tolerance_of(image);
    for (const Edge& e : part.edges) {
        const Edge& same = edge(image, e.name);
        const bool mirrored = map.mirror != Mirror::none;
        EXPECT_EQ(same.source, e.source);
        EXPECT_EQ(same.along_source, e.along_source != mirrored) << e.name;
        EXPECT_NEAR(same.source_begin, map.scale * e.source_begin, tolerance) << e.name;
        for (int i = 0; i <= 8; ++i) {
            const Vec2 p = mapped(map, point(e.curve, i / 8.0));
            expect_same_point(point(same.curve, mirrored ? 1 - i / 8.0 : i / 8.0), p, tolerance);
        }
    }
}

}  // namespace

TEST(CsgPlacement, SlotHasItsEdgesInOrder) {
    const Part part = good(slot(1, 2, 5, 5, 0.5, "s"));
    EXPECT_NEAR(area(part), 5 * 1 + pi / 4, 1e-14 * 10);
    ASSERT_EQ(part.edges.size(), 4u);
    EXPECT_EQ(part.edges[0].name, "s/side0");
    EXPECT_EQ(part.edges[1].name, "s/end1");
    EXPECT_EQ(part.edges[2].name, "s/side1");
    EXPECT_EQ(part.edges[3].name, "s/end0");
    expect_same_point(point(part.edges[0].curve, 0), {1.3, 1.6}, 1e-15);  // right of the way from (1, 2) to (5, 5)
    expect_same_point(point(part.edges[1].curve, 0.5), {5.4, 5.3}, 1e-14);
    EXPECT_NE(problem_of(slot(1, 2, 1, 2, 1)).find("no length"), std::string::npos);
    EXPECT_NE(problem_of(slot(1, 2, 3, 2, 0)).find("not positive"), std::string::npos);
}

TEST(CsgPlacement, SlotInAnyDirectionCutsAndFills) {
    for (int k = 0; k < 24; ++k) {
        const double a = 15.0 * k * pi / 180;
        const CsgNode s = slot(0.5, -0.25, 0.5 + 3 * std::cos(a), -0.25 + 3 * std::sin(a), 0.7);
        const double whole = 3 * 1.4 + pi * 0.49;
        const CsgNode plate = less({rectangle(-9, -9, 9, 9), s});
        EXPECT_NEAR(area_of(plate), 324 - whole, 1e-12 * 324) << k;
        EXPECT_EQ(good(join({plate, s})).edges.size(), 4u) << k;
        // discs at its ends add nothing but their inner halves
        EXPECT_NEAR(area_of(join({s, circle(0.5, -0.25, 0.7)})), whole, 1e-12 * whole) << k;
    }
}

TEST(CsgPlacement, ImagesOfATreeHaveTheSameEdges) {
    expect_image(bracket(), place(bracket(), 0, {3, 4}, {0, 0}, 2.5));
    expect_image(bracket(), place(bracket(), 0, {0, 0}, {5, 1}, 1, Mirror::x));
    expect_image(bracket(), place(bracket(), 0, {0, 0}, {5, 1}, 1, Mirror::y));
    for (double degrees : {30.0, -200.0})
        for (Mirror mirror : {Mirror::none, Mirror::x, Mirror::y})
            expect_image(bracket(), place(bracket(), degrees, {-7, 0.3}, {1.1, -2.3}, 0.125, mirror));
}

TEST(CsgPlacement, MirroredTreeIsTheDirectlyWrittenOne) {
    const CsgNode tree = less({rectangle(1, 0, 5, 3), circle(5, 3, 1), ellipse(2, 0, 0.5, 0.25, 20)});
    const CsgNode written = less({rectangle(-5, 0, -1, 3), circle(-5, 3, 1), ellipse(-2, 0, 0.5, 0.25, -20)});
    const Part mirrored = good(place(tree, 0, {0, 0}, {0, 0}, 1, Mirror::x)), direct = good(written);
    EXPECT_NEAR(area(mirrored), area(direct), 1e-14 * 12);
    EXPECT_EQ(names(mirrored), names(direct));  // but left is on the right
    EXPECT_GT(point(edge(mirrored, "left").curve, 0.5).x(), point(edge(mirrored, "right").curve, 0.5).x());
    for (const char* name : {"circle", "ellipse"})
        expect_same_point(point(edge(mirrored, name).curve, 0.5), point(edge(direct, name).curve, 0.5), 1e-14);
}

TEST(CsgPlacement, MirroredPiecesAreCountedInTheMirroredDirection) {
    // A cross of two bars cuts the circle four times; mirrored, its own direction is clockwise from angle 180.
    const CsgNode cross = less({circle(0, 0, 5), rectangle(-1, -9, 1, 9), rectangle(-9, -1, 9, 1)});
    const Part part = good(place(cross, 0, {0, 0}, {0, 0}, 1, Mirror::x));
    for (int k = 0; k < 4; ++k) {
        const Edge& e = edge(part, "circle#" + std::to_string(k));
        EXPECT_FALSE(e.along_source);
        EXPECT_NEAR(e.source_begin, 5 * (std::asin(0.2) + k * pi / 2), 1e-12 * 30);
        const double angle = pi - e.source_begin / 5;
        expect_same_point(point(e.curve, 1), 5 * Vec2(std::cos(angle), std::sin(angle)));
    }
}

TEST(CsgPlacement, NestedToDepthFiveWithAllKeys) {
    CsgNode tree = bracket();
    std::vector<Placed> maps;
    const Mirror mirrors[] = {Mirror::x, Mirror::none, Mirror::y, Mirror::x, Mirror::none};
    for (int k = 0; k < 5; ++k) {
        tree = place(tree, 17.0 * k + 5, {0.5 * k, 1.0 - k}, {1.0 * k, 0.25}, 0.75 + 0.25 * k, mirrors[k]);
        maps.push_back(std::get<Placed>(tree.shape));
        maps.back().of.clear();
    }
    const Part part = good(bracket()), image = good(tree);
    ASSERT_EQ(names(image), names(part));
    for (const Edge& e : part.edges) {
        Vec2 p = point(e.curve, 0.5);
        for (const Placed& map : maps) p = mapped(map, p);
        expect_same_point(point(edge(image, e.name).curve, 0.5), p, tolerance_of(image));
        EXPECT_NE(edge(image, e.name).along_source, e.along_source);  // three mirrors
    }
    EXPECT_GT(area(image), 0);
}

TEST(CsgPlacement, TwoMirrorsAreExactlyNone) {
    const CsgNode square = rectangle(-1, -2, 3, 3);
    const CsgNode back = place(place(square, 37, {0, 0}, {1, 1}, 2, Mirror::x), 37, {0, 0}, {1, 1}, 0.5, Mirror::x);
    EXPECT_EQ(names(good(join({square, back}))), (Names{"left", "right", "bottom", "top"}));
}

TEST(CsgPlacement, MirroredImportRunsTheOtherWay) {
    Part drawn = good(less({rectangle(0, 0, 6, 4), circle(2, 2, 1), rectangle(-1, 1, 1, 2)}));
    const Part image = good(place(import(drawn), 30, {1, 0}, {0, 0}, 2, Mirror::x));
    EXPECT_NEAR(area(image), 4 * area(drawn), 1e-13 * area(image));
    EXPECT_EQ(count_holes(image), 1);
    for (const Edge& e : drawn.edges) {
        EXPECT_EQ(edge(image, e.name).source_begin, 2 * e.source_begin);
        EXPECT_NE(edge(image, e.name).along_source, e.along_source);
    }
    const Part cut = good(less({place(import(drawn), 0, {0, 0}, {0, 0}, 2, Mirror::x), rectangle(-13, 6, 1, 9)}));
    EXPECT_NEAR(area(cut), 4 * area(drawn) - 24, 1e-12 * area(cut));
    EXPECT_NEAR(edge(cut, "left#0").source_begin, 2, 1e-12 * 20);  // of the drawn pieces of the left edge the upper one is cut
}

TEST(CsgPlacement, ScaleMustBePositive) {
    EXPECT_NE(problem_of(place(circle(0, 0, 1), 0, {0, 0}, {0, 0}, 0)).find("scale"), std::string::npos);
    EXPECT_NE(problem_of(place(circle(0, 0, 1), 0, {0, 0}, {0, 0}, -1)).find("scale"), std::string::npos);
    EXPECT_NE(problem_of(place(circle(0, 0, 1), 0, {0, 0}, {0, 0}, std::nan(""))).find("not finite"), std::string::npos);
}

TEST(CsgPlacement, TreesMayBeAThousandDeep) {
    CsgNode holes = rectangle(-1, -1, 1001, 1);
    for (int k = 0; k < 1000; ++k) holes = less({std::move(holes), circle(k, 0, 0.4)});
    EXPECT_NEAR(area_of(holes), 2004 - 1000 * pi * 0.16, 1e-11 * 2004);
    CsgNode chain = circle(0, 0, 0.6);
    for (int k = 1; k < 1000; ++k) chain = join({std::move(chain), circle(k, 0, 0.6)});
    EXPECT_EQ(good(chain).loops.size(), 1u);
    CsgNode moved = rectangle(0, 0, 1, 1);
    for (int k = 0; k < 1000; ++k) moved = place(std::move(moved), 0, {1, 0}, {0, 0}, 1, Mirror::x);
    EXPECT_NEAR(area_of(join({moved, circle(0, 0, 0.5)})), 1 + pi * 0.25 * 0.75, 1e-12);
}

}  // namespace csg_placement_test
