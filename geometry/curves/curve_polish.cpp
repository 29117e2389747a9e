// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/curve_polish.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/curves/numbers.hpp"

namespace abut::geometry {

namespace {

constexpr int most_newton_steps = 30;
/// Parameters are of order one: smaller steps are rounding.
constexpr double settled_step = 4 * epsilon;
/// Where the curve is slow in its parameter, rounding keeps the steps above that: steps this small that no longer halve have
/// settled as well.
constexpr double nearly_settled_step = 1e-8;

/// Two equations and their derivatives by the two parameters.
struct System {
    Vec2 value, by_a, by_b;
};

/// An end that is missed by rounding is the end.
double snapped(double t) {
    return t <= settled_step ? 0.0 : t >= 1 - settled_step ? 1.0 : t;
}

template <class Equations>
std::optional<ParameterPair> newton(Equations equations, ParameterPair t) {
    double before = 1;
    for (int k = 0; k < most_newton_steps; ++k) {
        const System f = equations(t);
        const double det = cross(f.by_a, f.by_b);
        const double da = -cross(f.value, f.by_b) / det, db = -cross(f.by_a, f.value) / det;
        if (!std::isfinite(da) || !std::isfinite(db)) return std::nullopt;
        const ParameterPair next{std::clamp(t.a + da, 0.0, 1.0), std::clamp(t.b + db, 0.0, 1.0)};
        const double step = std::max(std::abs(next.a - t.a), std::abs(next.b - t.b));
        t = next;
        if (step <= settled_step || (step <= nearly_settled_step && step > 0.5 * before))
            return ParameterPair{snapped(t.a), snapped(t.b)};
        before = step;
    }
    return std::nullopt;
}

/// Two plain Newton steps on (x - p) . x' = 0 from a minimum that is known to the root of rounding: all that distances tell.
double newton_closest(const Curve& curve, const Vec2& p, double t) {
    constexpr double close_enough = 1e-6;
    for (int k = 0; k < 2; ++k) {
        const Vec2 d = point(curve, t) - p, d1 = derivative(curve, t);
        const double step = -d.dot(d1) / (d1.squaredNorm() + d.dot(second_derivative(curve, t)));
        if (!(std::abs(step) <= close_enough)) return t;
        t = std::clamp(t + step, 0.0, 1.0);
    }
    return t;
}

}  // namespace

std::optional<ParameterPair> polished_crossing(const Curve& a, const Curve& b, ParameterPair start) {
    const auto equations = [&](const ParameterPair& t) -> System {
        return {point(a, t.a) - point(b, t.b), derivative(a, t.a), -derivative(b, t.b)};
    };
    return newton(equations, start);
}

std::optional<ParameterPair> polished_parallel(const Curve& a, const Curve& b, ParameterPair start) {
    const auto equations = [&](const ParameterPair& t) -> System {
        const Vec2 d = point(b, t.b) - point(a, t.a);
        const Vec2 a1 = derivative(a, t.a), a2 = second_derivative(a, t.a);
        const Vec2 b1 = derivative(b, t.b), b2 = second_derivative(b, t.b);
        return {{d.dot(a1), cross(a1, b1)}, {d.dot(a2) - a1.squaredNorm(), cross(a2, b1)}, {b1.dot(a1), cross(a1, b2)}};
    };
    return newton(equations, start);
}

double nearby_closest_parameter(const Curve& curve, const Vec2& p, double start) {
    double t = start, squared = (point(curve, t) - p).squaredNorm();
    for (int k = 0; k < most_newton_steps; ++k) {
        const Vec2 d = point(curve, t) - p, d1 = derivative(curve, t);
        const double slope = d.dot(d1), bend = d1.squaredNorm() + d.dot(second_derivative(curve, t));
        double step = -slope / (bend > 0 ? bend : d1.squaredNorm());
        double next = std::clamp(t + step, 0.0, 1.0), there = (point(curve, next) - p).squaredNorm();
        while (there > squared && std::abs(next - t) > settled_step) {  // too far: on curves that turn away
            step = 0.5 * (next - t);
            next = t + step;
            there = (point(curve, next) - p).squaredNorm();
        }
        const double moved = std::abs(next - t);
        if (there > squared) break;
        t = next;
        squared = there;
        if (moved <= settled_step) break;
    }
    return snapped(newton_closest(curve, p, t));
}

}  // namespace abut::geometry
