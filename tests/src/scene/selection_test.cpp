// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/selection.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/curves/spline_shape.hpp"

namespace abut::selection_test {

namespace {

using geometry::Arc;
using geometry::Curve;
using geometry::Segment;
constexpr double pi = std::numbers::pi;

ScenePart part_of(const std::string& name, const std::vector<std::pair<std::string, Curve>>& edges) {
    ScenePart part;
    part.name = part.part.name = name;
    part.part.loops.emplace_back();
    for (const auto& [edge, curve] : edges) {
        part.part.loops.back().edges.push_back(static_cast<int>(part.part.edges.size()));
        part.part.edges.push_back({curve, edge, edge, true, 0});
    }
    return part;
}

/// A unit square whose left edge is in two pieces, a disc about (5, 0) of radius 2, and a ring's hole (clockwise) about (10,
/// 0).
Scene make_scene() {
    Scene scene;
    scene.parts.push_back(part_of("jaw", {{"bottom", Segment{{0, 0}, {1, 0}}},
                                          {"right", Segment{{1, 0}, {1, 1}}},
                                          {"top", Segment{{1, 1}, {0, 1}}},
                                          {"left#0", Segment{{0, 1}, {0, 0.5}}},
                                          {"left#1", Segment{{0, 0.5}, {0, 0}}}}));
    scene.parts.push_back(part_of("pin", {{"circle", Arc{{5, 0}, 2, 0, 2 * pi}}}));
    scene.parts.push_back(part_of("ring", {{"base/hole", Arc{{10, 0}, 1, 0, -2 * pi}}}));
    return scene;
}

Selector named(const std::string& pattern) {
    Selector selector;
    selector.pattern = pattern;
    selector.where = "/supports/0/on";
    return selector;
}
Selector of_part(const std::string& part) {
    Selector selector;
    selector.part = part;
    selector.where = "/supports/0/on";
    return selector;
}
Selector in_box(const std::string& part, const Vec2& min, const Vec2& max) {
    Selector selector = of_part(part);
    selector.box = {min, max};
    return selector;
}
Selector facing(const std::string& part, const Vec2& direction, double within) {
    Selector selector = of_part(part);
    selector.facing = direction;
    selector.within = within;
    return selector;
}

std::vector<std::string> names(const Scene& scene, const Selection& selection) {
    std::vector<std::string> result;
    for (const EdgePortion& p : select(scene, selection)) {
        const ScenePart& part = scene.parts[static_cast<std::size_t>(p.part)];
        result.push_back(part.name + "/" + part.part.edges[static_cast<std::size_t>(p.edge)].name);
    }
    return result;
}

using Names = std::vector<std::string>;

std::string fault(const Scene& scene, const Selection& selection) {
    try {
        select(scene, selection);
    } catch (const InputError& error) { return error.what(); }
    return "no error";
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Is the point at parameter t of the edge in one of the portions?
bool covered(const std::vector<EdgePortion>& portions, double t) {
    for (const EdgePortion& p : portions) {
        if (t >= p.t0 && t <= p.t1) return true;
    }
    return false;
}

}  // namespace

TEST(Selection, takes_edges_by_name) {
    const Scene scene = make_scene();
    EXPECT_EQ(names(scene, {named("jaw/top")}), Names({"jaw/top"}));
    EXPECT_EQ(names(scene, {named("jaw/left")}), Names({"jaw/left#0", "jaw/left#1"}));
    EXPECT_EQ(names(scene, {named("jaw/left#1")}), Names({"jaw/left#1"}));
    EXPECT_EQ(names(scene, {named("ring/base/hole")}), Names({"ring/base/hole"}));
}

TEST(Selection, takes_edges_by_pattern) {
    const Scene scene = make_scene();
    EXPECT_EQ(names(scene, {named("jaw/*")}).size(), 5u);
    EXPECT_EQ(names(scene, {named("jaw/*t")}), Names({"jaw/right", "jaw/left#0", "jaw/left#1"}));
    EXPECT_EQ(names(scene, {named("*hole")}), Names({"ring/base/hole"}));
    EXPECT_EQ(names(scene, {named("*i*c*e")}), Names({"pin/circle"}));
    EXPECT_EQ(names(scene, {named("*")}).size(), 7u);
    EXPECT_EQ(names(scene, {named("jaw/b*m*")}), Names({"jaw/bottom"}));
}

TEST(Selection, merges_what_is_selected_twice) {
    const Scene scene = make_scene();
    const auto portions =
        select(scene, {in_box("jaw", {-1, -1}, {0.6, 0.5}), named("jaw/bottom"), in_box("jaw", {0.4, -1}, {2, 0.2})});
    // bottom whole, right up to 0.2, and left#1 whole
    ASSERT_EQ(portions.size(), 3u);
    EXPECT_EQ(portions[0].edge, 0);
    EXPECT_EQ(portions[0].t0, 0);
    EXPECT_EQ(portions[0].t1, 1);
    EXPECT_EQ(portions[1].edge, 1);
    EXPECT_NEAR(portions[1].t1, 0.2, 1e-15);
    EXPECT_EQ(portions[2].edge, 4);
}

TEST(Selection, takes_the_closest_edge) {
    const Scene scene = make_scene();
    Selector selector = of_part("jaw");
    selector.near = Vec2(0.9, 0.45);
    EXPECT_EQ(names(scene, {selector}), Names({"jaw/right"}));
    selector.near = Vec2(-0.3, 0.7);
    EXPECT_EQ(names(scene, {selector}), Names({"jaw/left#0"}));
}

TEST(Selection, takes_edges_on_a_side_of_the_box) {
    const Scene scene = make_scene();
    EXPECT_EQ(names(scene, {in_box("jaw", {0, 0}, {1, 0})}), Names({"jaw/bottom"}));
    EXPECT_EQ(names(scene, {in_box("jaw", {0, 0}, {1, 1})}).size(), 5u);
    const auto portions = select(scene, {in_box("pin", {3, -2}, {7, 2})});  // the box that just touches the circle: no cuts
    ASSERT_EQ(portions.size(), 1u);
    EXPECT_EQ(portions[0].t0, 0);
    EXPECT_EQ(portions[0].t1, 1);
}

TEST(Selection, cuts_a_circle_at_the_box) {
    const Scene scene = make_scene();
    const auto portions = select(scene, {in_box("pin", {4, 0}, {6, 9})});  // x = 5 +- 1: 60 to 120 degrees
    ASSERT_EQ(portions.size(), 1u);
    EXPECT_NEAR(portions[0].t0, 60.0 / 360, 1e-15);
    EXPECT_NEAR(portions[0].t1, 120.0 / 360, 1e-15);
}

TEST(Selection, takes_what_faces_a_direction) {
    const Scene scene = make_scene();
    EXPECT_EQ(names(scene, {facing("jaw", {-3, 0}, 5)}), Names({"jaw/left#0", "jaw/left#1"}));
    EXPECT_EQ(names(scene, {facing("jaw", {1, 1}, 45)}), Names({"jaw/right", "jaw/top"}));  // at the limit
    EXPECT_EQ(names(scene, {facing("jaw", {1, 0}, 180)}).size(), 5u);
    const auto disc =
        select(scene, {facing("pin", {1, 0}, 30)});  // about angle 0: one piece on each side of the circle's begin
    ASSERT_EQ(disc.size(), 2u);
    EXPECT_EQ(disc[0].t0, 0);
    EXPECT_NEAR(disc[0].t1, 30.0 / 360, 1e-15);
    EXPECT_NEAR(disc[1].t0, 330.0 / 360, 1e-15);
    EXPECT_EQ(disc[1].t1, 1);
    const auto hole =
        select(scene, {facing("ring", {0, 1}, 10)});  // a hole faces its centre: its lowest point, at 90 degrees clockwise
    ASSERT_EQ(hole.size(), 1u);
    EXPECT_NEAR(hole[0].t0, 80.0 / 360, 1e-15);
    EXPECT_NEAR(hole[0].t1, 100.0 / 360, 1e-15);
}

TEST(Selection, takes_the_closest_of_curved_edges) {
    Scene scene;
    scene.parts.push_back(part_of("p", {{"shell", geometry::EllipticArc{{0, 0}, {3, 0}, {0, 1}, 0, pi}},
                                        {"wave", geometry::bezier_curve({{-3, 0}, {-1, -2}, {1, 2}, {3, 0}}, {})}}));
    Selector selector = of_part("p");
    selector.near = Vec2(0.8, 0.55);  // 0.4 below the ellipse, 0.3 above the spline
    EXPECT_EQ(names(scene, {selector}), Names({"p/wave"}));
    selector.near = Vec2(0.8, 0.75);
    EXPECT_EQ(names(scene, {selector}), Names({"p/shell"}));
}

TEST(Selection, takes_all_pieces_of_pieces) {
    Scene scene;
    scene.parts.push_back(part_of("p", {{"cam#0", Segment{{0, 0}, {1, 0}}},
                                        {"cam#1#0", Segment{{1, 0}, {1, 1}}},
                                        {"cam#1#1", Segment{{1, 1}, {0, 1}}},
                                        {"came", Segment{{0, 1}, {0, 0}}}}));
    EXPECT_EQ(names(scene, {named("p/cam")}), Names({"p/cam#0", "p/cam#1#0", "p/cam#1#1"}));
    EXPECT_EQ(names(scene, {named("p/cam#1")}), Names({"p/cam#1#0", "p/cam#1#1"}));
    EXPECT_EQ(names(scene, {named("p/cam#1#1")}), Names({"p/cam#1#1"}));
}

TEST(Selection, several_portions_of_one_spline_may_face_a_direction) {
    // A wave with two crests: its normal, outward on the right of the way to the left, points up at both.
    const Curve wave = geometry::bezier_curve({{4, 0}, {3, 6}, {2, -10}, {2, -10}, {1, 6}, {0, 0}}, {});
    Scene scene;
    scene.parts.push_back(part_of("p", {{"wave", wave}}));
    const auto up = select(scene, {facing("p", {0, 1}, 10)});
    ASSERT_EQ(up.size(), 3u);  // two crests and the trough between them
    for (const EdgePortion& portion : up)
        for (const double t : {portion.t0, portion.t1})
            EXPECT_NEAR(geometry::outward_normal(wave, t).y(), std::cos(10 * pi / 180), 1e-12) << t;
}

Curve random_curve(int kind, std::mt19937& random) {
    std::uniform_real_distribution<double> real(-1, 1);
    const auto point = [&] { return Vec2(real(random), real(random)); };
    if (kind == 0) return Segment{point(), point()};
    if (kind == 1) return Arc{point(), 0.2 + std::abs(real(random)), 7 * real(random), 2 * pi * real(random)};
    if (kind == 2) {
        const Vec2 a = point(), b = 2 * real(random) * geometry::left_of(a);  // either way round
        return geometry::EllipticArc{point(), a, b, 7 * real(random), 2 * pi * real(random)};
    }
    std::vector<Vec2> points;
    std::vector<double> weights;
    for (int k = 0; k < 3 + kind; ++k) {
        points.push_back(point());
        weights.push_back(std::exp(real(random)));
    }
    if (kind == 3) return geometry::bezier_curve(points, weights);
    const geometry::Nurbs closed{3, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, points, weights};
    return geometry::nurbs_curves(closed).front();
}

// Portions against the definition at sampled points; samples within 1e-6 of a limit may go either way.
TEST(Selection, agrees_with_sampling_on_random_curves) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> real(-1, 1);
    int n_inside = 0, n_facing = 0;
    for (int i = 0; i < 500; ++i) {
        const Curve curve = random_curve(i % 5, random);
        Scene scene;
        scene.parts.push_back(part_of("p", {{"e", curve}}));
        const Vec2 a(real(random), real(random)), b(real(random), real(random));
        const Selector box = in_box("p", a.cwiseMin(b), a.cwiseMax(b));
        const Selector face = facing("p", {real(random), real(random)}, 90 + 90 * real(random));
        const auto portions_of = [&](const Selector& s) {
            try {
                return select(scene, {s});
            } catch (const InputError&) { return std::vector<EdgePortion>{}; }
        };
        const auto boxed = portions_of(box), faced = portions_of(face);
        for (int k = 0; k < 200; ++k) {
            const double t = (k + 0.5) / 200;
            const Vec2 p = geometry::point(curve, t), n = geometry::outward_normal(curve, t);
            const Vec2 low = p - (*box.box)[0], high = (*box.box)[1] - p;
            const double depth = std::min(low.minCoeff(), high.minCoeff());
            const double angle = std::abs(std::atan2(geometry::cross(*face.facing, n), face.facing->dot(n)));
            const double margin = face.within * pi / 180 - angle;
            if (std::abs(depth) > 1e-6) { EXPECT_EQ(covered(boxed, t), depth > 0) << i << " " << t; }
            if (std::abs(margin) > 1e-6) { EXPECT_EQ(covered(faced, t), margin > 0) << i << " " << t; }
            n_inside += depth > 0;
            n_facing += margin > 0;
        }
    }
    EXPECT_GT(n_inside, 5000);
    EXPECT_GT(n_facing, 30000);
}

TEST(Selection, says_what_there_is_where_nothing_matches) {
    const Scene scene = make_scene();
    EXPECT_EQ(
        fault(scene, {named("jaw/lift")}),
        "/supports/0/on: no edge matches 'jaw/lift'; did you mean 'jaw/left'? the edges are jaw/bottom, jaw/right, jaw/top, "
        "jaw/left#0, jaw/left#1");
    EXPECT_TRUE(
        contains(fault(scene, {named("jow/left")}), "there is no part 'jow'; did you mean 'jaw'? known here: jaw, pin, ring"));
    EXPECT_TRUE(contains(fault(scene, {named("pin")}), "'pin' names a part, not an edge; write \"pin/*\""));
    EXPECT_TRUE(contains(fault(scene, {named("*bore")}), "no edge matches '*bore'"));
    EXPECT_TRUE(contains(fault(scene, {in_box("pin", {0, 0}, {1, 1})}),
                         "no edge of 'pin' lies inside the box; its edges are pin/circle"));
    EXPECT_TRUE(contains(fault(scene, {facing("jaw", {1, 1}, 5)}), "no edge of 'jaw' lies facing this way"));
    EXPECT_TRUE(contains(fault(scene, {of_part("axle")}), "there is no part 'axle'"));
    Selector elsewhere = of_part("jaw");
    elsewhere.near = Vec2(900, 450);
    EXPECT_TRUE(contains(fault(scene, {elsewhere}), "the place is 1005 away from 'jaw', which is 1.414 across; give a place"))
        << fault(scene, {elsewhere});
}

TEST(Selection, reports_every_selector_that_matches_nothing) {
    const Scene scene = make_scene();
    try {
        select(scene, {named("jaw/a"), named("jaw/top"), named("pin/b")});
        FAIL();
    } catch (const InputError& error) { EXPECT_EQ(error.problems().size(), 2u); }
}

TEST(Selection, lists_at_most_twenty_edges) {
    Scene scene;
    std::vector<std::pair<std::string, Curve>> edges;
    for (int i = 0; i < 30; ++i) edges.emplace_back("e" + std::to_string(i), Segment{{i, 0}, {i + 1, 0}});
    scene.parts.push_back(part_of("p", edges));
    const std::string message = fault(scene, {named("p/x")});
    EXPECT_TRUE(contains(message, "p/e19 and 10 more"));
    EXPECT_FALSE(contains(message, "p/e20"));
}

}  // namespace abut::selection_test
