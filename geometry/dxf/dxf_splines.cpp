// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/dxf/dxf_splines.hpp"

#include <algorithm>

#include "geometry/curves/spline_shape.hpp"
#include "geometry/curves/spline_through.hpp"
#include "geometry/dxf/dxf_numbers.hpp"

namespace abut::geometry::dxf {

namespace {

/// Points as a record lists them: x and y by turns.
class PointList {
public:
    explicit PointList(int x_code) : x_code_(x_code) {}

    void take(const Group& group, Numbers& numbers) {
        if (group.code == x_code_) {
            if (!is_complete_) numbers.fail("its points lack coordinates");
            points.push_back({numbers.of(group), 0});
            is_complete_ = false;
        } else if (group.code == x_code_ + 10) {
            if (is_complete_)
                numbers.fail("its points lack coordinates");
            else
                points.back().y() = numbers.of(group);
            is_complete_ = true;
        }
    }
    void finish(Numbers& numbers) const {
        if (!is_complete_) numbers.fail("its points lack coordinates");
    }

    std::vector<Vec2> points;

private:
    int x_code_;
    bool is_complete_ = true;
};

struct SplineNumbers {
    bool closed = false;
    Nurbs nurbs;
    SplineThrough through;
};

/// A tangent of no length stands for none.
std::optional<Vec2> tangent(const Record& record, Numbers& numbers, int x_code) {
    if (!record.find(x_code)) return std::nullopt;
    const Vec2 direction = numbers.point(x_code);
    return direction == Vec2(0, 0) ? std::nullopt : std::optional(direction);
}

SplineNumbers numbers_of(const Record& record, Numbers& numbers) {
    constexpr int closed = 1, periodic = 2;
    SplineNumbers spline;
    PointList control(10), fit(11);
    for (const Group& group : record.groups) {
        if (group.code == 40) spline.nurbs.knots.push_back(numbers.of(group));
        if (group.code == 41) spline.nurbs.weights.push_back(numbers.of(group));
        control.take(group, numbers);
        fit.take(group, numbers);
    }
    control.finish(numbers);
    fit.finish(numbers);
    spline.closed = (record.integer(70, 0) & (closed | periodic)) != 0;
    spline.nurbs.degree = record.integer(71, 3);
    spline.nurbs.points = std::move(control.points);
    spline.through.points = std::move(fit.points);
    spline.through.closed = (record.integer(70, 0) & closed) != 0;
    spline.through.start_tangent = tangent(record, numbers, 12);
    spline.through.end_tangent = tangent(record, numbers, 13);
    return spline;
}

/// The first control points again, as many as the degree.
void repeat_first_points(Nurbs& nurbs) {
    const auto degree = static_cast<std::ptrdiff_t>(nurbs.degree);
    const std::vector<Vec2> points(nurbs.points.begin(), nurbs.points.begin() + degree);
    nurbs.points.insert(nurbs.points.end(), points.begin(), points.end());
    if (nurbs.weights.empty()) return;
    const std::vector<double> weights(nurbs.weights.begin(), nurbs.weights.begin() + degree);
    nurbs.weights.insert(nurbs.weights.end(), weights.begin(), weights.end());
}

/// Equal steps; clamped: the ends with full multiplicity.
std::vector<double> uniform_knots(std::size_t n_points, std::size_t degree, bool is_clamped) {
    std::vector<double> knots;
    for (std::size_t i = 0; i < n_points + degree + 1; ++i)
        knots.push_back(static_cast<double>(is_clamped ? std::clamp(i, degree, n_points) : i));
    return knots;
}

/// Some systems leave out what follows from the closed flag, others the knots.
void complete(Nurbs& nurbs, bool is_closed) {
    if (nurbs.degree < 1 || nurbs.degree > max_spline_degree) return;
    const auto degree = static_cast<std::size_t>(nurbs.degree);
    const std::size_t n = nurbs.points.size();
    const bool has_weights_that_fit = nurbs.weights.empty() || nurbs.weights.size() == n;
    if (n <= degree || !has_weights_that_fit) return;
    const bool has_no_knots = nurbs.knots.empty();
    const bool leaves_out_points = is_closed && (nurbs.knots.size() == n + 2 * degree + 1 ||
                                                 (has_no_knots && nurbs.points.front() != nurbs.points.back()));
    if (leaves_out_points) repeat_first_points(nurbs);
    if (has_no_knots) nurbs.knots = uniform_knots(nurbs.points.size(), degree, !leaves_out_points);
}

bool are_all_equal(const std::vector<Vec2>& points) {
    return std::all_of(points.begin(), points.end(), [&](const Vec2& p) { return p == points.front(); });
}

Outline outline_of(const Nurbs& nurbs) {
    if (std::string fault = spline_fault(nurbs); !fault.empty()) return {{}, false, std::move(fault)};
    Outline outline{nurbs_curves(nurbs), false, {}};
    if (nurbs.degree == 1)
        for (Curve& curve : outline.curves) curve = Segment{point(curve, 0), point(curve, 1)};
    outline.is_in_pieces = outline.curves.size() > 1;
    return outline;
}

}  // namespace

Outline read_spline(const Record& record) {
    Numbers numbers(record);
    SplineNumbers spline = numbers_of(record, numbers);
    if (!numbers.is_good()) return {{}, false, numbers.wrong()};
    const bool has_control_points = !spline.nurbs.points.empty();
    const std::vector<Vec2>& points = has_control_points ? spline.nurbs.points : spline.through.points;
    if (points.empty()) return {{}, false, "it has neither control points nor fit points"};
    if (are_all_equal(points)) return {{Segment{points.front(), points.front()}}, false, {}};
    if (has_control_points) {
        complete(spline.nurbs, spline.closed);
        return outline_of(spline.nurbs);
    }
    if (std::string fault = through_fault(spline.through); !fault.empty()) return {{}, false, std::move(fault)};
    return outline_of(spline_through(spline.through));
}

}  // namespace abut::geometry::dxf
