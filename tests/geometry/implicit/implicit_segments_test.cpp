// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of boundaries given by their edges: whole parts, some edges, points.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "geometry/implicit/implicit.hpp"
#include "tests/geometry/implicit/field_checks.hpp"

namespace abut::geometry::implicit_segments_test {

namespace {

double size_of(const Part& part) {
    return bounding_box(part).diagonal();
}

std::vector<int> edges_of(const Part& part) {
    std::vector<int> all;
    for (std::size_t e = 0; e < part.edges.size(); ++e) all.push_back(static_cast<int>(e));
    return all;
}

void expect_derivatives_around(const Part& part, const ImplicitField& field, unsigned seed, int n, const std::string& name) {
    expect_derivatives([&](const Vec2& q) { return evaluate(field, q); }, PointsAround(part, seed), n, size_of(part), name);
}

}  // namespace

TEST(DistanceField, VanishesOnTheEdgesWithUnitNormalDerivative) {
    for (const NamedBody& each : all_bodies())
        for (int m = 1; m <= 4; ++m) {
            const ImplicitField field = distance_field(each.part, m);
            for (const Edge& edge : each.part.edges)
                for (const double t : {0.1, 0.31, 0.5, 0.77, 0.93}) {
                    const FieldValue w = evaluate(field, point(edge.curve, t));
                    EXPECT_LE(std::abs(w.value), 1e-14 * size_of(each.part)) << each.name << " " << edge.name << " " << t;
                    EXPECT_LE((w.gradient + outward_normal(edge.curve, t)).norm(), 1e-9)
                        << each.name << " " << edge.name << " " << t << " m " << m;
                }
        }
}

TEST(DistanceField, IsNormalisedToItsOrder) {
    // next to an edge and away from the others |w - f| is of order f^(m+1), f the untrimmed function: for lines the distance
    const Part square = body({closed_polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}})});
    for (const int m : {1, 2, 4}) {
        const ImplicitField field = distance_field(square, m);
        const double far = value(field, {0.4, 0.02}) / 0.02 - 1, near = value(field, {0.4, 0.01}) / 0.01 - 1;
        EXPECT_NEAR(std::log2(far / near), m, 0.1);
    }
}

TEST(DistanceField, SignIsMembership) {
    for (const NamedBody& each : all_bodies()) {
        const ImplicitField field = distance_field(each.part, 2);
        PointsAround points(each.part, 3);
        for (int i = 0; i < 400; ++i) {
            const Vec2 p = points();
            EXPECT_EQ(value(field, p) > 0, contains(each.part, p)) << each.name << " at " << p.transpose();
        }
    }
}

TEST(DistanceField, VanishesNowhereElse) {
    // Bounds of w / distance that a field with a hidden zero, or one that is lost beyond the ends of edges, breaks. Joins of n
    // edges lose at most n^(1/m); a circle's function is at least half the distance.
    for (const NamedBody& each : all_bodies()) {
        const ImplicitField field = distance_field(each.part, 2);
        PointsAround points(each.part, 4);
        double least = 1e300, largest = 0;
        for (int i = 0; i < 1000; ++i) {
            const Vec2 p = points();
            const double ratio = std::abs(value(field, p)) / true_distance(each.part, p);
            least = std::min(least, ratio);
            largest = std::max(largest, ratio);
        }
        EXPECT_GT(least, 0.15) << each.name;
        EXPECT_LT(largest, 4) << each.name;
    }
}

TEST(DistanceField, GradientAndHessianAgreeWithDifferences) {
    for (const NamedBody& each : all_bodies())
        for (const int m : {2, 3, 4}) {
            const ImplicitField field = distance_field(each.part, m);
            expect_derivatives_around(each.part, field, 7, 100, each.name);
            PointsAround points(each.part, 8);
            for (int i = 0; i < 50; ++i) {
                const Vec2 p = points();
                EXPECT_NEAR(evaluate(field, p).value, value(field, p), 1e-14 * size_of(each.part));
            }
        }
}

TEST(DistanceField, IsSmoothAcrossTheBoundary) {
    for (const NamedBody& each : all_bodies()) {
        const ImplicitField field = distance_field(each.part, 2);
        for (const Edge& edge : each.part.edges)
            for (const double t : {0.3, 0.6}) {
                const Vec2 p = point(edge.curve, t), n = outward_normal(edge.curve, t);
                const double h = 1e-6 * size_of(each.part);
                const FieldValue in = evaluate(field, p - h * n), on = evaluate(field, p), out = evaluate(field, p + h * n);
                EXPECT_NEAR(in.value, h, 1e-4 * h);
                EXPECT_NEAR(out.value, -h, 1e-4 * h);
                // what changes smoothly changes evenly to both sides; a jump would be of the order of the Hessian itself
                EXPECT_LE((in.hessian + out.hessian - 2 * on.hessian).norm(),
                          1e-7 * (1 / size_of(each.part) + on.hessian.norm()))
                    << each.name << " " << edge.name;
            }
    }
}

TEST(DistanceField, DoesNotDependOnUnitOrPlace) {
    const Similarity map{0.6, 0.8, {300, -20}, 1000, true};
    for (const NamedBody& each : all_bodies()) {
        Part image;
        for (const Edge& edge : each.part.edges) image.edges.push_back({reversed(transformed(edge.curve, map)), "", ""});
        for (const Loop& loop : each.part.loops) image.loops.push_back({{loop.edges.rbegin(), loop.edges.rend()}});
        const ImplicitField field = distance_field(each.part, 2), moved = distance_field(image, 2);
        PointsAround points(each.part, 9);
        for (int i = 0; i < 100; ++i) {
            const Vec2 p = points();
            EXPECT_NEAR(value(moved, map(p)) / map.scale, value(field, p), 1e-11) << each.name << " at " << p.transpose();
        }
    }
}

TEST(DistanceField, CornersAreZeroWithoutDerivatives) {
    const ImplicitField field = distance_field(body({closed_polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}})}), 2);
    const FieldValue w = evaluate(field, {1, 0});
    EXPECT_EQ(w.value, 0);
    EXPECT_FALSE(w.gradient.allFinite());
}

TEST(EdgeField, VanishesOnItsEdgesOnlyWithUnitNormalDerivative) {
    for (const NamedBody& each : all_bodies())
        for (const int only : edges_of(each.part)) {
            const ImplicitField field = edge_field(each.part, {only}, 2);
            for (const int e : edges_of(each.part))
                for (const double t : {0.2, 0.5, 0.7}) {
                    const Curve& curve = each.part.edges[static_cast<std::size_t>(e)].curve;
                    const FieldValue w = evaluate(field, point(curve, t));
                    if (e != only) {
                        EXPECT_GT(w.value, 0.01 * size_of(each.part)) << each.name << " " << e;
                        continue;
                    }
                    EXPECT_LE(w.value, 1e-14 * size_of(each.part));
                    EXPECT_GE(w.value, 0);
                    EXPECT_LE((w.gradient + outward_normal(curve, t)).norm(), 1e-9) << each.name << " " << e;
                }
        }
}

TEST(EdgeField, IsPositiveOnBothSides) {
    for (const NamedBody& each : all_bodies()) {
        const ImplicitField field = edge_field(each.part, edges_of(each.part), 2), whole = distance_field(each.part, 2);
        PointsAround points(each.part, 10);
        for (int i = 0; i < 100; ++i) {
            const Vec2 p = points();
            EXPECT_EQ(value(field, p), std::abs(value(whole, p))) << each.name;
        }
        expect_derivatives_around(each.part, field, 11, 50, each.name);
    }
}

TEST(PointField, ComposesSquaredDistancesAsTheDissertation) {
    const std::vector<Vec2> pins{{0, 0}, {1, 0}, {4, 1}, {5, 1}, {2, 3}};
    const ImplicitField two = point_field({pins[0], pins[1]}), all = point_field(pins);
    const Part box = body({closed_polygon({{0, 0}, {5, 0}, {5, 3}, {0, 3}})});
    PointsAround points(box, 12);
    for (int i = 0; i < 100; ++i) {
        const Vec2 p = points();
        const double a = (p - pins[0]).squaredNorm(), b = (p - pins[1]).squaredNorm();
        EXPECT_NEAR(value(two, p), a + b - std::hypot(a, b), 1e-13 * (a + b));
        EXPECT_GT(value(all, p), 0);
    }
    for (const Vec2& pin : pins) EXPECT_EQ(value(all, pin), 0);
    // in length^2: the size divides it out
    const double size = size_of(box);
    const auto scaled = [&](const Vec2& q) {
        FieldValue w = evaluate(all, q);
        return FieldValue{w.value / size, w.gradient / size, w.hessian / size};
    };
    expect_derivatives(scaled, PointsAround(box, 13), 100, size, "pins");
}

TEST(WholeField, IsZeroAllAlongWhatAnEdgeLiesOn) {
    const Curve segment = Segment{{1, 2}, {4, 6}};
    const ImplicitField line = whole_field(segment);
    // beyond the ends, too; positive on the left of (3, 4)
    EXPECT_NEAR(value(line, Vec2(7, 10)), 0, 1e-14);
    EXPECT_NEAR(value(line, Vec2(1, 2) + 3 * Vec2(-0.8, 0.6)), 3, 1e-14);
    for (const NamedBody& each : all_bodies())
        for (const Edge& edge : each.part.edges) {
            const ImplicitField field = whole_field(edge.curve);
            for (const double t : {0.1, 0.5, 0.93}) {
                const FieldValue w = evaluate(field, point(edge.curve, t));
                EXPECT_LE(std::abs(w.value), 1e-14 * size_of(each.part)) << each.name << " " << edge.name;
                EXPECT_LE((w.gradient + outward_normal(edge.curve, t)).norm(), 1e-9) << each.name << " " << edge.name;
            }
            expect_derivatives_around(each.part, field, 17, 20, each.name + " " + edge.name);
        }
}

TEST(Equivalence, JoinsFields) {
    const Part ell = round_bodies().front().part;
    const ImplicitField a = edge_field(ell, {0}, 2), b = edge_field(ell, {3}, 2), both = edge_field(ell, {0, 3}, 2);
    PointsAround points(ell, 14);
    for (int i = 0; i < 50; ++i) {
        const Vec2 p = points();
        EXPECT_NEAR(value(equivalence({a, b}, 2), p), value(both, p), 1e-14);
    }
}

TEST(DistanceField, RefusesWhatItCannotTell) {
    const Part part = round_bodies().front().part;
    EXPECT_THROW(distance_field(Part{}, 2), std::logic_error);
    EXPECT_THROW(distance_field(part, 0), std::logic_error);
    EXPECT_THROW(edge_field(part, {}, 2), std::logic_error);
    EXPECT_THROW(edge_field(part, {99}, 2), std::logic_error);
    EXPECT_THROW(point_field({}), std::logic_error);
}

}  // namespace abut::geometry::implicit_segments_test
