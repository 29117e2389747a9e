// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/spline_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace abut::geometry;
using std::numbers::pi;

constexpr double epsilon = 2.220446049250313e-16;

const SplineShape& shape_of(const Curve& curve) {
    return *std::get<Spline>(curve).shape;
}

/// Point at a knot parameter by the Cox-de Boor recursion, from its definition: the oracle.
struct Homogeneous {
    Vec2 q{0, 0};
    double w = 0;
};
double basis(const std::vector<double>& knots, std::size_t i, int degree, double u) {
    if (degree == 0) return knots[i] <= u && u < knots[i + 1] ? 1 : 0;
    const auto k = static_cast<std::size_t>(degree);
    double sum = 0;
    if (knots[i + k] > knots[i]) sum += (u - knots[i]) / (knots[i + k] - knots[i]) * basis(knots, i, degree - 1, u);
    if (knots[i + k + 1] > knots[i + 1])
        sum += (knots[i + k + 1] - u) / (knots[i + k + 1] - knots[i + 1]) * basis(knots, i + 1, degree - 1, u);
    return sum;
}
Vec2 cox_de_boor(const Nurbs& nurbs, double u) {
    Homogeneous sum;
    for (std::size_t i = 0; i < nurbs.points.size(); ++i) {
        const double b = basis(nurbs.knots, i, nurbs.degree, u) * (nurbs.weights.empty() ? 1 : nurbs.weights[i]);
        sum.q += b * nurbs.points[i];
        sum.w += b;
    }
    return sum.q / sum.w;
}

/// Random splines: degree 1 to 8, clamped or not, knots of random multiplicity up to the degree, with weights or without.
struct RandomSplines {
    std::mt19937 random;
    explicit RandomSplines(unsigned seed) : random(seed) {}
    double unit() { return std::uniform_real_distribution<double>(0, 1)(random); }

    std::vector<double> knots(int degree, std::size_t n_points, bool clamped, bool multiple) {
        std::vector<double> list{unit()};
        while (list.size() < n_points + static_cast<std::size_t>(degree) + 1) {
            const int times = multiple && unit() < 0.4 ? 1 + static_cast<int>(unit() * degree) : 1;
            const double next = list.back() + 0.2 + unit();
            for (int k = 0; k < times; ++k) list.push_back(next);
        }
        list.resize(n_points + static_cast<std::size_t>(degree) + 1);
        if (!clamped) return list;
        const auto n = static_cast<std::ptrdiff_t>(degree);
        std::fill(list.begin(), list.begin() + n + 1, list.front() - 1);
        std::fill(list.end() - n - 1, list.end(), list[list.size() - static_cast<std::size_t>(n) - 2] + 1);
        return list;
    }
    Nurbs operator()(int degree, bool clamped, bool multiple, bool weighted) {
        Nurbs nurbs;
        nurbs.degree = degree;
        const std::size_t n_points = static_cast<std::size_t>(degree) + 1 + static_cast<std::size_t>(unit() * 8);
        do nurbs.knots = knots(degree, n_points, clamped, multiple);
        while (!(nurbs.knots[static_cast<std::size_t>(degree)] < nurbs.knots[n_points]));
        for (std::size_t i = 0; i < n_points; ++i) nurbs.points.push_back({4 * unit() - 2, 4 * unit() - 2});
        for (std::size_t i = 0; weighted && i < n_points; ++i) nurbs.weights.push_back(0.2 + 2 * unit());
        return nurbs;
    }
};

/// The knot parameters at which the curves begin and end, in order: those where the tangent is found to turn. Degree 1 turns at
/// every knot; others where the multiplicity is the degree (random points are in no line).
std::vector<double> cuts(const Nurbs& nurbs) {
    const auto n = static_cast<std::size_t>(nurbs.degree);
    const double begin = nurbs.knots[n], end = nurbs.knots[nurbs.points.size()];
    std::vector<double> list{begin};
    for (std::size_t i = n + 1; nurbs.knots[i] < end; ++i) {
        const auto times = std::count(nurbs.knots.begin(), nurbs.knots.end(), nurbs.knots[i]);
        if (nurbs.knots[i] > list.back() && times >= nurbs.degree) list.push_back(nurbs.knots[i]);
    }
    list.push_back(end);
    return list;
}

/// A full circle of radius 1 about the origin: the square of nine points.
Nurbs circle() {
    const double w = std::sqrt(0.5);
    return {2,
            {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1},
            {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}},
            {1, w, 1, w, 1, w, 1, w, 1}};
}

/// Length by the chords of n, 2n and 4n equal steps, extrapolated twice: the error is of the sixth order where u is smooth.
double length_by_chords(const SplineShape& shape, double u0, double u1, int n) {
    const auto chords = [&](int pieces) {
        const auto at = [&](int k) { return evaluate(shape, u0 + (u1 - u0) * k / pieces)[0]; };
        double sum = 0;
        for (int k = 0; k < pieces; ++k) sum += (at(k + 1) - at(k)).norm();
        return sum;
    };
    const double a = chords(n), b = chords(2 * n), c = chords(4 * n);
    const double first = (4 * b - a) / 3, second = (4 * c - b) / 3;
    return (16 * second - first) / 15;
}
double length_by_chords(const SplineShape& shape, int n) {
    double sum = 0;
    for (std::size_t k = 0; k + 1 < shape.breaks.size(); ++k)
        sum += length_by_chords(shape, shape.breaks[k], shape.breaks[k + 1], n);
    return sum;
}

TEST(SplineShape, NurbsCircleIsACircle) {
    const std::vector<Curve> curves = nurbs_curves(circle());
    ASSERT_EQ(curves.size(), 1u);
    const SplineShape& shape = shape_of(curves[0]);
    EXPECT_EQ(shape.breaks, (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
    for (int k = 0; k <= 1000; ++k) {
        const auto [x, d, dd] = evaluate(shape, k / 1000.0);
        EXPECT_NEAR(x.norm(), 1, 1e-15);
        EXPECT_NEAR(x.dot(d) / d.norm(), 0, 1e-15);
        EXPECT_NEAR(cross(d, dd) / std::pow(d.norm(), 3), 1, 1e-14);
    }
    EXPECT_NEAR(length(shape, 0, 1), 2 * pi, 1e-14);
    EXPECT_EQ(evaluate(shape, 0)[0], evaluate(shape, 1)[0]);
    // at the breaks: where the circle is widest and highest, but for its end
    EXPECT_EQ(stationary_parameters(shape, 0), std::vector<double>{0.5});
    EXPECT_EQ(stationary_parameters(shape, 1), (std::vector<double>{0.25, 0.75}));
}

TEST(SplineShape, AgreesWithCoxDeBoor) {
    RandomSplines random(1);
    for (int degree = 1; degree <= 8; ++degree)
        for (int trial = 0; trial < 24; ++trial) {
            const Nurbs nurbs = random(degree, trial % 2 == 0, trial / 2 % 2 == 0, trial / 4 % 2 == 0);
            ASSERT_EQ(spline_fault(nurbs), "") << degree << " " << trial;
            const std::vector<Curve> curves = nurbs_curves(nurbs);
            const std::vector<double> ends = cuts(nurbs);
            ASSERT_EQ(curves.size() + 1, ends.size()) << degree << " " << trial;
            for (std::size_t c = 0; c < curves.size(); ++c)
                for (int k = 0; k < 16; ++k) {
                    const double t = (k + 0.5) / 16, u = ends[c] + t * (ends[c + 1] - ends[c]);
                    const Curve& curve = curves[c];
                    const Vec2 found = std::holds_alternative<Segment>(curve)
                                           ? Vec2(std::get<Segment>(curve).from +
                                                  t * (std::get<Segment>(curve).to - std::get<Segment>(curve).from))
                                           : evaluate(shape_of(curve), t)[0];
                    // points of size 2, knots up to 20, a few roundings each level on both sides
                    EXPECT_LE((found - cox_de_boor(nurbs, u)).norm(), 2e-14 * degree) << degree << " " << trial << " " << u;
                }
        }
}

/// Every span, every degree, with and without weights, near an end and between.
TEST(SplineShape, DerivativesAgainstDifferences) {
    RandomSplines random(2);
    const double h = 1e-4;  // of a span: central differences err by h^2 / 6 of a third derivative of the next ones, about 1e3
    for (int degree = 2; degree <= 8; ++degree)
        for (const bool weighted : {false, true}) {
            const std::vector<Curve> curves = nurbs_curves(random(degree, true, false, weighted));
            ASSERT_EQ(curves.size(), 1u);
            const SplineShape& shape = shape_of(curves[0]);
            for (std::size_t k = 0; k + 1 < shape.breaks.size(); ++k)
                for (const double s : {h, 0.3, 0.5, 0.8, 1 - 2 * h}) {
                    const double w = shape.breaks[k + 1] - shape.breaks[k], u = shape.breaks[k] + s * w;
                    const auto [x, d, dd] = evaluate(shape, u);
                    const auto left = evaluate(shape, u - h * w), right = evaluate(shape, u + h * w);
                    const double scale = (1 + w * w * dd.norm()) * 1e4 * h * h;
                    EXPECT_LE((w * d - (right[0] - left[0]) / (2 * h)).norm(), scale) << degree << " " << u;
                    EXPECT_LE((w * w * dd - w * (right[1] - left[1]) / (2 * h)).norm(), scale) << degree << " " << u;
                }
        }
}

/// Far from the origin the points are those at the origin but for the rounding of coordinates near 1e6 (1.2e-10), and
/// derivatives do not suffer more than the control points did.
TEST(SplineShape, KeepsPrecisionFarFromTheOrigin) {
    RandomSplines random(3);
    const Vec2 far(1e6, -2e6);
    for (int degree = 2; degree <= 8; ++degree) {
        Nurbs nurbs = random(degree, true, false, true);
        const Curve near = nurbs_curves(nurbs).front();
        for (Vec2& p : nurbs.points) p += far;
        const std::vector<Curve> moved = nurbs_curves(nurbs);
        ASSERT_EQ(moved.size(), 1u);
        const double ulp = 2.4e-10;
        for (int k = 0; k <= 200; ++k) {
            const auto a = evaluate(shape_of(near), k / 200.0), b = evaluate(shape_of(moved[0]), k / 200.0);
            EXPECT_LE((b[0] - far - a[0]).norm(), 2 * ulp) << degree;
            EXPECT_LE((b[1] - a[1]).norm(), 100 * degree * ulp) << degree;
        }
    }
}

/// The ends and the joints are control points of the spline, bit for bit, where the knots say so.
TEST(SplineShape, EndsAreControlPointsBitForBit) {
    RandomSplines random(4);
    for (int degree = 1; degree <= 8; ++degree)
        for (int trial = 0; trial < 20; ++trial) {
            const Nurbs nurbs = random(degree, true, true, trial % 2 == 0);
            const std::vector<Curve> curves = nurbs_curves(nurbs);
            EXPECT_EQ(point(curves.front(), 0), nurbs.points.front());
            EXPECT_EQ(point(curves.back(), 1), nurbs.points.back());
            for (std::size_t c = 0; c + 1 < curves.size(); ++c) EXPECT_EQ(point(curves[c], 1), point(curves[c + 1], 0));
        }
}

/// A clamped NURBS of one span is the Bezier curve of its points, bit for bit.
TEST(SplineShape, OneSpanIsTheBezierCurve) {
    RandomSplines random(5);
    for (int degree = 2; degree <= 8; ++degree) {
        Nurbs nurbs = random(degree, true, false, true);
        const auto n = static_cast<std::size_t>(degree) + 1;
        nurbs.points.resize(n);
        nurbs.weights.resize(n);
        nurbs.knots.assign(n, 2.0);
        nurbs.knots.insert(nurbs.knots.end(), n, 5.0);
        const Curve curve = nurbs_curves(nurbs).front(), bezier = bezier_curve(nurbs.points, nurbs.weights);
        const SplineShape &a = shape_of(curve), &b = shape_of(bezier);
        EXPECT_EQ(a.points, b.points);
        EXPECT_EQ(a.weights, b.weights);
        EXPECT_EQ(a.breaks, (std::vector<double>{0, 1}));
        EXPECT_TRUE(a.from_nurbs);
        EXPECT_FALSE(b.from_nurbs);
    }
}

/// A wrapped cubic: uniform knots, the first three points repeated at the end. One smooth closed curve.
TEST(SplineShape, ClosedSplinesReturnToTheirBeginning) {
    for (const bool weighted : {false, true}) {
        Nurbs nurbs;
        for (int k = 0; k < 12; ++k) nurbs.knots.push_back(k / 7.0);
        const std::vector<Vec2> ring{{1, 0.2}, {0.3, 1}, {-1.1, 0.6}, {-0.7, -0.8}, {0.6, -1}};
        for (std::size_t i = 0; i < 8; ++i) nurbs.points.push_back(ring[i % 5]);
        for (std::size_t i = 0; weighted && i < 8; ++i) nurbs.weights.push_back(1 + 0.3 * static_cast<double>(i % 5));
        ASSERT_EQ(spline_fault(nurbs), "");
        const std::vector<Curve> curves = nurbs_curves(nurbs);
        ASSERT_EQ(curves.size(), 1u);
        const auto begin = evaluate(shape_of(curves[0]), 0), end = evaluate(shape_of(curves[0]), 1);
        EXPECT_EQ(begin[0], end[0]);
        EXPECT_LE((begin[1] - end[1]).norm(), 1e-13 * begin[1].norm());
        EXPECT_LE((begin[2] - end[2]).norm(), 1e-12 * begin[2].norm());
    }
}

Nurbs with_interior_knots(int degree, std::vector<double> interior, std::vector<Vec2> points) {
    Nurbs nurbs{degree, std::vector<double>(static_cast<std::size_t>(degree) + 1, 0.0), std::move(points), {}};
    nurbs.knots.insert(nurbs.knots.end(), interior.begin(), interior.end());
    nurbs.knots.insert(nurbs.knots.end(), static_cast<std::size_t>(degree) + 1, 1.0);
    return nurbs;
}

TEST(SplineShape, CutAtCornersOnly) {
    // the legs at the double knot: straight on, almost (1e-9), a corner, straight back
    const auto pieces = [](const Vec2& after) {
        return nurbs_curves(with_interior_knots(2, {0.25, 0.25}, {{0, 1}, {-1, 0}, {0, 0}, after, {2, 2}}));
    };
    EXPECT_EQ(pieces({1, 0}).size(), 1u);
    EXPECT_EQ(pieces({3, 0}).size(), 1u);
    EXPECT_EQ(pieces({1, 1e-16}).size(), 1u);
    EXPECT_EQ(pieces({1, 1e-9}).size(), 2u);
    EXPECT_EQ(pieces({1, 1}).size(), 2u);
    EXPECT_EQ(pieces({-0.5, 0}).size(), 2u);
    EXPECT_EQ(shape_of(pieces({1, 0})[0]).breaks, (std::vector<double>{0, 0.25, 1}));
    EXPECT_EQ(shape_of(pieces({1, 1})[0]).breaks, (std::vector<double>{0, 1}));
}

TEST(SplineShape, FullMultiplicityLeavesAGap) {
    std::vector<Vec2> points{{0, 0}, {1, 1}, {2, 0}, {2.5, 0}, {3, 1}, {4, 0}};
    std::vector<Curve> curves = nurbs_curves(with_interior_knots(2, {0.5, 0.5, 0.5}, points));
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(point(curves[0], 1), points[2]);
    EXPECT_EQ(point(curves[1], 0), points[3]);
    points[3] = points[2];
    curves = nurbs_curves(with_interior_knots(2, {0.5, 0.5, 0.5}, points));
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(point(curves[0], 1), point(curves[1], 0));
    points[4] = {3, -1};  // straight on: the gap has closed and nothing is left to cut at
    EXPECT_EQ(nurbs_curves(with_interior_knots(2, {0.5, 0.5, 0.5}, points)).size(), 1u);
}

TEST(SplineShape, CutWhereItStandsStill) {
    // three equal points of a quadratic with simple knots: a span without length between two that stop there
    const Nurbs nurbs = with_interior_knots(2, {0.25, 0.5, 0.75}, {{0, 0}, {1, 1}, {1, 1}, {1, 1}, {2, 0}, {3, 0}});
    ASSERT_EQ(spline_fault(nurbs), "");
    const std::vector<Curve> curves = nurbs_curves(nurbs);
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(point(curves[0], 1), Vec2(1, 1));
    EXPECT_EQ(point(curves[1], 0), Vec2(1, 1));
    EXPECT_EQ(shape_of(curves[0]).breaks.size(), 2u);
    EXPECT_EQ(shape_of(curves[1]).breaks.size(), 3u);
}

TEST(SplineShape, PointsWithoutLengthBehindAGapJoinNothing) {
    // a gap, three equal points, then a span that begins there
    const Nurbs nurbs =
        with_interior_knots(2, {0.25, 0.25, 0.25, 0.5, 0.5}, {{0, 0}, {1, 1}, {2, 0}, {5, 5}, {5, 5}, {5, 5}, {6, 6}, {7, 5}});
    ASSERT_EQ(spline_fault(nurbs), "");
    const std::vector<Curve> curves = nurbs_curves(nurbs);
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(point(curves[0], 1), Vec2(2, 0));
    EXPECT_EQ(point(curves[1], 0), Vec2(5, 5));
}

/// Handles drawn in (control points on the ends) leave tangents that are limits: towards the first point that differs.
TEST(SplineShape, TangentsAtEndsThatStandStill) {
    for (const double noise : {0.0, 1e-16}) {
        const Curve curve = bezier_curve({{1, 2}, {1, 2 + noise}, {3, 3}, {5, 2 - noise}, {5, 2}}, {});
        const auto begin = evaluate(shape_of(curve), 0), end = evaluate(shape_of(curve), 1);
        EXPECT_LE((begin[1].normalized() - Vec2(2, 1).normalized()).norm(), 1e-14) << noise;
        EXPECT_LE((end[1].normalized() - Vec2(2, -1).normalized()).norm(), 1e-14) << noise;
        EXPECT_LT(begin[1].norm(), 1e-13);
        EXPECT_EQ(begin[0], Vec2(1, 2));
        EXPECT_EQ(end[0], Vec2(5, 2));
    }
    const Curve thrice = bezier_curve({{0, 0}, {0, 0}, {0, 0}, {3, 4}}, {1, 2, 3, 4});
    EXPECT_LE((evaluate(shape_of(thrice), 0)[1].normalized() - Vec2(0.6, 0.8)).norm(), 1e-14);
}

TEST(SplineShape, DegreeOneIsSegments) {
    const std::vector<Vec2> corners{{0, 0}, {1, 0}, {2, 0}, {2, 3}};
    const std::vector<Curve> plain = nurbs_curves(with_interior_knots(1, {0.3, 0.6}, corners));
    ASSERT_EQ(plain.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_TRUE(std::holds_alternative<Segment>(plain[i]));
        EXPECT_EQ(std::get<Segment>(plain[i]).from, corners[i]);
        EXPECT_EQ(std::get<Segment>(plain[i]).to, corners[i + 1]);
    }
    Nurbs weighted = with_interior_knots(1, {0.3, 0.6}, corners);
    weighted.weights = {1, 2, 1, 3};
    const std::vector<Curve> rational = nurbs_curves(weighted);
    ASSERT_EQ(rational.size(), 3u);
    for (const Curve& curve : rational) EXPECT_TRUE(std::holds_alternative<Spline>(curve));
    EXPECT_LE((evaluate(shape_of(rational[0]), 0.5)[0] - Vec2(2.0 / 3, 0)).norm(), 1e-15);
    weighted.weights = {2, 2, 2, 2};
    EXPECT_TRUE(std::holds_alternative<Segment>(nurbs_curves(weighted)[0]));
    EXPECT_TRUE(std::holds_alternative<Segment>(bezier_curve({{0, 0}, {1, 2}}, {3, 3})));
    EXPECT_TRUE(std::holds_alternative<Spline>(bezier_curve({{0, 0}, {1, 2}}, {3, 4})));
}

/// Scaled by powers of two everything is the same bit for bit: no length is compared with a number.
TEST(SplineShape, KnowsNoUnit) {
    RandomSplines random(13);
    for (int trial = 0; trial < 40; ++trial) {
        const Nurbs nurbs = random(2 + trial % 7, trial % 2 == 0, true, trial % 3 == 0);
        for (const int power : {-60, -20, 20, 60}) {
            Nurbs scaled = nurbs;
            for (Vec2& p : scaled.points) p *= std::ldexp(1, power);
            ASSERT_EQ(spline_fault(scaled), spline_fault(nurbs));
            const std::vector<Curve> a = nurbs_curves(nurbs), b = nurbs_curves(scaled);
            ASSERT_EQ(a.size(), b.size());
            for (std::size_t c = 0; c < a.size(); ++c) {
                for (const int axis : {0, 1})
                    EXPECT_EQ(stationary_parameters(shape_of(a[c]), axis), stationary_parameters(shape_of(b[c]), axis));
                EXPECT_EQ(std::ldexp(length(shape_of(a[c]), 0.1, 0.8), power), length(shape_of(b[c]), 0.1, 0.8));
            }
        }
    }
}

/// Equal weights are none, and a common factor changes nothing.
TEST(SplineShape, CommonFactorsOfWeightsDoNotMatter) {
    RandomSplines random(6);
    Nurbs nurbs = random(4, false, false, true);
    const Curve a = nurbs_curves(nurbs).front();
    for (double& w : nurbs.weights) w *= 8;
    const Curve b = nurbs_curves(nurbs).front();
    EXPECT_EQ(shape_of(a).points, shape_of(b).points);
    EXPECT_TRUE(shape_of(a).rational);
    nurbs.weights.assign(nurbs.weights.size(), 0.7);
    const Curve c = nurbs_curves(nurbs).front();
    EXPECT_FALSE(shape_of(c).rational);
    nurbs.weights.clear();
    EXPECT_EQ(shape_of(c).points, shape_of(nurbs_curves(nurbs).front()).points);
}

TEST(SplineShape, TransformsPointByPoint) {
    RandomSplines random(7);
    for (const bool mirror : {false, true}) {
        const Similarity map{0.6, -0.8, {3, -5}, 2.5, mirror};
        for (int degree = 2; degree <= 8; ++degree) {
            const Curve curve = nurbs_curves(random(degree, true, false, true)).front();
            const SplineShape image = transformed(shape_of(curve), map);
            const SplineShape affine = affine_image(shape_of(curve), {1, 2}, {-0.5, 0.7}, {4, 4});
            for (int k = 0; k <= 50; ++k) {
                const auto here = evaluate(shape_of(curve), k / 50.0), there = evaluate(image, k / 50.0);
                EXPECT_LE((there[0] - map(here[0])).norm(), 1e-14);
                EXPECT_LE((there[1] - map.turned(here[1])).norm(), 1e-14 * (10 + here[1].norm()) * degree);
                const Vec2 sheared = Vec2(4, 4) + here[0].x() * Vec2(1, 2) + here[0].y() * Vec2(-0.5, 0.7);
                EXPECT_LE((evaluate(affine, k / 50.0)[0] - sheared).norm(), 1e-14);
            }
            EXPECT_NEAR(length(image, 0.1, 0.9), 2.5 * length(shape_of(curve), 0.1, 0.9), 1e-13 * image.arc_length.back());
            EXPECT_NEAR(length(affine, 0, 1), length_by_chords(affine, 1000), 1e-6);
        }
    }
}

/// y = x^2 from x0 to x1: x/2 sqrt(1 + 4x^2) + asinh(2x)/4.
double parabola_length(double x0, double x1) {
    const auto primitive = [](double x) { return 0.5 * x * std::sqrt(1 + 4 * x * x) + 0.25 * std::asinh(2 * x); };
    return primitive(x1) - primitive(x0);
}

TEST(SplineShape, LengthOfTheParabola) {
    const Curve curve = bezier_curve({{-1, 1}, {1, -3}, {3, 9}}, {});
    const SplineShape& shape = shape_of(curve);
    for (int i = 0; i <= 20; ++i)
        for (int j = 0; j <= 20; ++j)
            EXPECT_NEAR(length(shape, i / 20.0, j / 20.0), parabola_length(-1 + i / 5.0, -1 + j / 5.0),
                        1e-14 * shape.arc_length[1]);
}

TEST(SplineShape, LengthOfCircularArcs) {
    const Curve curve = nurbs_curves(circle()).front();
    const SplineShape& shape = shape_of(curve);
    const auto angle = [&](double u) {
        const Vec2 x = evaluate(shape, u)[0];
        const double a = std::atan2(x.y(), x.x());
        return a < 0 || u == 1 ? a + 2 * pi : a;
    };
    for (int i = 0; i <= 30; ++i)
        for (int j = 0; j <= 30; ++j) {
            const double u = i / 30.0, v = j / 30.0;
            EXPECT_NEAR(length(shape, u, v), (v == 1 ? 2 * pi : angle(v)) - (u == 1 ? 2 * pi : angle(u)), 2e-14)
                << u << " " << v;
        }
}

/// The sum is that of its parts, and chords extrapolated twice (error of the sixth order) give the same on smooth spans.
TEST(SplineShape, LengthOfRandomSplines) {
    RandomSplines random(8);
    for (int trial = 0; trial < 24; ++trial) {
        const Curve curve = nurbs_curves(random(2 + trial % 7, trial % 2 == 0, false, trial % 3 == 0)).front();
        const SplineShape& shape = shape_of(curve);
        const double total = length(shape, 0, 1);
        EXPECT_NEAR(total, length_by_chords(shape, 1000), 1e-9 * total) << trial;
        for (int k = 0; k < 10; ++k) {
            const double u = random.unit(), v = random.unit();
            EXPECT_NEAR(length(shape, 0, u) + length(shape, u, v) + length(shape, v, 1), total, 4e-14 * total) << trial;
            EXPECT_EQ(length(shape, u, v), -length(shape, v, u));
        }
    }
}

/// Signs of the derivative where it can be told from zero; steps of a dense sampling.
struct SignChanges {
    std::vector<double> from, to;
};
SignChanges sign_changes(const SplineShape& shape, int axis, int n) {
    SignChanges found;
    double last = 0, last_sign = 0;
    for (int k = 0; k <= n; ++k) {
        const double u = static_cast<double>(k) / n, d = evaluate(shape, u)[1][axis];
        if (std::abs(d) < 1e-11) continue;
        const double s = std::copysign(1, d);
        if (s == -last_sign) {
            found.from.push_back(last);
            found.to.push_back(u);
        }
        last = u;
        last_sign = s;
    }
    return found;
}

/// Each change of sign between two samples has its parameter there, each parameter is stationary, and between two of them the
/// sign is one.
void check_stationary(const SplineShape& shape, int axis, int n, const std::string& which) {
    const std::vector<double> found = stationary_parameters(shape, axis);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end())) << which;
    const SignChanges changes = sign_changes(shape, axis, n);
    for (std::size_t i = 0; i < changes.from.size(); ++i) {
        const auto at = std::lower_bound(found.begin(), found.end(), changes.from[i] - 1e-14);
        EXPECT_TRUE(at != found.end() && *at <= changes.to[i] + 1e-14) << which << " lost one after " << changes.from[i];
    }
    for (const double u : found) {
        const auto [x, d, dd] = evaluate(shape, u);
        EXPECT_LE(std::abs(d[axis]), 1e-14 * (d.norm() + dd.norm()) * 16) << which << " at " << u;
        EXPECT_TRUE(u > 0 && u < 1);
    }
}

int n_checked_splines(unsigned seed, int trials) {
    RandomSplines random(seed);
    int n_curves = 0;
    for (int trial = 0; trial < trials; ++trial) {
        const Nurbs nurbs = random(2 + trial % 7, trial % 2 == 0, trial % 3 == 0, trial % 5 < 3);
        if (!spline_fault(nurbs).empty()) continue;
        for (const Curve& curve : nurbs_curves(nurbs)) {
            const auto* spline = std::get_if<Spline>(&curve);
            if (!spline) continue;
            ++n_curves;
            for (const int axis : {0, 1}) check_stationary(*spline->shape, axis, 200, std::to_string(trial));
        }
    }
    return n_curves;
}

TEST(SplineShape, StationaryParametersOfRandomSplines) {
    EXPECT_GT(n_checked_splines(9, 1000), 1000);
}

TEST(LongSplineShape, StationaryParametersOfRandomSplines) {
    EXPECT_GT(n_checked_splines(10, 10000), 10000);
}

TEST(SplineShape, StationaryParametersInClosedForm) {
    // y = x^2 over -1..3
    EXPECT_EQ(stationary_parameters(shape_of(bezier_curve({{-1, 1}, {1, -3}, {3, 9}}, {})), 1), std::vector<double>{0.25});
    EXPECT_TRUE(stationary_parameters(shape_of(bezier_curve({{-1, 1}, {1, -3}, {3, 9}}, {})), 0).empty());
    // y = T_4, the Chebyshev polynomial, on x = 2u - 1: extrema at x = -+ sqrt(1/2) and 0
    const Curve chebyshev = bezier_curve({{-1, 1}, {-0.5, -7}, {0, 11 + 2.0 / 3}, {0.5, -7}, {1, 1}}, {});
    const std::vector<double> found = stationary_parameters(shape_of(chebyshev), 1);
    ASSERT_EQ(found.size(), 3u);
    EXPECT_NEAR(found[0], 0.5 - std::sqrt(0.125), 4e-16);
    EXPECT_NEAR(found[1], 0.5, 4e-16);
    EXPECT_NEAR(found[2], 0.5 + std::sqrt(0.125), 4e-16);
}

TEST(SplineShape, ConstantCoordinatesHaveNoStationaryParameters) {
    const std::vector<Vec2> points{{0, 7}, {1, 7}, {3, 7}, {4, 7}};
    EXPECT_TRUE(stationary_parameters(shape_of(bezier_curve(points, {})), 1).empty());
    EXPECT_TRUE(stationary_parameters(shape_of(bezier_curve(points, {1, 2, 3, 4})), 1).empty());
    // turned to a line of any direction and back: constant but for rounding
    for (int k = 1; k < 30; ++k) {
        const double c = std::cos(k), s = std::sin(k);
        const SplineShape turned = transformed(shape_of(bezier_curve(points, {1, 2, 3, 4})), {c, s, {5, -9}, 1, false});
        const SplineShape back = transformed(turned, {c, -s, {-5, 9}, 1, false});
        EXPECT_TRUE(stationary_parameters(back, 1).empty()) << k;
    }
    // straight, then bent: the break is where it ceases to be constant
    const Curve bent = nurbs_curves(with_interior_knots(2, {0.5}, {{0, 0}, {1, 0}, {2, 0}, {3, 1}})).front();
    EXPECT_EQ(stationary_parameters(shape_of(bent), 1), std::vector<double>{0.5});
}

/// A quarter turn with tangents along the axes at its ends has none inside, wherever it stands.
TEST(SplineShape, TangentsAtTheEndsAreNotInside) {
    const double w = std::sqrt(0.5);
    for (int k = 0; k < 200; ++k) {
        const Vec2 at(0.1 * k - 7.3, std::sqrt(static_cast<double>(k)));
        const Curve quarter = bezier_curve({at + Vec2(1, 0), at + Vec2(1, 1), at + Vec2(0, 1)}, {1, w, 1});
        for (const int axis : {0, 1}) EXPECT_TRUE(stationary_parameters(shape_of(quarter), axis).empty()) << k;
    }
}

TEST(SplineShape, BezierFaults) {
    const double inf = std::numeric_limits<double>::infinity();
    EXPECT_EQ(bezier_fault({{0, 0}, {1, 1}, {2, 0}}, {}), "");
    EXPECT_EQ(bezier_fault({{0, 0}}, {}), "it has 1 points, possible are 2 to 9");
    EXPECT_EQ(bezier_fault(std::vector<Vec2>(10, {1, 1}), {}), "it has 10 points, possible are 2 to 9");
    EXPECT_EQ(bezier_fault({{0, 0}, {inf, 1}, {2, 0}}, {}), "points[1] is not finite");
    EXPECT_EQ(bezier_fault({{0, 0}, {1, 1}, {2, 0}}, {1, 2}), "it has 2 weights for 3 points");
    EXPECT_EQ(bezier_fault({{0, 0}, {1, 1}, {2, 0}}, {1, 0, 1}), "weights[1] is 0, weights must be positive");
    EXPECT_EQ(bezier_fault({{0, 0}, {1, 1}, {2, 0}}, {1, 1, -2}), "weights[2] is -2, weights must be positive");
    EXPECT_EQ(bezier_fault({{0, 0}, {1, 1}, {2, 0}}, {1, std::nan(""), 1}), "weights[1] is not finite");
    EXPECT_EQ(bezier_fault({{4, 3}, {4, 3}, {4, 3}}, {}), "all its points are equal");
}

TEST(SplineShape, CuspsAreFaults) {
    EXPECT_EQ(bezier_fault({{0, 0}, {1, 1}, {0, 1}, {1, 0}}, {}), "it has a cusp at parameter 0.5, cut it there");
    EXPECT_EQ(bezier_fault({{0, 0}, {1, 1.1}, {0, 1}, {1, 0}}, {}), "");
    EXPECT_EQ(bezier_fault({{0, 0}, {2, 0}, {0, 0}}, {}), "it has a cusp at parameter 0.5, cut it there");  // there and back
    EXPECT_EQ(bezier_fault({{0, 0}, {2, 3}, {0, 0}}, {1, 3, 1}), "it has a cusp at parameter 0.5, cut it there");
    // (t - 1/3)^3 in both directions: stands still and goes on
    std::vector<Vec2> line;
    for (const double y : {-1.0 / 27, 2.0 / 27, -4.0 / 27, 8.0 / 27}) line.push_back({y, 2 * y});
    EXPECT_EQ(bezier_fault(line, {}), "it has a cusp at parameter 0.333333, cut it there");
    // a span's inner cusp is found at its knot parameter, wherever the curve is turned to
    for (int k = 0; k < 40; ++k) {
        const double c = std::cos(k), s = std::sin(k);
        Nurbs nurbs = with_interior_knots(3, {0.5, 0.5, 0.5}, {{-2, 1}, {-1, 0}, {-1, -1}, {0, 0}, {1, 1}, {0, 1}, {1, 0}});
        for (Vec2& p : nurbs.points) p = Similarity{c, s, {3, 1}, 1, false}(p);
        EXPECT_EQ(spline_fault(nurbs), "it has a cusp at parameter 0.75, cut it there") << k;
    }
}

TEST(SplineShape, NurbsFaults) {
    const std::vector<Vec2> four{{0, 0}, {1, 1}, {2, 0}, {3, 1}};
    const auto fault = [](int degree, std::vector<double> knots, std::vector<Vec2> points, std::vector<double> weights = {}) {
        return spline_fault({degree, std::move(knots), std::move(points), std::move(weights)});
    };
    EXPECT_EQ(fault(3, {0, 0, 0, 0, 1, 1, 1, 1}, four), "");
    EXPECT_EQ(fault(0, {0, 1}, four), "its degree is 0, possible are 1 to 8");
    EXPECT_EQ(fault(9, {0, 1}, four), "its degree is 9, possible are 1 to 8");
    EXPECT_EQ(fault(3, {0, 0, 0, 0, 1, 1, 1}, four), "it has 7 knots, 4 points of degree 3 need 8");
    EXPECT_EQ(fault(4, {0, 0, 0, 0, 1, 1, 1, 1}, four), "it has 4 points, degree 4 needs at least 5");
    EXPECT_EQ(fault(2, {0, 0, 0, -1, 1, 1, 1}, four), "knots[3] is -1, less than the one before it (0)");
    EXPECT_EQ(fault(2, {0, 0, 0, std::nan(""), 1, 1, 1}, four), "knots[3] is not finite");
    EXPECT_EQ(fault(2, {0, 0, 0, 0, 1, 1, 1}, four), "knot 0 stands there 4 times, degree 2 allows 3");
    EXPECT_EQ(fault(2, {0, 1, 2, 2, 2, 3, 4}, four), "its parameter range is empty: knots[2] and knots[4] are both 2");
    EXPECT_EQ(fault(3, {0, 0, 0, 0, 1, 1, 1, 1}, four, {1, 1, 1}), "it has 3 weights for 4 points");
    EXPECT_EQ(fault(3, {0, 0, 0, 0, 1, 1, 1, 1}, four, {1, 1, -1, 1}), "weights[2] is -1, weights must be positive");
    EXPECT_EQ(fault(2, {0, 0, 0, 0.5, 1, 1, 1}, {{1, 1}, {1, 1}, {1, 1}, {1, 1}}), "all its points are equal");
    EXPECT_EQ(fault(1, {0, 0, 1, 1}, {{0, 0}, {std::nan(""), 0}}), "points[1] is not finite");
    // knots a rounding apart are one knot
    EXPECT_EQ(fault(2, {0, 0, 0, 1, 1, std::nextafter(1, 2), std::nextafter(1, 2)}, four),
              "knot 1 stands there 4 times, degree 2 allows 3");
}

TEST(SplineShapeChecks, NoticeAFault) {
    const Curve curve = nurbs_curves(circle()).front();
    SplineShape shape = shape_of(curve);
    shape.points[4] += Vec2(1e-13, 0);
    double worst = 0;
    for (int k = 0; k <= 1000; ++k) worst = std::max(worst, std::abs(evaluate(shape, k / 1000.0)[0].norm() - 1));
    EXPECT_GT(worst, 1e-15);
    RandomSplines random(12);
    Nurbs nurbs = random(3, false, false, true);
    const Curve right = nurbs_curves(nurbs).front();
    nurbs.knots[5] += 1e-9;
    EXPECT_GT((evaluate(shape_of(right), 0.5)[0] - evaluate(shape_of(nurbs_curves(nurbs).front()), 0.5)[0]).norm(), 1e-13);
}

}  // namespace
