// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with the numbers of a spline, as one line for the user.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "geometry/curves/bernstein.hpp"
#include "geometry/curves/numbers.hpp"
#include "geometry/curves/spline_spans.hpp"

namespace abut::geometry {

namespace {

template <class... Parts>
std::string text(const Parts&... parts) {
    std::ostringstream stream;
    (stream << ... << parts);
    return stream.str();
}

std::string points_fault(const std::vector<Vec2>& points) {
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!points[i].allFinite()) return text("points[", i, "] is not finite");
    return {};
}

std::string weights_fault(const std::vector<double>& weights, std::size_t n_points) {
    if (weights.empty()) return {};
    if (weights.size() != n_points) return text("it has ", weights.size(), " weights for ", n_points, " points");
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (!std::isfinite(weights[i])) return text("weights[", i, "] is not finite");
        if (!(weights[i] > 0)) return text("weights[", i, "] is ", weights[i], ", weights must be positive");
    }
    return {};
}

std::string order_fault(const std::vector<double>& knots) {
    for (std::size_t i = 0; i < knots.size(); ++i) {
        if (!std::isfinite(knots[i])) return text("knots[", i, "] is not finite");
        if (i > 0 && knots[i] < knots[i - 1])
            return text("knots[", i, "] is ", knots[i], ", less than the one before it (", knots[i - 1], ")");
    }
    return {};
}

std::string multiplicity_fault(const std::vector<double>& knots, int degree) {
    for (std::size_t i = 0, next = 0; i < knots.size(); i = next) {
        while (next < knots.size() && knots[next] == knots[i]) ++next;
        if (next - i > static_cast<std::size_t>(degree) + 1)
            return text("knot ", knots[i], " stands there ", next - i, " times, degree ", degree, " allows ", degree + 1);
    }
    return {};
}

std::string knots_fault(const Nurbs& nurbs) {
    const auto degree = static_cast<std::size_t>(nurbs.degree);
    const std::size_t n_points = nurbs.points.size(), needed = n_points + degree + 1;
    if (nurbs.knots.size() != needed)
        return text("it has ", nurbs.knots.size(), " knots, ", n_points, " points of degree ", degree, " need ", needed);
    if (const std::string fault = order_fault(nurbs.knots); !fault.empty()) return fault;
    const std::vector<double> knots = settled_knots(nurbs.knots);
    if (const std::string fault = multiplicity_fault(knots, nurbs.degree); !fault.empty()) return fault;
    if (!(knots[degree] < knots[n_points]))
        return text("its parameter range is empty: knots[", degree, "] and knots[", n_points, "] are both ", knots[degree]);
    return {};
}

/// Of the length of the control polygon (the mean speed, at most): where a curve slows down to this, it turns back within the
/// square of it, which is rounding.
const double cusp_fraction = std::sqrt(epsilon);

/// Inside a span only: where it stands still at an end, the spline is cut.
bool stands_still_inside(const BezierSpan& span, double s) {
    return s > 0 && s < 1 && evaluate(span, s)[1].norm() <= cusp_fraction * polygon_length(span.points);
}

/// Where both velocities may vanish: roots of one, or double roots, which are those of its derivative.
std::vector<double> slow_parameters(const BezierSpan& span) {
    std::vector<double> found;
    for (const int axis : {0, 1}) {
        const Velocity v = velocity(span, axis);
        std::vector<double> slope;
        for (std::size_t i = 0; i + 1 < v.coefficients.size(); ++i) slope.push_back(v.coefficients[i + 1] - v.coefficients[i]);
        for (const std::vector<double>& roots : {bernstein_roots(v.coefficients, v.errors), bernstein_roots(slope)})
            found.insert(found.end(), roots.begin(), roots.end());
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::string cusp_fault(const KnotSpan& span) {
    for (const double s : slow_parameters(view(span)))
        if (stands_still_inside(view(span), s))
            return text("it has a cusp at parameter ", span.begin + s * (span.end - span.begin), ", cut it there");
    return {};
}

std::string first_of(std::initializer_list<std::string> faults) {
    for (const std::string& fault : faults)
        if (!fault.empty()) return fault;
    return {};
}

std::string spans_fault(const std::vector<KnotSpan>& spans) {
    if (spans.empty()) return "all its points are equal";
    for (const KnotSpan& span : spans)
        if (const std::string fault = cusp_fault(span); !fault.empty()) return fault;
    return {};
}

}  // namespace

std::string spline_fault(const Nurbs& nurbs) {
    if (nurbs.degree < 1 || nurbs.degree > max_spline_degree)
        return text("its degree is ", nurbs.degree, ", possible are 1 to ", max_spline_degree);
    if (nurbs.points.size() <= static_cast<std::size_t>(nurbs.degree))
        return text("it has ", nurbs.points.size(), " points, degree ", nurbs.degree, " needs at least ", nurbs.degree + 1);
    const std::string fault =
        first_of({points_fault(nurbs.points), weights_fault(nurbs.weights, nurbs.points.size()), knots_fault(nurbs)});
    return fault.empty() ? spans_fault(knot_spans(nurbs)) : fault;
}

std::string bezier_fault(const std::vector<Vec2>& points, const std::vector<double>& weights) {
    if (points.size() < 2 || points.size() > max_spline_degree + 1)
        return text("it has ", points.size(), " points, possible are 2 to ", max_spline_degree + 1);
    const std::string fault = first_of({points_fault(points), weights_fault(weights, points.size())});
    if (!fault.empty()) return fault;
    const KnotSpan span = bezier_knot_span(points, weights);
    return span.points.empty() ? "all its points are equal" : cusp_fault(span);
}

}  // namespace abut::geometry
