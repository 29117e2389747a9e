// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/arc_spline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/curves/spline_shape.hpp"

namespace arc_spline_test {

namespace {

using namespace abut::geometry;
constexpr double pi = std::numbers::pi;

using Random = std::mt19937;

double uniform(Random& random, double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
}

EllipticArc random_ellipse(Random& random, double least_aspect) {
    const double angle = uniform(random, 0, 2 * pi), aspect = std::pow(least_aspect, uniform(random, 0, 1));
    const Vec2 a(std::cos(angle), std::sin(angle));
    const double sweep = uniform(random, 0, 1) < 0.3 ? 2 * pi : uniform(random, 0.1, 2 * pi);
    const double side = uniform(random, -1, 1) < 0 ? -1 : 1;
    return {{uniform(random, -5, 5), uniform(random, -5, 5)},
            a,
            side * aspect * left_of(a),
            uniform(random, -7, 7),
            uniform(random, -1, 1) < 0 ? -sweep : sweep};
}

Curve random_bezier(Random& random) {
    const int degree = 2 + static_cast<int>(uniform(random, 0, 6.999));
    std::vector<Vec2> points;
    std::vector<double> weights;
    for (int i = 0; i <= degree; ++i) {
        points.emplace_back(uniform(random, -1, 1), uniform(random, -1, 1));
        weights.push_back(uniform(random, 0.3, 3));
    }
    if (uniform(random, 0, 1) < 0.5) weights.clear();
    return bezier_curve(points, weights);
}

Curve random_nurbs(Random& random) {
    Nurbs nurbs;
    nurbs.degree = 2 + static_cast<int>(uniform(random, 0, 3));
    const int n = nurbs.degree + 2 + static_cast<int>(uniform(random, 0, 5));
    for (int i = 0; i < n; ++i) nurbs.points.emplace_back(uniform(random, -1, 1), uniform(random, -1, 1));
    for (int i = 0; i <= n + nurbs.degree; ++i) nurbs.knots.push_back(i + uniform(random, 0, 0.9));
    const Curve curve = nurbs_curves(nurbs)[0];
    if (uniform(random, 0, 1) < 0.5) return curve;
    return Spline{std::get<Spline>(curve).shape, uniform(random, 0.5, 1), uniform(random, 0, 0.4)};
}

Curve random_curve(Random& random) {
    const double kind = uniform(random, 0, 3);
    if (kind < 1) return random_ellipse(random, 1e-3);
    return kind < 2 ? random_bezier(random) : random_nurbs(random);
}

double distance(const Curve& curve, const Vec2& p) {
    return (point(curve, closest_parameter(curve, p)) - p).norm();
}

/// The largest distance found by samples, of the curve from its arc and of the arc from the curve.
double sampled_deviation(const Curve& curve, const ArcPiece& piece, int n) {
    double most = 0;
    for (int i = 0; i <= n; ++i) {
        const double s = i * 1.0 / n;
        most = std::max(most, distance(piece.curve, point(curve, piece.t0 + s * (piece.t1 - piece.t0))));
        most = std::max(most, distance(curve, point(piece.curve, s)));
    }
    return most;
}

/// Rounding of an arc's ends, which grows with its radius.
double end_rounding(const ArcPiece& piece, double size) {
    const auto* arc = std::get_if<Arc>(&piece.curve);
    return 1e-14 * (size + 1) + (arc ? 2e-15 * arc->radius : 0);
}

void expect_follows(const Curve& curve, double tolerance) {
    const double size = bounding_box(curve).diagonal();
    const std::vector<ArcPiece> pieces = arc_spline(curve, tolerance);
    ASSERT_FALSE(pieces.empty());
    double t = 0;
    for (const ArcPiece& piece : pieces) {
        EXPECT_EQ(piece.t0, t);
        ASSERT_LT(piece.t0, piece.t1);
        t = piece.t1;
        EXPECT_LE((point(piece.curve, 0) - point(curve, piece.t0)).norm(), end_rounding(piece, size));
        EXPECT_LE((point(piece.curve, 1) - point(curve, piece.t1)).norm(), end_rounding(piece, size));
        EXPECT_LE(sampled_deviation(curve, piece, 9), tolerance + end_rounding(piece, size)) << kind_name(curve);
    }
    EXPECT_EQ(t, 1);
}

void expect_joints(const Curve& curve, double tolerance) {
    const std::vector<ArcPiece> pieces = arc_spline(curve, tolerance);
    std::vector<double> needed = axis_extrema(curve);
    for (const double t : smoothness_breaks(curve)) needed.push_back(t);
    for (const double t : needed) {
        double nearest = 1;
        for (const ArcPiece& piece : pieces) nearest = std::min(nearest, std::abs(piece.t0 - t));
        EXPECT_LE(nearest, 1e-13) << kind_name(curve);
    }
}

/// The same circles and joints, backwards, bit for bit.
void expect_reversible(const Curve& curve, double tolerance) {
    const std::vector<ArcPiece> there = arc_spline(curve, tolerance), back = arc_spline(reversed(curve), tolerance);
    ASSERT_EQ(there.size(), back.size());
    for (std::size_t i = 0; i < there.size(); ++i) {
        const ArcPiece &a = there[i], &b = back[there.size() - 1 - i];
        EXPECT_NEAR(a.t0, 1 - b.t1, 1e-14);
        ASSERT_EQ(a.curve.index(), b.curve.index());
        if (const auto* arc = std::get_if<Arc>(&a.curve)) {
            EXPECT_EQ(arc->center, std::get<Arc>(b.curve).center);
            EXPECT_EQ(arc->radius, std::get<Arc>(b.curve).radius);
            EXPECT_NEAR(arc->sweep, -std::get<Arc>(b.curve).sweep, 0);
        } else {
            EXPECT_EQ(std::get<Segment>(a.curve).from, std::get<Segment>(b.curve).to);
            EXPECT_EQ(std::get<Segment>(a.curve).to, std::get<Segment>(b.curve).from);
        }
    }
}

void sweep(int n) {
    Random random(41);
    for (int k = 0; k < n; ++k) {
        const Curve curve = random_curve(random);
        const double tolerance = std::pow(10, uniform(random, -6, -1)) * bounding_box(curve).diagonal();
        expect_follows(curve, tolerance);
        expect_joints(curve, tolerance);
        expect_reversible(curve, tolerance);
    }
}

TEST(ArcSpline, FollowsRandomCurvesWithinTheTolerance) {
    sweep(25);
}

TEST(LongArcSpline, FollowsRandomCurvesWithinTheTolerance) {
    sweep(3000);
}

/// Ends may be written as start and sweep either way; the reverse of the reverse is the same once more.
TEST(ArcSpline, ReversesEllipsesWithAnyRoundingOfTheirEnds) {
    Random random(43);
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random_ellipse(random, 0.1);
        expect_reversible(curve, 1e-2);
        expect_reversible(reversed(curve), 1e-2);
    }
}

TEST(ArcSpline, LinesAndCirclesComeBackAsTheyAre) {
    for (const Curve& curve : {Curve(Segment{{0, 0}, {1, 2}}), Curve(Arc{{0, 0}, 1, 0.3, 6})}) {
        const std::vector<ArcPiece> pieces = arc_spline(curve, 1e-6);
        ASSERT_EQ(pieces.size(), 1u);
        EXPECT_EQ(point(pieces[0].curve, 0.3), point(curve, 0.3));
        EXPECT_EQ(pieces[0].t0, 0);
        EXPECT_EQ(pieces[0].t1, 1);
    }
}

/// A circle in disguise needs no more than its quarters, a straight spline none but segments.
TEST(ArcSpline, RecognisesCirclesAndLines) {
    const double w = std::sqrt(0.5);
    const Curve quarter = bezier_curve({{1, 0}, {1, 1}, {0, 1}}, {1, w, 1});
    const std::vector<ArcPiece> arcs = arc_spline(quarter, 1e-12);
    ASSERT_EQ(arcs.size(), 1u);
    EXPECT_NEAR(std::get<Arc>(arcs[0].curve).radius, 1, 1e-14);
    EXPECT_EQ(arc_spline(EllipticArc{{0, 0}, {0, 2}, {-2, 0}, 0, 2 * pi}, 1e-12).size(), 4u);
    const std::vector<ArcPiece> line = arc_spline(bezier_curve({{0, 0}, {1, 0.5}, {2, 1}, {4, 2}}, {}), 1e-12);
    ASSERT_EQ(line.size(), 1u);
    EXPECT_TRUE(std::holds_alternative<Segment>(line[0].curve));
}

/// Deviation of third order: a thousandth of the tolerance costs nearly ten times the pieces. Few of them: an ellipse's optimum
/// at 1e-6 of its size is 89, of equal deviations (integral of (curvature's derivative / 124.7 tolerance)^(1/3)). At large
/// tolerances the kinks decide.
TEST(ArcSpline, NumberOfPieces) {
    const Curve ellipse = EllipticArc{{0, 0}, {1, 0}, {0, 0.5}, 0.3, 2 * pi};
    const double size = bounding_box(ellipse).diagonal();
    const double n3 = static_cast<double>(arc_spline(ellipse, 1e-3 * size).size());
    const double n6 = static_cast<double>(arc_spline(ellipse, arc_spline_fraction * size).size());
    const double n9 = static_cast<double>(arc_spline(ellipse, 1e-9 * size).size());
    EXPECT_LE(n6, 120);
    EXPECT_GE(n6, 60);
    EXPECT_NEAR(n9 / n6, 9, 1);
    EXPECT_LE(n3, n6);
}

TEST(ArcSpline, TangentsNearlyMeet) {
    Random random(47);
    for (int k = 0; k < 20; ++k) {
        const Curve curve = random_curve(random);
        const std::vector<ArcPiece> pieces = arc_spline(curve, 1e-4 * bounding_box(curve).diagonal());
        for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
            EXPECT_LT(std::abs(cross(unit_tangent(pieces[i].curve, 1), unit_tangent(pieces[i + 1].curve, 0))), most_arc_kink);
    }
}

/// Sizes from 1e-6 to 1e6, moved far from the origin: the same number of pieces within the same fraction.
TEST(ArcSpline, DoesNotDependOnTheUnit) {
    Random random(53);
    for (int k = 0; k < 6; ++k) {
        const Curve curve = random_curve(random);
        const double tolerance = 1e-4 * bounding_box(curve).diagonal();
        const std::size_t n = arc_spline(curve, tolerance).size();
        for (double scale : {0x1p-20, 0x1p-6, 0x1p20}) {
            const Curve scaled = transformed(curve, Similarity{1, 0, {0, 0}, scale});
            EXPECT_EQ(arc_spline(scaled, scale * tolerance).size(), n);
        }
        expect_follows(transformed(curve, Similarity{0.6, 0.8, {100, -100}}), tolerance);
    }
}

/// Where both portions are, the circles are the same bit for bit: shared stretches coincide.
TEST(ArcSpline, PortionsShareTheirCircles) {
    Random random(59);
    const Curve whole = random_nurbs(random);
    const auto& shape = std::get<Spline>(whole).shape;
    const double tolerance = 1e-6;
    const std::vector<ArcPiece> a = arc_spline(Spline{shape, 0.1, 0.8}, tolerance);
    const std::vector<ArcPiece> b = arc_spline(Spline{shape, 0.95, 0.3}, tolerance);
    std::size_t inside = 0, shared = 0;
    for (const ArcPiece& p : a) {
        if (0.1 + 0.7 * p.t0 < 0.3) continue;
        ++inside;
        const auto same = [&](const ArcPiece& q) {
            const auto *x = std::get_if<Arc>(&p.curve), *y = std::get_if<Arc>(&q.curve);
            return x && y && x->center == y->center && x->radius == y->radius;
        };
        shared += static_cast<std::size_t>(std::count_if(b.begin(), b.end(), same));
    }
    EXPECT_GT(inside, 20u);
    EXPECT_GE(shared + 3, inside);
}

}  // namespace

}  // namespace arc_spline_test
