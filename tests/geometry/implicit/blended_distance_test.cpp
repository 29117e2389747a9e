// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/implicit/blended_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "geometry/implicit/cardinal_spline.hpp"
#include "tests/geometry/implicit/field_checks.hpp"

namespace abut::geometry::blended_distance_test {

namespace {

double size_of(const Part& part) {
    return bounding_box(part).diagonal();
}

std::vector<BlendedDistance> settings(const Part& part) {
    const double delta = strip_width(part);
    return {{}, {delta, 2, 0.3 * delta, 2, 2}, {0.5 * delta, 4, 5 * delta, 4, 3}, {delta, 1, delta, 1, 1}};
}

}  // namespace

TEST(CardinalSplines, ArePartitionsOfUnityWithTheirDerivatives) {
    for (int degree = 1; degree <= max_cardinal_degree; ++degree)
        for (double x = -3.03; x < 4; x += 0.17) {
            const CardinalValues at = cardinal_splines(degree, x);
            EXPECT_NEAR(std::accumulate(at.value.begin(), at.value.end(), 0.0), 1, 1e-14);
            EXPECT_NEAR(std::accumulate(at.slope.begin(), at.slope.end(), 0.0), 0, 1e-14);
            EXPECT_NEAR(std::accumulate(at.bend.begin(), at.bend.end(), 0.0), 0, 1e-14);
            const double h = 1e-6;
            const CardinalValues plus = cardinal_splines(degree, x + h), minus = cardinal_splines(degree, x - h);
            for (std::size_t i = 0; i <= static_cast<std::size_t>(degree); ++i) {
                EXPECT_GE(at.value[i], 0);
                EXPECT_NEAR((plus.value[i] - minus.value[i]) / (2 * h), at.slope[i], 1e-9);
                EXPECT_NEAR((plus.slope[i] - minus.slope[i]) / (2 * h), at.bend[i], 1e-9);
            }
        }
}

TEST(CardinalSplines, AreTheCubicOfTheTextbooks) {
    const CardinalValues at = cardinal_splines(3, 7.0);
    EXPECT_EQ(at.first, 4);
    EXPECT_NEAR(at.value[0], 1.0 / 6, 1e-16);
    EXPECT_NEAR(at.value[1], 4.0 / 6, 1e-16);
    EXPECT_NEAR(at.value[2], 1.0 / 6, 1e-16);
    EXPECT_NEAR(at.bend[1], -2, 1e-15);
}

TEST(BlendedDistance, VanishesOnTheEdgesWithUnitNormalDerivative) {
    for (const NamedBody& each : all_bodies())
        for (const BlendedDistance& options : settings(each.part)) {
            const ImplicitField field = blended_distance(each.part, options);
            for (const Edge& edge : each.part.edges)
                for (const double t : {0.13, 0.5, 0.81}) {
                    const FieldValue w = evaluate(field, point(edge.curve, t));
                    EXPECT_LE(std::abs(w.value), 1e-14 * size_of(each.part)) << each.name << " " << edge.name;
                    EXPECT_LE((w.gradient + outward_normal(edge.curve, t)).norm(), 1e-9) << each.name << " " << edge.name;
                }
        }
}

TEST(BlendedDistance, OfSomeEdgesKnowsNoOthers) {
    for (const NamedBody& each : all_bodies()) {
        if (each.part.edges.size() < 2) continue;
        const ImplicitField field = blended_edge_distance(each.part, {0});
        for (std::size_t e = 0; e < each.part.edges.size(); ++e)
            for (const double t : {0.13, 0.5, 0.81}) {
                const FieldValue w = evaluate(field, point(each.part.edges[e].curve, t));
                if (e > 0) {
                    EXPECT_GT(w.value, 1e-6 * size_of(each.part)) << each.name << " " << each.part.edges[e].name;
                    continue;
                }
                EXPECT_LE(std::abs(w.value), 1e-14 * size_of(each.part)) << each.name;
                EXPECT_LE((w.gradient + outward_normal(each.part.edges[e].curve, t)).norm(), 1e-9) << each.name;
            }
        // positive on both sides
        const Vec2 at = point(each.part.edges[0].curve, 0.5), n = outward_normal(each.part.edges[0].curve, 0.5);
        for (const double side : {1e-3, -1e-3}) EXPECT_GT(value(field, at + side * size_of(each.part) * n), 0) << each.name;
        EXPECT_THROW(blended_edge_distance(each.part, {}), std::logic_error);
        EXPECT_THROW(blended_edge_distance(each.part, {-1}), std::logic_error);
    }
}

TEST(BlendedDistance, HasTheSignOfMembershipAndIsFlatAwayFromTheBoundary) {
    for (const NamedBody& each : all_bodies()) {
        int n_flat = 0;
        for (const BlendedDistance& options : settings(each.part)) {
            const ImplicitField field = blended_distance(each.part, options);
            const double delta = options.delta == 0 ? strip_width(each.part) : options.delta, flat = delta / options.gamma;
            PointsAround points(each.part, 31);
            for (int i = 0; i < 200; ++i) {
                const Vec2 p = points();
                const double w = value(field, p), distance = true_distance(each.part, p);
                EXPECT_EQ(w > 0, contains(each.part, p)) << each.name << " at " << p.transpose();
                // the join of n edges is at most n^(1/m) smaller than the distance
                const double n = static_cast<double>(each.part.edges.size());
                if (distance > delta * std::pow(n, 1.0 / options.m)) {
                    ++n_flat;
                    EXPECT_NEAR(std::abs(w), flat, 1e-14 * flat);
                    EXPECT_LE(evaluate(field, p).gradient.norm(), 1e-12);
                }
                EXPECT_LE(std::abs(w), flat * (1 + 1e-14));
                EXPECT_GE(std::abs(w), 0.1 * std::min(flat, distance)) << each.name << " at " << p.transpose();
            }
        }
        EXPECT_GT(n_flat, 20) << each.name;
        EXPECT_NEAR(value(blended_distance(each.part), {-1e15, 3e200}), -strip_width(each.part) / 3, 1e-14);
    }
}

TEST(BlendedDistance, OfOneCircleIsTheCutOffDistance) {
    const double r = 2, delta = 0.8;
    const Part disc = body({{Arc{{1, 1}, r, 0.3, 2 * std::numbers::pi}}});
    for (int gamma = 1; gamma <= 4; ++gamma) {
        const ImplicitField field = blended_distance(disc, {delta, gamma, 0.5, 3, 2});
        for (double d = 0.05; d < r; d += 0.1) {
            const Vec2 p = Vec2(1, 1) + (r - d) * Vec2(std::cos(d), std::sin(d));
            const double expected = 1 - std::pow(std::max(0.0, 1 - d / delta), gamma);
            EXPECT_NEAR(value(field, p), delta / gamma * expected, 1e-14);
        }
    }
}

TEST(BlendedDistance, GradientAndHessianAgreeWithDifferences) {
    for (const NamedBody& each : all_bodies()) {
        const double size = size_of(each.part), delta = strip_width(each.part);
        const ImplicitField field = blended_distance(each.part, {delta, 5, 0, 5, 2});
        for (const double t : {0.0, 0.5}) EXPECT_EQ(evaluate(field, {t, t}).value, value(field, {t, t}));
        PointsAround points(each.part, 32);
        const auto in_strip = [&]() {
            Vec2 p = points();
            while (true_distance(each.part, p) > delta) p = points();
            return p;
        };
        expect_derivatives([&](const Vec2& q) { return evaluate(field, q); }, in_strip, 150, size, each.name);
    }
}

TEST(StripWidth, IsHalfTheSmallestRadius) {
    const Part slot = round_bodies()[1].part;
    EXPECT_NEAR(strip_width(slot), 0.25, 1e-15);
    const Part ell = round_bodies()[0].part;
    EXPECT_NEAR(strip_width(ell), widest_strip_fraction * std::hypot(3, 3), 1e-15);
    // b^2 / a at the ends of the longer axis
    const Part ellipse = body({{EllipticArc{{0, 0}, {4, 0}, {0, 1}, 0.3, 2 * std::numbers::pi}}});
    EXPECT_NEAR(strip_width(ellipse), 0.5 / 4, 1e-12);
}

TEST(BlendedDistance, RefusesNumbersOutsideTheirRanges) {
    const Part part = round_bodies()[0].part;
    EXPECT_THROW(blended_distance(Part{}), std::logic_error);
    EXPECT_THROW(blended_distance(part, {-1, 3, 0, 3, 2}), std::logic_error);
    EXPECT_THROW(blended_distance(part, {0, 0, 0, 3, 2}), std::logic_error);
    EXPECT_THROW(blended_distance(part, {0, 3, std::nan(""), 3, 2}), std::logic_error);
    EXPECT_THROW(blended_distance(part, {0, 3, 0, 9, 2}), std::logic_error);
    EXPECT_THROW(blended_distance(part, {0, 3, 0, 3, 0}), std::logic_error);
}

}  // namespace abut::geometry::blended_distance_test
