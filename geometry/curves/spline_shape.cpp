// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/spline_shape.hpp"

#include <algorithm>

#include "geometry/curves/bernstein.hpp"
#include "geometry/curves/spline_spans.hpp"

namespace abut::geometry {

namespace {

std::size_t n_spans(const SplineShape& shape) {
    return shape.breaks.size() - 1;
}

/// The span that u lies in; a break belongs to the span that begins there.
std::size_t span_at(const SplineShape& shape, double u) {
    const auto after = std::upper_bound(shape.breaks.begin() + 1, shape.breaks.end() - 1, u);
    return static_cast<std::size_t>(after - shape.breaks.begin()) - 1;
}

double width(const SplineShape& shape, std::size_t span) {
    return shape.breaks[span + 1] - shape.breaks[span];
}

double local(const SplineShape& shape, std::size_t span, double u) {
    return (u - shape.breaks[span]) / width(shape, span);
}

int sign(double value, double error) {
    return value > error ? 1 : value < -error ? -1 : 0;
}

/// Does the velocity change its sign, or begin or cease to be zero, from the end of one span to the beginning of the next?
bool turns_between(const Velocity& before, const Velocity& after) {
    return sign(before.coefficients.back(), before.errors.back()) != sign(after.coefficients.front(), after.errors.front());
}

}  // namespace

Curve bezier_curve(const std::vector<Vec2>& points, const std::vector<double>& weights) {
    return joined({bezier_knot_span(points, weights)}, false);
}

std::vector<Curve> nurbs_curves(const Nurbs& nurbs) {
    std::vector<Curve> curves;
    std::vector<KnotSpan> run;
    for (KnotSpan& span : knot_spans(nurbs)) {
        if (!run.empty() && (!span.smooth || nurbs.degree == 1)) {
            curves.push_back(joined(run, true));
            run.clear();
        }
        run.push_back(std::move(span));
    }
    if (!run.empty()) curves.push_back(joined(run, true));
    return curves;
}

std::array<Vec2, 3> evaluate(const SplineShape& shape, double u) {
    const std::size_t k = span_at(shape, u);
    const double rate = 1 / width(shape, k);
    std::array<Vec2, 3> values = evaluate(view(shape, k), local(shape, k, u));
    values[1] *= rate;
    values[2] *= rate * rate;
    return values;
}

double length(const SplineShape& shape, double u0, double u1) {
    if (u1 < u0) return -length(shape, u1, u0);
    const std::size_t first = span_at(shape, u0), last = span_at(shape, u1);
    const double s0 = local(shape, first, u0), s1 = local(shape, last, u1);
    if (first == last && s0 == 0 && s1 == 1) return shape.arc_length[last + 1] - shape.arc_length[first];
    if (first == last) return length(view(shape, first), s0, s1);
    const double head = s0 == 0 ? shape.arc_length[first + 1] - shape.arc_length[first] : length(view(shape, first), s0, 1);
    const double tail = s1 == 1 ? shape.arc_length[last + 1] - shape.arc_length[last] : length(view(shape, last), 0, s1);
    return head + (shape.arc_length[last] - shape.arc_length[first + 1]) + tail;
}

std::vector<double> stationary_parameters(const SplineShape& shape, int axis) {
    std::vector<double> found;
    Velocity before;
    for (std::size_t k = 0; k < n_spans(shape); ++k) {
        Velocity here = velocity(view(shape, k), axis);
        if (k > 0 && turns_between(before, here)) found.push_back(shape.breaks[k]);
        for (const double s : bernstein_roots(here.coefficients, here.errors))
            found.push_back(s == 1 ? shape.breaks[k + 1] : shape.breaks[k] + s * width(shape, k));
        before = std::move(here);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::erase_if(found, [](double u) { return u <= 0 || u >= 1; });
    return found;
}

SplineShape transformed(const SplineShape& shape, const Similarity& map) {
    SplineShape image = shape;
    for (Vec2& p : image.points) p = map(p);
    for (double& s : image.arc_length) s *= map.scale;
    return image;
}

SplineShape affine_image(const SplineShape& shape, const Vec2& x_axis, const Vec2& y_axis, const Vec2& origin) {
    SplineShape image = shape;
    for (Vec2& p : image.points) p = origin + p.x() * x_axis + p.y() * y_axis;
    measure(image);
    return image;
}

}  // namespace abut::geometry
