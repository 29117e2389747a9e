// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plan/edge_traction.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "geometry/curves/curve_rule.hpp"
#include "src/base/index.hpp"

namespace abut {

namespace {

const geometry::Curve& curve_of(const Scene& scene, const EdgePortion& p) {
    return scene.parts[at(p.part)].part.edges[at(p.edge)].curve;
}

/// Calls add(x, n, area) at the Gauss points of all portions; around an axis the areas are over 2 pi.
template <class Add>
void integrate(const Scene& scene, const std::vector<EdgePortion>& portions, Add add) {
    const bool around_axis = scene.analysis == Analysis::axisymmetric;
    for (const EdgePortion& p : portions) {
        const geometry::Curve& curve = curve_of(scene, p);
        const geometry::CurveRule rule = geometry::curve_rule(curve, p.t0, p.t1);
        for (std::size_t q = 0; q < rule.t.size(); ++q) {
            const double t = rule.t[q];
            const Vec2 x = point(curve, t);
            const double width = scene.parts[at(p.part)].thickness * (around_axis ? x.x() : 1);
            add(x, outward_normal(curve, t), std::abs(rule.weights[q]) * width * derivative(curve, t).norm());
        }
    }
}

double turn(const Vec2& arm, const Vec2& force) {
    return arm.x() * force.y() - arm.y() * force.x();
}

Vec2 constant_of(const Load& load) {
    return {load.value[0].constant(), load.value[1].constant()};
}

/// Of the traction -n max(0, -n . v) over portions where -n . v > 0 the total is A v, A = integral of n n^T.
Vec2 pressing_of(const Scene& scene, const Vec2& force, const std::vector<EdgePortion>& portions) {
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    integrate(scene, portions, [&](const Vec2&, const Vec2& n, double area) { sum += area * n * n.transpose(); });
    const Eigen::JacobiSVD<Eigen::Matrix2d> factor(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return factor.solve(force);
}

/// Where -n . v is positive along the portion, found between samples.
void append_facing(const geometry::Curve& curve, const EdgePortion& whole, const Vec2& v, std::vector<EdgePortion>& facing) {
    constexpr int samples = 64, halvings = 60;
    const auto presses = [&](double t) { return -outward_normal(curve, t).dot(v) > 0; };
    const auto border = [&](double inside, double outside) {
        for (int i = 0; i < halvings; ++i) {
            const double middle = 0.5 * (inside + outside);
            (presses(middle) ? inside : outside) = middle;
        }
        return inside;
    };
    EdgePortion open = whole;
    for (int i = 0; i < samples; ++i) {  // the ends count as what lies beside them: at corners of two portions normals jump
        const double h = (whole.t1 - whole.t0) / samples, t = whole.t0 + (i + 0.5) * h;
        const bool here = presses(t), before = i > 0 && presses(t - h);
        if (here && !before) open.t0 = i == 0 ? whole.t0 : border(t, t - h);
        if (!here && before) facing.push_back({whole.part, whole.edge, open.t0, border(t - h, t)});
        if (here && i + 1 == samples) facing.push_back({whole.part, whole.edge, open.t0, whole.t1});
    }
}

}  // namespace

EdgeTraction edge_traction(const Scene& scene, const Load& load, const std::vector<EdgePortion>& portions) {
    EdgeTraction traction;
    if (load.kind == Load::Kind::bearing) traction.pressing = pressing_of(scene, constant_of(load), portions);
    if (load.kind != Load::Kind::edge_force && load.kind != Load::Kind::edge_moment) return traction;
    double area = 0, second = 0;
    Vec2 first(0, 0);
    integrate(scene, portions, [&](const Vec2& x, const Vec2&, double a) {
        area += a;
        first += a * x;
    });
    const Vec2 force = load.kind == Load::Kind::edge_force ? constant_of(load) : Vec2(0, 0);
    traction.even = force / area;
    if (load.kind == Load::Kind::edge_force && !load.at) return traction;
    traction.center = first / area;
    integrate(scene, portions,
              [&](const Vec2& x, const Vec2&, double a) { second += a * (x - traction.center).squaredNorm(); });
    const double moment =
        load.kind == Load::Kind::edge_moment ? load.value[0].constant() : turn(*load.at - traction.center, force);
    traction.turning = moment / second;
    return traction;
}

std::vector<EdgePortion> pressed_portions(const Scene& scene, const Load& load, const std::vector<EdgePortion>& portions) {
    // Newton's method for the minimum of a convex function, whose gradient is the total force: it ends in a few steps.
    constexpr int most_steps = 50;
    constexpr double rounding = 1e-9;
    const Vec2 force = constant_of(load);
    Vec2 v = force;
    std::vector<EdgePortion> pressed;
    for (int i = 0; i < most_steps; ++i) {
        pressed.clear();
        for (const EdgePortion& p : portions) append_facing(curve_of(scene, p), p, v, pressed);
        const Vec2 next = pressing_of(scene, force, pressed);
        const bool is_same = (next - v).norm() <= rounding * next.norm();
        v = next;
        if (is_same) break;
    }
    Vec2 total(0, 0);
    integrate(scene, pressed, [&](const Vec2&, const Vec2& n, double area) { total -= area * std::max(0.0, -n.dot(v)) * n; });
    if ((total - force).norm() > rounding * force.norm()) pressed.clear();
    return pressed;
}

}  // namespace abut
