// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/implicit/curve_distance.hpp"

#include <cmath>

namespace abut::geometry {

namespace {

struct Foot {
    double t;
    Vec2 tangent;
    Vec2 d;         ///< from the foot to the point
    bool is_inner;  ///< does d stand on the curve? If not, the foot is an end that p lies beyond
};

/// Beyond an end, d leans outward along the tangent. Right above it, rounding must not decide: a cosine below `upright`, as
/// small as closest_parameter's rounding makes it, still counts as standing on the curve.
constexpr double upright = 1e-9;

Foot foot_of(const Curve& curve, const Vec2& p) {
    const double t = closest_parameter(curve, p);
    Foot foot{t, unit_tangent(curve, t), p - point(curve, t), true};
    const double outward = t <= 0 ? -foot.d.dot(foot.tangent) : t >= 1 ? foot.d.dot(foot.tangent) : 0.0;
    foot.is_inner = outward <= upright * foot.d.norm();
    return foot;
}

/// Length of a vector whose components depend on the point as they do under a translation.
Jet length_of(const Vec2& d) {
    const double r = d.norm();
    const Vec2 n = d / r;
    return {r, n.x(), n.y(), n.y() * n.y() / r, -n.x() * n.y() / r, n.x() * n.x() / r};
}

}  // namespace

NearCurve<double> curve_distance(const Curve& curve, const PointOf<double>& p) {
    const Foot foot = foot_of(curve, {p.x, p.y});
    if (!foot.is_inner) return {foot.d.norm(), false};
    return {cross(foot.tangent, foot.d), true};
}

NearCurve<Jet> curve_distance(const Curve& curve, const PointOf<Jet>& p) {
    const Foot foot = foot_of(curve, {p.x.v, p.y.v});
    if (!foot.is_inner) return {length_of(foot.d), false};
    const Vec2 n = left_of(foot.tangent), &u = foot.tangent;
    const double d = n.dot(foot.d), k = curvature(curve, foot.t), bend = -k / (1 - k * d);
    return {{d, n.x(), n.y(), bend * u.x() * u.x(), bend * u.x() * u.y(), bend * u.y() * u.y()}, true};
}

}  // namespace abut::geometry
