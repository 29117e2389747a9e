// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/spline_spans.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/curves/numbers.hpp"

namespace abut::geometry {

namespace {

/// Legs of the control polygon on both sides of a joint count as parallel if moves of the control points by this fraction of
/// the largest coordinate make them so: files are written with 12 digits and more.
constexpr double tangent_rounding = 1e-12;

double largest_coordinate(const std::vector<Vec2>& points) {
    double largest = 0;
    for (const Vec2& p : points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    return largest;
}

/// Control point i of the Bezier span [knots[j], knots[j + 1]]: the polar form at n - i times its beginning and i times its
/// end. Coordinates are relative to the spline's point in the same place, so that points that knots of full multiplicity
/// single out come out bit for bit.
Vec2 polar_point(const Nurbs& nurbs, const std::vector<double>& knots, const std::vector<double>& weights, std::size_t j,
                 std::size_t i, double& weight) {
    const auto n = static_cast<std::size_t>(nurbs.degree);
    const Vec2 base = nurbs.points[j - n + i];
    std::array<Vec2, max_spline_degree + 1> q;
    std::array<double, max_spline_degree + 1> w;
    for (std::size_t m = 0; m <= n; ++m) {
        w[m] = weights.empty() ? 1 : weights[j - n + m];
        q[m] = w[m] * (nurbs.points[j - n + m] - base);
    }
    for (std::size_t r = 1; r <= n; ++r) {
        const double argument = r <= i ? knots[j + 1] : knots[j];
        for (std::size_t m = n; m >= r; --m) {
            const double low = knots[j - n + m], high = knots[j + m + 1 - r], a = (argument - low) / (high - low);
            q[m] = (1 - a) * q[m - 1] + a * q[m];
            w[m] = (1 - a) * w[m - 1] + a * w[m];
        }
    }
    weight = w[n];
    return base + q[n] / (weights.empty() ? 1 : w[n]);
}

KnotSpan extracted(const Nurbs& nurbs, const std::vector<double>& knots, const std::vector<double>& weights, std::size_t j) {
    KnotSpan span{{}, {}, knots[j], knots[j + 1]};
    for (std::size_t i = 0; i <= static_cast<std::size_t>(nurbs.degree); ++i) {
        double weight = 1;
        span.points.push_back(polar_point(nurbs, knots, weights, j, i, weight));
        if (!weights.empty()) span.weights.push_back(weight);
    }
    return span;
}

/// Points a rounding away from the end before (after) them would give it a tangent of noise. False if nothing is left.
bool settle_ends(std::vector<Vec2>& points) {
    const double rounding = rounding_length(points);
    std::size_t first = 1, last = points.size() - 1;
    while (first < points.size() && (points[first] - points[0]).norm() <= rounding) points[first++] = points[0];
    while (last > 0 && (points[last - 1] - points.back()).norm() <= rounding) points[--last] = points.back();
    return first < points.size();
}

bool stands_still_between(const KnotSpan& before, const KnotSpan& after) {
    return before.points[before.points.size() - 2] == before.points.back() || after.points[0] == after.points[1];
}

bool parallel_at_joint(const KnotSpan& before, const KnotSpan& after) {
    const Vec2 u = before.points.back() - before.points[before.points.size() - 2], v = after.points[1] - after.points[0];
    const double move = tangent_rounding * std::max(largest_coordinate(before.points), largest_coordinate(after.points));
    return u.dot(v) > 0 && std::abs(cross(u, v)) <= move * (u.norm() + v.norm());
}

/// Lets the span begin at the end of the one before it, unless its first knot has full multiplicity and there is a gap.
void join(const Vec2& end, KnotSpan& span, std::size_t multiplicity) {
    const double rounding = std::max(rounding_length(span.points), rounding_length({&end, 1}));
    if (multiplicity >= span.points.size() && (span.points.front() - end).norm() > rounding) return;
    span.points.front() = end;
}

void close(std::vector<KnotSpan>& spans) {
    if (spans.empty()) return;
    const Vec2 start = spans.front().points.front();
    std::vector<Vec2>& points = spans.back().points;
    const double rounding = std::max(rounding_length(spans.front().points), rounding_length(points));
    if ((points.back() - start).norm() > rounding) return;
    points.back() = start;
    settle_ends(points);
}

/// Degree and knots alone make the tangent continuous at knots of smaller multiplicity, unless the spline stands still there.
bool continues(const KnotSpan& before, const KnotSpan& after, std::size_t multiplicity) {
    return after.points.front() == before.points.back() && !stands_still_between(before, after) &&
           (multiplicity + 1 < after.points.size() || parallel_at_joint(before, after));
}

}  // namespace

std::vector<double> settled_knots(std::vector<double> knots) {
    const double largest = std::max(std::abs(knots.front()), std::abs(knots.back()));
    const double rounding = 2 * epsilon * largest;
    for (std::size_t i = 1; i < knots.size(); ++i)
        if (knots[i] > knots[i - 1] && knots[i] - knots[i - 1] <= rounding) knots[i] = knots[i - 1];
    return knots;
}

std::vector<double> effective_weights(const std::vector<double>& weights) {
    const bool equal = std::adjacent_find(weights.begin(), weights.end(), std::not_equal_to<>()) == weights.end();
    return equal ? std::vector<double>{} : weights;
}

std::vector<KnotSpan> knot_spans(const Nurbs& nurbs) {
    const std::vector<double> knots = settled_knots(nurbs.knots), weights = effective_weights(nurbs.weights);
    const auto degree = static_cast<std::size_t>(nurbs.degree);
    std::vector<KnotSpan> spans;
    std::size_t last = 0;  // knot interval of the span before, and where it ends
    Vec2 end = Vec2::Zero();
    bool was_dropped = true;
    for (std::size_t j = degree; j < nurbs.points.size(); ++j) {
        if (!(knots[j] < knots[j + 1])) continue;
        KnotSpan span = extracted(nurbs, knots, weights, j);
        const std::size_t multiplicity = last == 0 ? 0 : j - last;
        if (last != 0) join(end, span, multiplicity);
        const bool has_length = settle_ends(span.points);
        end = has_length ? span.points.back() : span.points.front();
        span.smooth = has_length && !was_dropped && continues(spans.back(), span, multiplicity);
        if (has_length) spans.push_back(std::move(span));
        was_dropped = !has_length;
        last = j;
    }
    close(spans);
    return spans;
}

KnotSpan bezier_knot_span(const std::vector<Vec2>& points, const std::vector<double>& weights) {
    KnotSpan span{points, effective_weights(weights), 0, 1};
    if (!settle_ends(span.points)) span.points.clear();
    return span;
}

BezierSpan view(const KnotSpan& span) {
    return {span.points, span.weights};
}

BezierSpan view(const SplineShape& shape, std::size_t span) {
    const auto n = static_cast<std::size_t>(shape.degree) + 1;
    BezierSpan result{{shape.points.data() + span * n, n}, {}};
    if (shape.rational) result.weights = {shape.weights.data() + span * n, n};
    return result;
}

void measure(SplineShape& shape) {
    shape.arc_length.assign(1, 0.0);
    for (std::size_t k = 0; k + 1 < shape.breaks.size(); ++k)
        shape.arc_length.push_back(shape.arc_length.back() + length(view(shape, k), 0, 1));
}

Curve joined(const std::vector<KnotSpan>& run, bool from_nurbs) {
    const KnotSpan& first = run.front();
    if (run.size() == 1 && first.points.size() == 2 && first.weights.empty()) return Segment{first.points[0], first.points[1]};
    SplineShape shape;
    shape.degree = static_cast<int>(first.points.size()) - 1;
    shape.rational = !first.weights.empty();
    shape.from_nurbs = from_nurbs;
    const double range = run.back().end - first.begin;
    for (const KnotSpan& span : run) {
        shape.breaks.push_back((span.begin - first.begin) / range);
        shape.points.insert(shape.points.end(), span.points.begin(), span.points.end());
        shape.weights.insert(shape.weights.end(), span.weights.begin(), span.weights.end());
    }
    shape.breaks.push_back(1);
    shape.weights.resize(shape.points.size(), 1.0);
    measure(shape);
    return Spline{std::make_shared<const SplineShape>(std::move(shape)), 0, 1};
}

}  // namespace abut::geometry
