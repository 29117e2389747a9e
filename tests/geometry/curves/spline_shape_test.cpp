// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/spline_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/geometry/curves/spline_samples.hpp"

namespace spline_shape_test {

namespace {

using namespace abut::geometry;
using namespace abut::geometry::test;
using std::numbers::pi;

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

}  // namespace spline_shape_test
