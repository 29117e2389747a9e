// SPDX-License-Identifier: GPL-3.0-or-later
// 1. Pieces without a common corner are apart if a side of one's hull has the other's hull on its far side, or if the circle of
//    one has the other's hull or all of its circle inside, or its circle outside, or if their lines and circles cross beyond
//    one of them.
// 2. Seen from a corner, a piece lies in the wedge between its chord and its tangent there. Pieces whose wedges have no
//    direction in common meet nowhere else.
// 3. Two circles, or a line and a circle, that have two corners in common have no third point.
// Signs are those of intervals that hold the exact values; where an interval holds zero, the answer is no.
#include "geometry/csg/clear_pieces.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace abut::geometry {

namespace {

/// To be used where a Protector stands only: it rounds as the processor is set.
using Interval = CGAL::Interval_nt<false>;
using Protector = Interval::Protector;
using Plane = CGAL::Exact_predicates_inexact_constructions_kernel;

struct Point {
    Interval x, y;
};

Point known_at(const Vec2& p) {
    return {p.x(), p.y()};
}
Point known_at(const Box2& box) {
    return {{box.min.x(), box.max.x()}, {box.min.y(), box.max.y()}};
}
Box2 box_of(const Point& p) {
    return {{p.x.inf(), p.y.inf()}, {p.x.sup(), p.y.sup()}};
}
Point operator+(const Point& a, const Point& b) {
    return {a.x + b.x, a.y + b.y};
}
Point operator-(const Point& a, const Point& b) {
    return {a.x - b.x, a.y - b.y};
}
Point operator*(const Interval& s, const Point& a) {
    return {s * a.x, s * a.y};
}
Interval cross(const Point& a, const Point& b) {
    return a.x * b.y - a.y * b.x;
}
Interval dot(const Point& a, const Point& b) {
    return a.x * b.x + a.y * b.y;
}
Interval squared(const Point& a) {
    return CGAL::square(a.x) + CGAL::square(a.y);
}
Point right_of(const Point& a) {
    return {a.y, -a.x};
}

bool is_negative(const Interval& x) {
    return x.sup() < 0;
}
bool is_positive(const Interval& x) {
    return x.inf() > 0;
}

/// Where the tangents at p and q meet that touch an arc whose chord is seen from its end r: the angle there is half the arc's.
Point tangents_meet(const Point& p, const Point& q, const Point& r) {
    const Interval tangent = cross(p - r, q - r) / dot(p - r, q - r);
    return Interval(0.5) * (p + q + tangent * right_of(q - p));
}

/// Is `b` for certain on the far side of a side of the hull of `a`?
bool has_parting_side(const HulledPiece& a, const HulledPiece& b) {
    const std::size_t n = a.hull.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Point from = known_at(a.hull[i]), side = known_at(a.hull[(i + 1) % n]) - from;
        if (std::all_of(b.hull.begin(), b.hull.end(),
                        [&](const Box2& p) { return is_negative(cross(side, known_at(p) - from)); }))
            return true;
    }
    return false;
}

struct Circle {
    Point center;
    Interval radius;
};

Circle circle_of(const OutlinePiece& arc) {
    const Point a = known_at(arc.from), u = known_at(arc.middle) - a, v = known_at(arc.to) - a;
    const Point to_center = (Interval(0.5) / cross(u, v)) * (squared(u) * right_of(v) - squared(v) * right_of(u));
    return {a + to_center, CGAL::sqrt(squared(to_center))};
}

bool is_within(const HulledPiece& b, const Circle& circle) {
    return std::all_of(b.hull.begin(), b.hull.end(), [&](const Box2& p) {
        return is_negative(squared(known_at(p) - circle.center) - CGAL::square(circle.radius));
    });
}

bool circles_part(const HulledPiece& a, const HulledPiece& b) {
    if (a.piece.turn == 0) return b.piece.turn != 0 && is_within(a, circle_of(b.piece));
    const Circle first = circle_of(a.piece);
    if (is_within(b, first)) return true;
    if (b.piece.turn == 0) return false;
    const Circle second = circle_of(b.piece);
    const Interval distance = CGAL::sqrt(squared(second.center - first.center));
    return is_within(a, second) || is_negative(distance + second.radius - first.radius) ||
           is_negative(distance + first.radius - second.radius) || is_positive(distance - first.radius - second.radius);
}

Interval root_of(const Interval& x) {
    return CGAL::sqrt(Interval(std::max(0.0, x.inf()), std::max(0.0, x.sup())));
}

using Crossings = std::array<Point, 2>;

Crossings crossings_of(const Circle& a, const Circle& b) {
    const Point between = b.center - a.center;
    const Interval squared_distance = squared(between), square = CGAL::square(a.radius) / squared_distance;
    const Interval share = Interval(0.5) * (square - CGAL::square(b.radius) / squared_distance + Interval(1));
    const Point middle = a.center + share * between;
    const Point away = root_of(square - CGAL::square(share)) * right_of(between);
    return {middle + away, middle - away};
}

Crossings crossings_of(const OutlinePiece& line, const Circle& circle) {
    const Point from = known_at(line.from), along = known_at(line.to) - from, to_center = circle.center - from;
    const Interval length = squared(along), off = cross(along, to_center) / length;
    const Interval away = root_of(CGAL::square(circle.radius) / length - CGAL::square(off)),
                   foot = dot(along, to_center) / length;
    return {from + (foot - away) * along, from + (foot + away) * along};
}

/// Is a point of the piece's line or circle for certain beyond its ends?
bool is_beyond(const OutlinePiece& piece, const Point& p) {
    const Point from = known_at(piece.from), chord = known_at(piece.to) - from;
    const Interval along = dot(chord, p - from), side = cross(chord, p - from);
    if (piece.turn == 0) return is_negative(along) || is_positive(along - squared(chord));
    return piece.turn > 0 ? is_positive(side) : is_negative(side);
}

bool cross_beyond(const OutlinePiece& a, const OutlinePiece& b) {
    if (a.turn == 0 && b.turn == 0) return false;
    const Crossings points = a.turn == 0   ? crossings_of(a, circle_of(b))
                             : b.turn == 0 ? crossings_of(b, circle_of(a))
                                           : crossings_of(circle_of(a), circle_of(b));
    return std::all_of(points.begin(), points.end(), [&](const Point& p) { return is_beyond(a, p) || is_beyond(b, p); });
}

/// Directions from a corner, from `first` counter-clockwise to `last`: less than half a turn.
struct Wedge {
    Point first, last;
};

Wedge wedge_at(const Vec2& corner, const OutlinePiece& piece) {
    const bool begins = corner == piece.from;
    const Point p = known_at(corner), chord = known_at(begins ? piece.to : piece.from) - p;
    if (piece.turn == 0) return {chord, chord};
    const Point to_middle = known_at(piece.middle) - p;
    const Point tangent = squared(chord) * to_middle - squared(to_middle) * chord;
    return (piece.turn > 0) == begins ? Wedge{tangent, chord} : Wedge{chord, tangent};
}

/// A direction of the wedge is less than a right angle away from one side at least.
bool is_outside(const Point& direction, const Wedge& wedge) {
    return is_negative(cross(wedge.first, direction)) || is_negative(cross(direction, wedge.last)) ||
           (is_negative(dot(direction, wedge.first)) && is_negative(dot(direction, wedge.last)));
}

/// Where two wedges overlap, one begins in the other.
bool wedges_part(const Wedge& a, const Wedge& b) {
    return is_outside(a.first, b) && is_outside(b.first, a);
}

Plane::Point_2 plane_point(const Vec2& p) {
    return {p.x(), p.y()};
}

bool have_different_carriers(const OutlinePiece& a, const OutlinePiece& b) {
    if (a.turn == 0 || b.turn == 0) return a.turn != b.turn;
    return CGAL::side_of_oriented_circle(plane_point(a.from), plane_point(a.middle), plane_point(a.to),
                                         plane_point(b.middle)) != CGAL::ON_ORIENTED_BOUNDARY ||
           (a.from == b.to) == (a.turn == b.turn);  // on both sides of their chord
}

}  // namespace

Vec2 point_above(const OutlinePiece& piece, double share) {
    const Vec2 chord = piece.to - piece.from, across(-chord.y(), chord.x());
    if (piece.turn == 0) return piece.from + share * chord;
    // Heights over the chord are those of a circle of radius r, all as shares of the chord's length.
    const double height = across.dot(piece.middle - piece.from) / chord.squaredNorm();
    const double r = 0.125 / std::abs(height) + 0.5 * std::abs(height), x = share - 0.5;
    const double above = (0.25 - x * x) / (std::sqrt(r * r - x * x) + std::sqrt(r * r - 0.25));
    return piece.from + share * chord + std::copysign(above, height) * across;
}

double share_of(const OutlinePiece& piece, const Vec2& p) {
    const Vec2 chord = piece.to - piece.from;
    return chord.dot(p - piece.from) / chord.squaredNorm();
}

HulledPiece hulled(const OutlinePiece& piece) {
    const Protector rounds_up;
    HulledPiece made{piece, {}, {}};
    const Point a = known_at(piece.from), m = known_at(piece.middle), b = known_at(piece.to);
    if (piece.turn == 0)
        made.hull = {box_of(a), box_of(b)};
    else if (is_positive(dot(a - b, m - b)) && is_positive(dot(m - a, b - a)))
        made.hull = {box_of(a), box_of(tangents_meet(a, m, b)), box_of(tangents_meet(m, b, a)), box_of(b)};
    if (piece.turn < 0) std::reverse(made.hull.begin(), made.hull.end());
    for (const Box2& corner : made.hull) made.box.extend(corner);
    return made;
}

Outline outline_of(const std::vector<std::vector<OutlinePiece>>& loops) {
    std::vector<HulledPiece> pieces;
    std::vector<std::size_t> begin_of_loop{0};
    std::vector<Box2> boxes;
    bool is_sound = true;
    for (const std::vector<OutlinePiece>& loop : loops) {
        for (const OutlinePiece& piece : loop) {
            pieces.push_back(hulled(piece));
            boxes.push_back(pieces.back().box);
            is_sound = is_sound && !boxes.back().empty() && piece.from != piece.to;
        }
        begin_of_loop.push_back(pieces.size());
    }
    return {std::move(pieces), std::move(begin_of_loop), EdgeTree(std::move(boxes)), is_sound};
}

std::vector<Vec2> shared_corners(const OutlinePiece& a, const OutlinePiece& b) {
    std::vector<Vec2> shared;
    for (const Vec2& p : {a.from, a.to})
        if (p == b.from || p == b.to) shared.push_back(p);
    return shared;
}

bool clearly_meet_at_corners_only(const HulledPiece& a, const HulledPiece& b) {
    const std::vector<Vec2> shared = shared_corners(a.piece, b.piece);
    if (shared.size() > 1) return have_different_carriers(a.piece, b.piece);
    const Protector rounds_up;
    if (shared.empty())
        return has_parting_side(a, b) || has_parting_side(b, a) || circles_part(a, b) || cross_beyond(a.piece, b.piece);
    return wedges_part(wedge_at(shared.front(), a.piece), wedge_at(shared.front(), b.piece));
}

}  // namespace abut::geometry
