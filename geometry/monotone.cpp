// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/monotone.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abut::geometry {

namespace {

double between(double v, double a, double b) {
    return std::clamp(v, std::min(a, b), std::max(a, b));
}

/// The point of an arc where its tangent is parallel to an axis, with the coordinate that is extreme exact.
Vec2 extreme_point(const Arc& arc, double t) {
    const Vec2 d = point(arc, t) - arc.center;
    if (std::abs(d.x()) > std::abs(d.y())) return {arc.center.x() + std::copysign(arc.radius, d.x()), arc.center.y()};
    return {arc.center.x(), arc.center.y() + std::copysign(arc.radius, d.y())};
}

MonotonePiece make_piece(int edge, const Curve& curve, double t0, double t1, const Vec2& from, const Vec2& to) {
    MonotonePiece piece{edge, t0, t1, from, to};
    if (const auto* arc = std::get_if<Arc>(&curve)) {
        const Vec2 d = point(curve, 0.5 * (t0 + t1)) - arc->center;
        piece.is_arc = true;
        piece.center = arc->center;
        piece.radius = arc->radius;
        piece.x_side = d.x() < 0 ? -1 : 1;
        piece.y_side = d.y() < 0 ? -1 : 1;
    }
    return piece;
}

/// Pieces of one edge whose end coordinates are given by its neighbours.
void append_edge(std::vector<MonotonePiece>& pieces, int e, const Curve& curve, const Vec2& begin, const Vec2& end) {
    double t = 0;
    Vec2 at = begin;
    for (double next : axis_extrema(curve)) {
        const Vec2 p = extreme_point(std::get<Arc>(curve), next);
        pieces.push_back(make_piece(e, curve, t, next, at, p));
        t = next;
        at = p;
    }
    pieces.push_back(make_piece(e, curve, t, 1, at, end));
}

}  // namespace

std::vector<MonotonePiece> monotone_pieces(const Part& part) {
    std::vector<MonotonePiece> pieces;
    std::vector<Loop> loops = part.loops;
    if (loops.empty()) {
        loops.emplace_back();
        for (std::size_t e = 0; e < part.edges.size(); ++e) loops[0].edges.push_back(static_cast<int>(e));
    }
    for (const Loop& loop : loops) {
        const std::size_t n = loop.edges.size();
        for (std::size_t i = 0; i < n; ++i) {
            const int e = loop.edges[i];
            const Curve& curve = part.edges[static_cast<std::size_t>(e)].curve;
            const Curve& next = part.edges[static_cast<std::size_t>(loop.edges[(i + 1) % n])].curve;
            append_edge(pieces, e, curve, point(curve, 0), point(next, 0));
        }
    }
    return pieces;
}

double y_at(const MonotonePiece& piece, double x) {
    double y;
    if (piece.is_arc) {
        const double dx = x - piece.center.x();
        y = piece.center.y() + piece.y_side * std::sqrt(std::max(0.0, (piece.radius - dx) * (piece.radius + dx)));
    } else {
        y = piece.from.y() + (x - piece.from.x()) / (piece.to.x() - piece.from.x()) * (piece.to.y() - piece.from.y());
    }
    return between(y, piece.from.y(), piece.to.y());
}

double x_at(const MonotonePiece& piece, double y) {
    double x;
    if (piece.is_arc) {
        const double dy = y - piece.center.y();
        x = piece.center.x() + piece.x_side * std::sqrt(std::max(0.0, (piece.radius - dy) * (piece.radius + dy)));
    } else {
        x = piece.from.x() + (y - piece.from.y()) / (piece.to.y() - piece.from.y()) * (piece.to.x() - piece.from.x());
    }
    return between(x, piece.from.x(), piece.to.x());
}

double parameter_at(const MonotonePiece& piece, const Vec2& p, const Curve& curve) {
    double t;
    if (piece.is_arc) {
        const Arc& arc = std::get<Arc>(curve);
        const Vec2 d = p - arc.center;
        const double middle = arc.start + 0.5 * (piece.t0 + piece.t1) * arc.sweep;
        const double angle = middle + std::remainder(std::atan2(d.y(), d.x()) - middle, 2 * std::numbers::pi);
        t = (angle - arc.start) / arc.sweep;
    } else {
        const Vec2 d = piece.to - piece.from;
        const double ratio = (p - piece.from).dot(d) / d.squaredNorm();
        t = piece.t0 + ratio * (piece.t1 - piece.t0);
    }
    return std::clamp(t, piece.t0, piece.t1);
}

bool contains(const std::vector<MonotonePiece>& pieces, const Vec2& p) {
    // signed crossings with the ray towards +x; the half-open rule y < p.y counts shared ends once
    int winding = 0;
    for (const MonotonePiece& piece : pieces) {
        if ((piece.from.y() < p.y()) == (piece.to.y() < p.y())) continue;
        if (p.x() < x_at(piece, p.y())) winding += piece.to.y() > piece.from.y() ? 1 : -1;
    }
    return winding > 0;
}

}  // namespace abut::geometry
