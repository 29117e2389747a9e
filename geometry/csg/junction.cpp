// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/junction.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace abut::geometry {

namespace {

constexpr int max_steps = 60;  ///< touching points are double roots of the crossing equations: one bit a step
constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();  ///< of parameters, where iterations end
/// Steps below this that no longer shrink are rounding too: at small angles it is amplified.
constexpr double small_step = 1e-6;
/// A crossing is certain where the curves part by this many tolerances between it and the next one.
constexpr double certain_depth = 4;
/// Crossings of arcs lie this many tolerances (over the sine of the angle) or less from those of the curves.
constexpr double largest_shift = 8;

/// Newton steps of two equations in (ta, tb) until they are rounding; false where the system is singular or they do not end.
template <class System>
bool iterate(System system, double& ta, double& tb) {
    double last = 1;
    for (int i = 0; i < max_steps; ++i) {
        Vec2 f;
        Eigen::Matrix2d j;
        system(ta, tb, f, j);
        const double determinant = j.determinant();
        if (determinant == 0 || !std::isfinite(determinant)) return f.isZero(0);
        const Vec2 step = j.inverse() * f;
        const double size = std::max(std::abs(step.x()) / (1 + std::abs(ta)), std::abs(step.y()) / (1 + std::abs(tb)));
        if (!(size <= 1)) return false;
        if (last <= small_step && size >= last) return true;
        ta -= step.x();
        tb -= step.y();
        if (size <= rounding) return true;
        last = size;
    }
    return false;
}

double sine_between(const Curve& a, double ta, const Curve& b, double tb) {
    return cross(unit_tangent(a, ta), unit_tangent(b, tb));
}

/// Difference of the curvatures of two curves that run side by side, either way.
double relative_curvature(const Curve& a, double ta, const Curve& b, double tb) {
    const bool same_way = derivative(a, ta).dot(derivative(b, tb)) > 0;
    return std::abs(curvature(a, ta) - (same_way ? 1 : -1) * curvature(b, tb));
}

Junction junction_at(const Curve& a, double ta, const Curve& b, double tb) {
    return {ta, tb, point(a, ta), point(b, tb)};
}

/// Parameters of a crossing next to the guess, certain or not.
std::optional<Junction> any_crossing(const Curve& a, double ta, const Curve& b, double tb) {
    const bool ended = iterate(
        [&](double s, double t, Vec2& f, Eigen::Matrix2d& j) {
            f = point(a, s) - point(b, t);
            j.col(0) = derivative(a, s);
            j.col(1) = -derivative(b, t);
        },
        ta, tb);
    if (!ended) return {};
    return junction_at(a, ta, b, tb);
}

/// Is it the crossing that the arcs showed at `guess`?
bool is_certain(const Junction& found, const Curve& a, const Curve& b, const Vec2& guess, const JunctionTolerance& tolerance) {
    const double sine = std::abs(sine_between(a, found.ta, b, found.tb));
    const double curving = relative_curvature(a, found.ta, b, found.tb);
    return sine * sine >= 2 * certain_depth * tolerance.curves * curving &&
           (found.xa - guess).norm() * sine <= largest_shift * tolerance.curves + tolerance.merge;
}

}  // namespace

double local_parameter(const Curve& curve, const Vec2& p, double t, double range) {
    const double lo = t - range, hi = t + range;
    for (int i = 0; i < max_steps; ++i) {
        const Vec2 d = derivative(curve, t), between = point(curve, t) - p;
        const double slope = d.squaredNorm() + between.dot(second_derivative(curve, t));
        const double step = between.dot(d) / (slope > 0 ? slope : d.squaredNorm());
        const double next = std::clamp(t - step, lo, hi);
        if (std::abs(next - t) <= rounding * (1 + std::abs(t))) return next;
        t = next;
    }
    return t;
}

std::optional<Junction> find_touching(const Curve& a, double ta, const Curve& b, double tb,
                                      const JunctionTolerance& tolerance) {
    const Vec2 guess = 0.5 * (point(a, ta) + point(b, tb));
    const bool ended = iterate(
        [&](double s, double t, Vec2& f, Eigen::Matrix2d& j) {
            const Vec2 between = point(a, s) - point(b, t), da = derivative(a, s), db = derivative(b, t);
            const Vec2 dda = second_derivative(a, s), ddb = second_derivative(b, t);
            f = {cross(da, db), between.dot(da)};  // parallel, and one point at the foot of the other
            j << cross(dda, db), cross(da, ddb), da.dot(da) + between.dot(dda), -db.dot(da);
        },
        ta, tb);
    if (!ended) return {};
    const Junction found = junction_at(a, ta, b, tb);
    if ((found.xa - found.xb).norm() > tolerance.merge) return {};
    const double depth = largest_shift * tolerance.curves + tolerance.merge;  // the arcs cross where the curves are so close
    if (relative_curvature(a, ta, b, tb) * (found.xa - guess).squaredNorm() > 2 * depth) return {};
    return found;
}

std::optional<Junction> find_junction(const Curve& a, double ta, const Curve& b, double tb,
                                      const JunctionTolerance& tolerance) {
    const Junction guess = junction_at(a, ta, b, tb);
    const auto found = any_crossing(a, ta, b, tb);
    if (found && is_certain(*found, a, b, 0.5 * (guess.xa + guess.xb), tolerance)) return found;
    if (const auto touch = find_touching(a, ta, b, tb, tolerance)) return touch;
    if (!found && (guess.xa - guess.xb).norm() <= tolerance.merge) return guess;  // the curves run along each other
    return {};
}

}  // namespace abut::geometry
