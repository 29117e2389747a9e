// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_winding.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abut::geometry {

namespace {

/// Signed angle by which the tangent turns along the curve.
double signed_turning(const Curve& curve) {
    if (std::holds_alternative<Segment>(curve)) return 0;
    if (const auto* arc = std::get_if<Arc>(&curve)) return arc->sweep;
    // Steps short enough that none turns by more than half a turn: the turning of all is spread over the monotone pieces, of
    // which each turns by a quarter at most but for inflections.
    constexpr int steps_per_piece = 16;
    std::vector<double> marks = axis_extrema(curve);
    const std::vector<double> breaks = smoothness_breaks(curve);
    marks.insert(marks.end(), breaks.begin(), breaks.end());
    marks.push_back(0);
    marks.push_back(1);
    std::sort(marks.begin(), marks.end());
    double sum = 0;
    Vec2 before = unit_tangent(curve, 0);
    for (std::size_t i = 0; i + 1 < marks.size(); ++i)
        for (int k = 1; k <= steps_per_piece; ++k) {
            const Vec2 here = unit_tangent(curve, marks[i] + (marks[i + 1] - marks[i]) * k / steps_per_piece);
            sum += angle_between(before, here);
            before = here;
        }
    return sum;
}

}  // namespace

std::optional<int> turning_number(const std::vector<Edge>& chain) {
    constexpr double cusp_angle = 1e-3;  // this close to a half turn, tangents of joined curves do not tell its sense
    double sum = 0;
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const Curve& next = chain[(i + 1) % chain.size()].curve;
        const double corner = angle_between(unit_tangent(chain[i].curve, 1), unit_tangent(next, 0));
        if (std::abs(corner) > std::numbers::pi - cusp_angle) return std::nullopt;
        sum += signed_turning(chain[i].curve) + corner;
    }
    return static_cast<int>(std::lround(sum / (2 * std::numbers::pi)));
}

}  // namespace abut::geometry
