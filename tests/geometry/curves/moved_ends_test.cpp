// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/moved_ends.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/curves/spline_shape.hpp"

namespace abut::geometry::moved_ends_test {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

/// The largest distance of a curve's points from another curve.
double farthest(const Curve& curve, const Curve& other) {
    double largest = 0;
    for (int i = 0; i <= 100; ++i) {
        const Vec2 p = point(curve, i / 100.0);
        largest = std::max(largest, (point(other, closest_parameter(other, p)) - p).norm());
    }
    return largest;
}

Curve spline(double gap, bool is_rational, double begin, double end) {
    const std::vector<Vec2> points{{0, 0}, {4, -1}, {6, 3}, {2, 5}, {-2, 2}, {gap, gap / 2}};
    const std::vector<double> weights = is_rational ? std::vector<double>{1, 2, 0.5, 1, 3, 1} : std::vector<double>{};
    Spline whole = std::get<Spline>(nurbs_curves({3, {0, 0, 0, 0, 1, 2, 3, 3, 3, 3}, points, weights}).front());
    whole.begin = begin;
    whole.end = end;
    return whole;
}

/// Curves whose ends are well apart, near each other, and at one place.
std::vector<Curve> curves() {
    std::vector<Curve> all;
    for (const double missing : {3.0, 1.0, 1e-2, 1e-5, 1e-9}) {
        all.push_back(EllipticArc{{1, 2}, {3, 1}, {-0.5, 1.5}, 0.7, two_pi - missing});
        all.push_back(EllipticArc{{1, 2}, {3, 1}, {0.5, -1.5}, 0.7, missing - two_pi});
        for (const bool is_rational : {false, true}) {
            all.push_back(spline(missing, is_rational, 0, 1));
            all.push_back(spline(missing, is_rational, 1, 0));
            all.push_back(spline(missing, is_rational, 0.1, 0.85));
        }
    }
    return all;
}

}  // namespace

TEST(MovedEnds, ends_are_met_and_nothing_moves_much_more) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> angle(0, two_pi);
    for (const Curve& curve : curves())
        for (const double move : {1e-3, 1e-5, 1e-8})
            for (int i = 0; i < 5; ++i) {
                const double a = angle(random), b = angle(random);
                const Vec2 from = point(curve, 0) + move * Vec2(std::cos(a), std::sin(a));
                const Vec2 to = point(curve, 1) + move * Vec2(std::cos(b), std::sin(b));
                const Curve moved = with_moved_ends(curve, from, to);
                EXPECT_LT((point(moved, 0) - from).norm(), 1e-14 * 10);  // coordinates up to 10
                EXPECT_LT((point(moved, 1) - to).norm(), 1e-14 * 10);
                // Turned about one end by move / apart, apart being a tenth of the length at least: a point as far away as the
                // curve is long moves by twenty times the move at most.
                EXPECT_LT(farthest(moved, curve), 20 * move) << kind_name(curve) << " " << move;
                EXPECT_LT(farthest(curve, moved), 20 * move);
            }
}

TEST(MovedEnds, ends_at_one_place_close_the_curve) {
    for (const Curve& curve : curves()) {
        const double gap = (point(curve, 1) - point(curve, 0)).norm();
        if (gap > 0.1) continue;
        const Vec2 to = 0.5 * (point(curve, 0) + point(curve, 1));
        const Curve moved = with_moved_ends(curve, to, to);
        EXPECT_LT((point(moved, 0) - to).norm(), 1e-13);
        EXPECT_LT((point(moved, 1) - to).norm(), 1e-13);
        EXPECT_LE(farthest(curve, moved), 2 * gap + 1e-13);
        EXPECT_EQ(kind_name(moved), kind_name(curve)) << "an ellipse stays one";
    }
}

TEST(MovedEnds, well_apart_keeps_the_kind) {
    const Curve half = EllipticArc{{0, 0}, {3, 0}, {0, 2}, 0, std::numbers::pi};
    const Curve moved = with_moved_ends(half, {3.01, 0}, {-3, 0.01});
    EXPECT_EQ(kind_name(moved), "ellipse");
    EXPECT_LT((point(moved, 0) - Vec2(3.01, 0)).norm(), 1e-14);
    EXPECT_LT((point(moved, 1) - Vec2(-3, 0.01)).norm(), 1e-14);
}

}  // namespace abut::geometry::moved_ends_test
