// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/monotone.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/curves/general_curve.hpp"

namespace abut::geometry {

namespace {

double between(double v, double a, double b) {
    return std::clamp(v, std::min(a, b), std::max(a, b));
}

/// The point where a piece of the curve ends and the next one begins: of an arc with the coordinate that is extreme exact.
Vec2 joint(const Curve& curve, double t) {
    const Vec2 p = point(curve, t);
    const auto* arc = std::get_if<Arc>(&curve);
    if (!arc) return p;
    const Vec2 d = p - arc->center;
    if (std::abs(d.x()) > std::abs(d.y())) return {arc->center.x() + std::copysign(arc->radius, d.x()), arc->center.y()};
    return {arc->center.x(), arc->center.y() + std::copysign(arc->radius, d.y())};
}

/// Parameters in (0, 1), ascending, where pieces of a curve end.
std::vector<double> joints(const Curve& curve) {
    std::vector<double> cuts = axis_extrema(curve);
    const std::vector<double> breaks = smoothness_breaks(curve);
    if (breaks.empty()) return cuts;
    cuts.insert(cuts.end(), breaks.begin(), breaks.end());
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    return cuts;
}

/// Pieces of one edge whose end coordinates are given by its neighbours.
void append_edge(std::vector<MonotonePiece>& pieces, int e, const Curve& curve, const Vec2& begin, const Vec2& end) {
    double t = 0;
    Vec2 at = begin;
    for (double next : joints(curve)) {
        const Vec2 p = joint(curve, next);
        pieces.push_back(monotone_piece(e, curve, t, next, at, p));
        t = next;
        at = p;
    }
    pieces.push_back(monotone_piece(e, curve, t, 1, at, end));
}

double parameter_on_arc(const MonotonePiece& piece, const Vec2& p, const Arc& arc) {
    const Vec2 d = p - arc.center;
    const double middle = arc.start + 0.5 * (piece.t0 + piece.t1) * arc.sweep;
    const double angle = middle + std::remainder(std::atan2(d.y(), d.x()) - middle, 2 * std::numbers::pi);
    return (angle - arc.start) / arc.sweep;
}

double parameter_on_line(const MonotonePiece& piece, const Vec2& p) {
    const Vec2 d = piece.to - piece.from;
    const double ratio = (p - piece.from).dot(d) / d.squaredNorm();
    return piece.t0 + ratio * (piece.t1 - piece.t0);
}

/// By the coordinate that changes faster there: the other one says little about t near its extreme.
double parameter_on_general(const MonotonePiece& piece, const Vec2& p) {
    const Vec2 extent = (piece.to - piece.from).cwiseAbs();
    const int axis = extent.x() >= extent.y() ? 0 : 1;
    const double t = monotone_crossing(piece.curve, piece.t0, piece.t1, axis, p[axis]);
    const Vec2 d = derivative(piece.curve, t);
    if (std::abs(d[axis]) >= std::abs(d[1 - axis]) || extent[1 - axis] == 0) return t;
    return monotone_crossing(piece.curve, piece.t0, piece.t1, 1 - axis, p[1 - axis]);
}

/// The ends are asked first, since a vertex may be off the curve by the merge length.
LineMeeting general_meeting(const MonotonePiece& piece, int axis, double c) {
    const double a = piece.from[axis], b = piece.to[axis];
    if (c == a || (c < a) == (a < b)) return {piece.from, piece.t0};
    if (c == b || (c < b) == (b < a)) return {piece.to, piece.t1};
    const double t = monotone_crossing(piece.curve, piece.t0, piece.t1, axis, c);
    Vec2 at;
    at[axis] = c;
    at[1 - axis] = between(point(piece.curve, t)[1 - axis], piece.from[1 - axis], piece.to[1 - axis]);
    return {at, t};
}

/// d(other coordinate)/d(coordinate `axis`) where the latter is c.
double slope(const MonotonePiece& piece, int axis, double c) {
    Vec2 d = piece.to - piece.from;
    if (piece.is_general) {
        d = derivative(piece.curve, general_meeting(piece, axis, c).t);
    } else if (piece.is_arc) {
        Vec2 p;
        p[axis] = c;
        p[1 - axis] = axis == 0 ? y_at(piece, c) : x_at(piece, c);
        d = left_of(p - piece.center);
    }
    return d[1 - axis] / d[axis];
}

/// Does the ray from p towards +x meet the piece? The half-open rule y < p.y counts shared ends once. +1 upwards, -1
/// downwards.
int turn_about(const MonotonePiece& piece, const Vec2& p) {
    if ((piece.from.y() < p.y()) == (piece.to.y() < p.y())) return 0;
    if (p.x() >= std::max(piece.from.x(), piece.to.x())) return 0;
    const bool is_left = p.x() < std::min(piece.from.x(), piece.to.x()) || p.x() < x_at(piece, p.y());
    return is_left ? (piece.to.y() > piece.from.y() ? 1 : -1) : 0;
}

double rise(const MonotonePiece& piece) {
    return std::abs(piece.to.y() - piece.from.y());
}

int slab_of(const SlabbedPieces& slabs, double y) {
    const int n = static_cast<int>(slabs.first.size()) - 1;
    return static_cast<int>(std::clamp(std::floor((y - slabs.bottom) / slabs.height), 0.0, n - 1.0));
}

/// Calls visit(slab, piece) for all slabs that each piece reaches.
template <class Visit>
void for_slabs_of_pieces(const SlabbedPieces& slabs, Visit visit) {
    for (std::size_t k = 0; k < slabs.pieces.size(); ++k) {
        const int a = slab_of(slabs, slabs.pieces[k].from.y()), b = slab_of(slabs, slabs.pieces[k].to.y());
        for (int s = std::min(a, b); s <= std::max(a, b); ++s) visit(static_cast<std::size_t>(s), static_cast<int>(k));
    }
}

}  // namespace

MonotonePiece monotone_piece(int edge, const Curve& curve, double t0, double t1, const Vec2& from, const Vec2& to) {
    MonotonePiece piece{edge, t0, t1, from, to};
    if (const auto* arc = std::get_if<Arc>(&curve)) {
        const Vec2 d = point(curve, 0.5 * (t0 + t1)) - arc->center;
        piece.is_arc = true;
        piece.center = arc->center;
        piece.radius = arc->radius;
        piece.x_side = d.x() < 0 ? -1 : 1;
        piece.y_side = d.y() < 0 ? -1 : 1;
    } else if (!std::holds_alternative<Segment>(curve)) {
        piece.is_general = true;
        piece.curve = curve;
    }
    return piece;
}

std::vector<MonotonePiece> monotone_pieces(const Part& part) {
    std::vector<MonotonePiece> pieces;
    pieces.reserve(part.edges.size());
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
    if (piece.is_general) return general_meeting(piece, 0, x).at.y();
    double y = 0;
    if (piece.is_arc) {
        const double dx = x - piece.center.x();
        y = piece.center.y() + piece.y_side * std::sqrt(std::max(0.0, (piece.radius - dx) * (piece.radius + dx)));
    } else {
        y = piece.from.y() + (x - piece.from.x()) / (piece.to.x() - piece.from.x()) * (piece.to.y() - piece.from.y());
    }
    return between(y, piece.from.y(), piece.to.y());
}

double x_at(const MonotonePiece& piece, double y) {
    if (piece.is_general) return general_meeting(piece, 1, y).at.x();
    double x = 0;
    if (piece.is_arc) {
        const double dy = y - piece.center.y();
        x = piece.center.x() + piece.x_side * std::sqrt(std::max(0.0, (piece.radius - dy) * (piece.radius + dy)));
    } else {
        x = piece.from.x() + (y - piece.from.y()) / (piece.to.y() - piece.from.y()) * (piece.to.x() - piece.from.x());
    }
    return between(x, piece.from.x(), piece.to.x());
}

double dy_dx(const MonotonePiece& piece, double x) {
    return slope(piece, 0, x);
}

double dx_dy(const MonotonePiece& piece, double y) {
    return slope(piece, 1, y);
}

double parameter_at(const MonotonePiece& piece, const Vec2& p, const Curve& curve) {
    const double t = piece.is_general ? parameter_on_general(piece, p)
                     : piece.is_arc   ? parameter_on_arc(piece, p, std::get<Arc>(curve))
                                      : parameter_on_line(piece, p);
    return std::clamp(t, piece.t0, piece.t1);
}

LineMeeting line_meeting(const MonotonePiece& piece, int axis, double c, const Curve& curve) {
    if (piece.is_general) return general_meeting(piece, axis, c);
    const Vec2 at = axis == 0 ? Vec2(c, y_at(piece, c)) : Vec2(x_at(piece, c), c);
    return {at, parameter_at(piece, at, curve)};
}

bool contains(const std::vector<MonotonePiece>& pieces, const Vec2& p) {
    int winding = 0;
    for (const MonotonePiece& piece : pieces) winding += turn_about(piece, p);
    return winding > 0;
}

SlabbedPieces slabbed(std::vector<MonotonePiece> pieces) {
    SlabbedPieces slabs;
    slabs.pieces = std::move(pieces);
    Box2 box;
    double rises = 0;
    for (const MonotonePiece& piece : slabs.pieces) {
        box.extend(piece.from);
        rises += rise(piece);
    }
    // a piece is listed once, and once more for each slab boundary in its rise: with two slabs to the mean rise, three times
    const double n = static_cast<double>(slabs.pieces.size()), whole = rises > 0 ? box.size().y() : 0;
    const double n_slabs = whole > 0 ? std::clamp(std::floor(2 * n * whole / rises), 1.0, 2 * n) : 1;
    slabs.bottom = whole > 0 ? box.min.y() : 0;
    slabs.height = whole > 0 ? whole / n_slabs : 1;
    slabs.first.assign(static_cast<std::size_t>(n_slabs) + 1, 0);
    for_slabs_of_pieces(slabs, [&](std::size_t s, int) { ++slabs.first[s + 1]; });
    for (std::size_t s = 0; s + 1 < slabs.first.size(); ++s) slabs.first[s + 1] += slabs.first[s];
    slabs.piece.resize(static_cast<std::size_t>(slabs.first.back()));
    std::vector<int> next = slabs.first;
    for_slabs_of_pieces(slabs, [&](std::size_t s, int k) { slabs.piece[static_cast<std::size_t>(next[s]++)] = k; });
    return slabs;
}

bool contains(const SlabbedPieces& slabs, const Vec2& p) {
    const auto s = static_cast<std::size_t>(slab_of(slabs, p.y()));
    int winding = 0;
    for (int k = slabs.first[s]; k < slabs.first[s + 1]; ++k)
        winding += turn_about(slabs.pieces[static_cast<std::size_t>(slabs.piece[static_cast<std::size_t>(k)])], p);
    return winding > 0;
}

}  // namespace abut::geometry
