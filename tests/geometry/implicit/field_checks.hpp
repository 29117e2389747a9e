// SPDX-License-Identifier: GPL-3.0-or-later
// One finite-difference harness for all implicit fields, and the bodies that they are tested on.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "geometry/curves/spline_shape.hpp"
#include "geometry/implicit/implicit.hpp"

namespace abut::geometry {

using FieldFunction = std::function<FieldValue(const Vec2&)>;

/// Errors of gradient and Hessian against central differences with step h, and what these leave open: three times their error
/// as differences with step 2h tell it, and rounding. An error above its bound is a wrong derivative.
struct DerivativeErrors {
    double gradient = 0, gradient_bound = 0;
    double hessian = 0, hessian_bound = 0;  ///< times size: without a unit
    bool right() const { return gradient <= gradient_bound && hessian <= hessian_bound; }
    /// Next to corners and kinks differences tell nothing.
    bool tell_something() const { return gradient_bound < 1e-6 && hessian_bound < 1e-4; }
};

struct Differences {
    Vec2 gradient{0, 0};
    Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
};
inline Differences differences(const FieldFunction& field, const Vec2& p, double h) {
    Differences d;
    for (int axis = 0; axis < 2; ++axis) {
        const Vec2 step = h * Vec2::Unit(axis);
        const FieldValue plus = field(p + step), minus = field(p - step);
        d.gradient[axis] = (plus.value - minus.value) / (2 * h);
        d.hessian.col(axis) = (plus.gradient - minus.gradient) / (2 * h);
    }
    return d;
}

inline DerivativeErrors derivative_errors(const FieldFunction& field, const Vec2& p, double size) {
    const double h = 1e-5 * size, rounding = 1e-14;
    const FieldValue at = field(p);
    const Differences once = differences(field, p, h), twice = differences(field, p, 2 * h);
    DerivativeErrors errors;
    errors.gradient = (once.gradient - at.gradient).norm();
    errors.gradient_bound = (once.gradient - twice.gradient).norm() + rounding * (size + std::abs(at.value)) / h;
    errors.hessian = size * (once.hessian - at.hessian).norm();
    errors.hessian_bound =
        size * ((once.hessian - twice.hessian).norm() + rounding * (1 + at.gradient.norm() + size * at.hessian.norm()) / h);
    return errors;
}

/// Checks the derivatives at n points; nearly all of them must tell something.
inline void expect_derivatives(const FieldFunction& field, const std::function<Vec2()>& next_point, int n, double size,
                               const std::string& name, double least_telling = 0.9) {
    int n_telling = 0;
    for (int i = 0; i < n; ++i) {
        const Vec2 p = next_point();
        const DerivativeErrors errors = derivative_errors(field, p, size);
        if (!errors.tell_something()) continue;
        ++n_telling;
        EXPECT_LE(errors.gradient, errors.gradient_bound) << name << " at " << p.transpose();
        EXPECT_LE(errors.hessian, errors.hessian_bound) << name << " at " << p.transpose();
    }
    EXPECT_GE(n_telling, least_telling * n) << name;
}

/// A body: closed chains of curves, material on the left.
inline Part body(const std::vector<std::vector<Curve>>& loops) {
    Part part;
    for (const std::vector<Curve>& curves : loops) {
        Loop loop;
        for (const Curve& curve : curves) {
            loop.edges.push_back(static_cast<int>(part.edges.size()));
            part.edges.push_back({curve, "e" + std::to_string(part.edges.size()), ""});
        }
        part.loops.push_back(loop);
    }
    return part;
}

inline std::vector<Curve> closed_polygon(const std::vector<Vec2>& corners) {
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < corners.size(); ++i) curves.push_back(Segment{corners[i], corners[(i + 1) % corners.size()]});
    return curves;
}

struct NamedBody {
    std::string name;
    Part part;
};

/// Straight and circular edges: re-entrant corners, arcs of less and more than half a turn, exactly half a turn, holes.
inline std::vector<NamedBody> round_bodies() {
    const double pi = std::numbers::pi;
    const Arc mouth{{0, 0}, 2, pi / 4, 1.5 * pi};
    return {
        {"ell", body({closed_polygon({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}})})},
        {"slot with hole",
         body({{Segment{{-2, -1}, {2, -1}}, Arc{{2, 0}, 1, -pi / 2, pi}, Segment{{2, 1}, {-2, 1}}, Arc{{-2, 0}, 1, pi / 2, pi}},
               {Arc{{0.5, 0.1}, 0.5, 0, -2 * pi}}})},
        {"open mouth", body({{mouth, Segment{point(mouth, 1), {0, 0}}, Segment{{0, 0}, point(mouth, 0)}}})},
        {"lens with bite",
         body({{Arc{{0, 0}, 2, -2.2, 0.9}, Segment{point(Arc{{0, 0}, 2, -2.2, 0.9}, 1), {1.5, 1}}, Segment{{1.5, 1}, {0.5, 1}},
                Arc{{0, 1}, 0.5, 0, -pi / 2}, Segment{{0, 0.5}, point(Arc{{0, 0}, 2, -2.2, 0.9}, 0)}}})},
    };
}

/// Elliptic arcs (also mirrored, also as holes) and splines.
inline std::vector<NamedBody> general_bodies() {
    const double pi = std::numbers::pi;
    const EllipticArc half{{0, 0}, {2, 1}, {-0.5, 1}, 0, pi};
    const EllipticArc mirrored{{0, 0}, {2, 0}, {0, -1}, 0, -1.5 * pi};
    const Curve wave = bezier_curve({{0, 0}, {1, -1}, {2, 1}, {3, 0}}, {});
    const Curve dome = bezier_curve({{3, 0}, {3, 2}, {0, 2}}, {1, 0.8, 1.3});
    return {
        {"half ellipse", body({{half, Segment{point(half, 1), point(half, 0)}}})},
        {"most of a mirrored ellipse", body({{mirrored, Segment{point(mirrored, 1), point(mirrored, 0)}}})},
        {"ring of ellipses",
         body({{EllipticArc{{0, 0}, {2, 1}, {-0.5, 1}, 0, 2 * pi}}, {EllipticArc{{0.1, 0}, {0, 0.5}, {0.7, 0}, 1, 2 * pi}}})},
        {"spline and lines", body({{wave, dome, Segment{{0, 2}, {0, 0}}}})},
    };
}

inline std::vector<NamedBody> all_bodies() {
    std::vector<NamedBody> all = round_bodies();
    for (NamedBody& each : general_bodies()) all.push_back(std::move(each));
    return all;
}

/// Random points of a part's box, enlarged by half of it.
class PointsAround {
public:
    PointsAround(const Part& part, unsigned seed) : box_(bounding_box(part)), random_(seed) {}
    Vec2 operator()() {
        std::uniform_real_distribution<double> u(-0.25, 1.25);
        const double x = u(random_), y = u(random_);
        return box_.min + Vec2(x, y).cwiseProduct(box_.size());
    }

private:
    Box2 box_;
    std::mt19937 random_;
};

/// Distance to the closest point of the boundary.
inline double true_distance(const Part& part, const Vec2& p) {
    double least = std::numeric_limits<double>::infinity();
    for (const Edge& edge : part.edges)
        least = std::min(least, (p - point(edge.curve, closest_parameter(edge.curve, p))).norm());
    return least;
}

}  // namespace abut::geometry
