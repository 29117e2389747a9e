// SPDX-License-Identifier: GPL-3.0-or-later
// Random valid parts of every kind of curve, about the origin and of size 1 to 3.
#pragma once
#include <array>
#include <numbers>

#include "geometry/curves/spline_shape.hpp"
#include "tests/geometry/cells/random_grids.hpp"

namespace abut::geometry::test {

inline double between(double low, double high, Random& random) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// Compilers differ in which argument of a call they compute first: what is random is drawn in statements of its own.
inline Vec2 anywhere_in(const Box2& box, Random& random) {
    const double y = between(box.min.y(), box.max.y(), random);
    return {between(box.min.x(), box.max.x(), random), y};
}

/// n points around a center, at radii between the two; on a lattice of 1/16 if asked, so that vertices share coordinates.
inline Corners star(int n, double least, double most, bool lattice, Random& random) {
    Corners points;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n, r = between(least, most, random);
        Vec2 p(r * std::cos(angle), r * std::sin(angle));
        if (lattice) p = (16 * p).array().round() / 16;
        points.push_back(p);
    }
    return points;
}

/// One of `least_n` to `least_n + more - 1` points, on a lattice or not.
inline Corners star_of(int least_n, unsigned more, double least, double most, Random& random) {
    const bool lattice = random() % 2 == 0;
    const int n = least_n + static_cast<int>(random() % more);
    return star(n, least, most, lattice, random);
}

inline std::vector<Curve> backwards(const std::vector<Curve>& curves) {
    std::vector<Curve> result;
    for (auto it = curves.rbegin(); it != curves.rend(); ++it) result.push_back(reversed(*it));
    return result;
}

/// A closed B-spline over a wrapped control polygon; uniform knots, or some moved, or some double.
inline std::vector<Curve> closed_spline(const Corners& points, int degree, bool rational, Random& random) {
    Nurbs nurbs;
    nurbs.degree = degree;
    nurbs.points = points;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (rational) nurbs.weights.push_back(std::pow(4.0, between(-1, 1, random)));
    for (int i = 0; i < degree; ++i) {
        nurbs.points.push_back(nurbs.points[static_cast<std::size_t>(i)]);
        if (rational) nurbs.weights.push_back(nurbs.weights[static_cast<std::size_t>(i)]);
    }
    for (std::size_t i = 0; i < nurbs.points.size() + static_cast<std::size_t>(degree) + 1; ++i)
        nurbs.knots.push_back(static_cast<double>(i));
    return nurbs_curves(nurbs);
}

/// A flat curve of any kind, turning left, from p to q.
inline Curve side(int kind, const Vec2& p, const Vec2& q, Random& random) {
    const double half = between(0.1, 0.4, random);  // of an arc's angle
    const Vec2 d = q - p, middle = 0.5 * (p + q);
    const Vec2 along = -0.5 / std::sin(half) * d, outward = between(0.05, 0.2, random) * right_of(d);
    if (kind == 1) {
        const Vec2 center = middle + 0.5 / std::tan(half) * left_of(d);
        return Arc{center, along.norm(), std::atan2((p - center).y(), (p - center).x()), 2 * half};
    }
    if (kind == 2) return EllipticArc{middle - std::cos(half) * outward, along, outward, std::numbers::pi / 2 - half, 2 * half};
    if (kind == 3) return bezier_curve({p, p + 0.3 * d + outward, q - 0.4 * d + outward, q}, {});
    if (kind == 4) return bezier_curve({p, middle + outward, q}, {1, between(0.3, 3, random), 1});
    if (kind == 5) return bezier_curve({p, p + 0.2 * d - outward, middle, q - 0.2 * d + outward, q}, {});
    return Segment{p, q};
}

inline Part random_polygon(Random& random) {
    Part part;
    add_loop(part, closed(star_of(3, 10, 0.6, 1.4, random)));
    if (random() % 2 == 0) {
        Corners hole = star_of(3, 4, 0.1, 0.2, random);
        std::reverse(hole.begin(), hole.end());
        add_loop(part, closed(hole));
    }
    return part;
}

inline Part random_rounded_rectangle(Random& random) {
    const double a = between(0.5, 1.5, random), b = between(0.3, 1, random), r = between(0.05, 0.29, random);
    const double quarter = std::numbers::pi / 2;
    Part part;
    add_loop(part,
             {Segment{{r - a, -b}, {a - r, -b}}, Arc{{a - r, r - b}, r, -quarter, quarter}, Segment{{a, r - b}, {a, b - r}},
              Arc{{a - r, b - r}, r, 0, quarter}, Segment{{a - r, b}, {r - a, b}}, Arc{{r - a, b - r}, r, quarter, quarter},
              Segment{{-a, b - r}, {-a, r - b}}, Arc{{r - a, r - b}, r, 2 * quarter, quarter}});
    return part;
}

inline Part random_disc_with_holes(Random& random) {
    const double turn = 2 * std::numbers::pi;
    Part part;
    add_loop(part, {Arc{{0, 0}, 1, between(0, turn, random), turn}});
    const int n = static_cast<int>(random() % 5);
    for (int i = 0; i < n; ++i) {
        const double angle = turn * i / n;
        add_loop(
            part,
            {Arc{
                {0.6 * std::cos(angle), 0.6 * std::sin(angle)}, between(0.05, 0.35, random), between(0, turn, random), -turn}});
    }
    return part;
}

inline Part random_ellipse(Random& random) {
    const double turn = 2 * std::numbers::pi, seam = random() % 2 == 0 ? 0 : between(0, turn, random);
    const double b = std::pow(10.0, -2 * between(0, 1, random)), half = 0.4 * turn;
    Part part;
    if (random() % 2 == 0)
        add_loop(part, {EllipticArc{{0, 0}, {1, 0}, {0, b}, seam, turn}});
    else
        add_loop(part, {EllipticArc{{0, 0}, {1, 0}, {0, b}, seam, half},
                        EllipticArc{{0, 0}, {1, 0}, {0, b}, seam + half, turn - half}});
    // a mirrored ellipse that runs forward is a hole
    if (random() % 2 == 0) add_loop(part, {EllipticArc{{0.2, 0}, {0.5, 0}, {0, -0.5 * b}, seam, turn}});
    return part;
}

inline Part random_spline(bool rational, Random& random) {
    const int degree = 2 + static_cast<int>(random() % 5);
    const int n = degree + 3 + static_cast<int>(random() % 5);
    Part part;
    add_loop(part, closed_spline(star(n, 0.7, 1.3, false, random), degree, rational, random));
    if (random() % 2 == 0)
        add_loop(part, backwards(closed_spline(star(6, 0.15, 0.25, false, random), 1 + degree / 2, rational, random)));
    return part;
}

inline Part random_mixed(Random& random) {
    const Corners points = star_of(4, 5, 0.8, 1.2, random);
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < points.size(); ++i)
        curves.push_back(side(static_cast<int>(random() % 6), points[i], points[(i + 1) % points.size()], random));
    Part part;
    add_loop(part, curves);
    if (random() % 2 == 0) add_loop(part, {Arc{{0.1, 0.05}, 0.2, between(0, 6, random), -2 * std::numbers::pi}});
    return part;
}

/// Not at all, by a quarter, or by any angle, and moved.
inline Part turned_at_random(const Part& part, Random& random) {
    const std::size_t turn = random() % 3;
    if (turn == 0) return part;
    if (turn == 1) return transformed(part, 0, 1, {0, 0});
    const double angle = between(-std::numbers::pi, std::numbers::pi, random);
    return transformed(part, std::cos(angle), std::sin(angle), {0.125, -0.25});
}

inline constexpr int n_part_kinds = 7;

/// Kinds 0 to n_part_kinds - 1; turned not at all, by a quarter, or by any angle, and moved.
inline Part random_part(int kind, Random& random) {
    const Part part = kind == 0   ? random_polygon(random)
                      : kind == 1 ? random_rounded_rectangle(random)
                      : kind == 2 ? random_disc_with_holes(random)
                      : kind == 3 ? random_ellipse(random)
                      : kind == 4 ? random_mixed(random)
                                  : random_spline(kind == 6, random);
    return turned_at_random(part, random);
}

}  // namespace abut::geometry::test
