// SPDX-License-Identifier: GPL-3.0-or-later
// Recovered curves beside other boundaries.
#include "geometry/mesh/section_bulges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geometry/mesh/section.hpp"
#include "tests/geometry/mesh/small_meshes.hpp"

namespace abut::geometry::section_bulges_test {
namespace {

constexpr double pi = std::numbers::pi;

Section middle(const std::vector<Mesh>& objects) {
    return cut(bodies_of(objects), {2, 0.5}, 0);
}

/// A square plate of half width a with a hole of as many points as its edge is given.
Mesh plate_with_hole(double a, const std::vector<Vec2>& hole, const std::string& name) {
    Mesh mesh{name, {}, {}};
    const int n = static_cast<int>(hole.size());
    for (double z : {0.0, 1.0})
        for (const Vec2& p : hole) {
            mesh.vertices.push_back({p.x(), p.y(), z});
            const Vec2 out = a / p.cwiseAbs().maxCoeff() * p;
            mesh.vertices.push_back({out.x(), out.y(), z});
        }
    const auto quad = [&](int p, int q, int r, int s) {
        mesh.triangles.push_back({p, q, r});
        mesh.triangles.push_back({p, r, s});
    };
    for (int i = 0; i < n; ++i) {
        const int in = 2 * i, out = in + 1, in2 = 2 * ((i + 1) % n), out2 = in2 + 1, up = 2 * n;
        quad(out, out2, out2 + up, out + up);
        quad(in2, in, in + up, in2 + up);
        quad(in, in2, out2, out);
        quad(in + up, out + up, out2 + up, in2 + up);
    }
    return mesh;
}

Mesh pin(double radius, int n, double start) {
    return prism(regular_polygon({0, 0}, radius, n, start), 0, 1, "pin");
}

int n_arcs(const Section& section, const std::string& body) {
    return static_cast<int>(std::count_if(
        section.drawing.entities.begin(), section.drawing.entities.end(),
        [&](const SketchEntity& entity) { return entity.layer == body && std::holds_alternative<Arc>(entity.curve); }));
}

const Repair* left_as_they_are(const Section& section) {
    for (const Repair& repair : section.repairs)
        if (repair.what.find("left as they are") != std::string::npos) return &repair;
    return nullptr;
}

/// 30 flat sides, one of them down: its circle would reach 0.0548 into the ground.
TEST(SectionBulges, ARollerOfFlatSidesKeepsThemWhereItStandsOnOne) {
    const double down = -10 * std::cos(pi / 30);
    const Mesh roller = prism(regular_polygon({0, 0}, 10, 30, -pi / 2 + pi / 30), 0, 1, "roller");
    for (double gap : {0.0, 0.01, 0.05}) {
        const Section on_ground = middle({roller, box({-30, -20, 0}, {30, down - gap, 1}, "ground")});
        const double depth = 10 - 10 * std::cos(pi / 30) - gap;
        EXPECT_EQ(n_arcs(on_ground, "roller"), 0) << gap;
        EXPECT_EQ(on_ground.drawing.entities.size(), 34u);
        ASSERT_TRUE(left_as_they_are(on_ground));
        EXPECT_NEAR(left_as_they_are(on_ground)->size, depth, 0.01 * depth);
        EXPECT_NE(left_as_they_are(on_ground)->what.find("ground"), std::string::npos);
    }
    EXPECT_EQ(n_arcs(middle({roller, box({-30, -20, 0}, {30, down - 0.06, 1}, "ground")}), "roller"), 1);
    EXPECT_EQ(n_arcs(middle({roller}), "roller"), 1);
    // with an edge down it is a circle that touches
    const Mesh turned = prism(regular_polygon({0, 0}, 10, 30, -pi / 2), 0, 1, "roller");
    EXPECT_EQ(n_arcs(middle({turned, box({-30, -20, 0}, {30, -10, 1}, "ground")}), "roller"), 1);
}

/// Clearance far below the sagitta, or none: facets of the two overlap, or run closer than the circles. These are the truth.
TEST(SectionBulges, PinsInHolesAreCirclesWhateverTheirClearance) {
    std::mt19937 random(8);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int trial = 0; trial < 200; ++trial) {
        const int n = 24 + static_cast<int>(random() % 60), m = trial % 2 ? n : 24 + static_cast<int>(random() % 60);
        const double clearance = std::array{0.0, 0.001, 0.02, 0.2, -0.003, -0.02}[static_cast<std::size_t>(trial % 6)];
        const Section found = middle({plate_with_hole(20, regular_polygon({0, 0}, 10, n, unit(random)), "plate"),
                                      pin(10 - clearance, m, trial % 4 == 0 ? 0 : unit(random))});
        EXPECT_EQ(n_arcs(found, "plate"), 1) << n << " " << m << " " << clearance;
        EXPECT_EQ(n_arcs(found, "pin"), 1) << n << " " << m << " " << clearance;
    }
}

TEST(SectionBulges, TwoRollersOnFlatSidesKeepThem) {
    const double half = 10 * std::cos(pi / 28);
    Mesh right = prism(regular_polygon({half + 0.02, 0}, 10, 28, pi / 28), 0, 1, "right");
    const Mesh left = prism(regular_polygon({-half, 0}, 10, 28, pi / 28), 0, 1, "left");
    const Section found = middle({left, right});
    EXPECT_EQ(n_arcs(found, "left") + n_arcs(found, "right"), 0);
    for (Vec3& v : right.vertices) v.x() += 0.12;  // twice the sagitta of 0.063, less the 0.02: they clear each other
    const Section apart = middle({left, right});
    EXPECT_EQ(n_arcs(apart, "left") + n_arcs(apart, "right"), 2);
}

/// A wall thinner than the sagitta between a hole and a face.
TEST(SectionBulges, AHoleDoesNotBreakThroughItsOwnWall) {
    const std::vector<Vec2> hole = regular_polygon({0, 0}, 10, 24, pi / 24);
    const double side = 10 * std::cos(pi / 24);
    const Section thin = middle({plate_with_hole(side + 0.03, hole, "plate")});
    EXPECT_EQ(n_arcs(thin, "plate"), 0);
    ASSERT_TRUE(left_as_they_are(thin));
    EXPECT_NE(left_as_they_are(thin)->what.find("cross it elsewhere"), std::string::npos);
    EXPECT_EQ(n_arcs(middle({plate_with_hole(10.05, hole, "plate")}), "plate"), 1);
}

TEST(SectionBulges, ACornerBetweenFacetAndCurveIsInTheWay) {
    const Mesh roller = prism(regular_polygon({0, 0}, 10, 24, pi / 24), 0, 1, "roller");
    const double side = 10 * std::cos(pi / 24);
    for (double y : {-1.0, 0.01, 0.77}) {
        const auto blade = [&](double x) { return prism({{x, y}, {x + 5, y - 0.01}, {x + 5, y + 0.01}}, 0, 1, "blade"); };
        EXPECT_EQ(n_arcs(middle({roller, blade(side + 0.005)}), "roller"), 0) << y;
        EXPECT_EQ(n_arcs(middle({roller, blade(10.01)}), "roller"), 1) << y;
    }
}

TEST(SectionBulges, ArcsCanBeSwitchedOff) {
    std::vector<Vec2> oval;
    for (const Vec2& p : regular_polygon({0, 0}, 10, 60)) oval.push_back({p.x(), 0.7 * p.y()});
    const MeshFile file = bodies_of({pin(10, 30, 0), prism(oval, 0, 1, "cam")});
    const Section lines = cut(file, {2, 0.5}, {0, false}), arcs = cut(file, {2, 0.5}, {0, true});
    EXPECT_EQ(n_arcs(lines, "pin") + n_arcs(lines, "cam"), 0);
    EXPECT_EQ(lines.drawing.entities.size(), 90u);
    EXPECT_TRUE(lines.repairs.empty());
    EXPECT_EQ(n_arcs(arcs, "pin"), 1);
    EXPECT_GE(n_arcs(arcs, "cam"), 15);
    double enclosed = 0;  // by the cam, of area 70 pi; its facets enclose 0.18 % less
    for (const SketchEntity& entity : arcs.drawing.entities) {
        if (entity.layer != "cam") continue;
        const Arc& arc = std::get<Arc>(entity.curve);
        enclosed += 0.5 * (cross(point(arc, 0), point(arc, 1)) + arc.radius * arc.radius * (arc.sweep - std::sin(arc.sweep)));
    }
    EXPECT_NEAR(enclosed, 70 * pi, 1e-4 * 70 * pi);
}

}  // namespace
}  // namespace abut::geometry::section_bulges_test
