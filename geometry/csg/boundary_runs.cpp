// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/boundary_runs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/csg/junction.hpp"
#include "geometry/curves/numbers.hpp"

namespace abut::geometry {

namespace {

/// Turns within this of a full one, radians, are the start itself: rounding of atan2.
constexpr double turn_rounding = 1e-12;

bool is_closed_spline(const Curve& curve, double rounding) {
    return std::holds_alternative<Spline>(curve) && (point(curve, 0) - point(curve, 1)).norm() <= rounding;
}

/// +1 where the second piece begins behind the source's seam that the first one ends at, -1 against the source's direction.
int seam_between(const RawPiece& a, const RawPiece& b) {
    if (a.along && a.t1 == 1 && b.t0 == 0) return 1;
    if (!a.along && a.t0 == 0 && b.t1 == 1) return -1;
    return 0;
}

/// The parameter at a piece's end p, on the source near the portion that the piece's arc follows.
double parameter_near(const Curve& source, const Vec2& p, const RawPiece& piece) {
    const double to_begin = (p - point(source, piece.t0)).norm(), to_end = (p - point(source, piece.t1)).norm();
    const double range = piece.t1 - piece.t0;
    const double guess = piece.t0 + range * (to_begin + to_end > 0 ? to_begin / (to_begin + to_end) : 0.5);
    return local_parameter(source, p, guess, range);
}

RunEnd run_end(const Curve& source, const Vec2& p, const RawPiece& piece) {
    return {p, is_general(source) ? parameter_near(source, p, piece) : 0.0, p};
}

/// p, or the source's own end where that is the same point.
Vec2 snapped(const Vec2& p, const Curve& source, double rounding) {
    const Vec2 a = point(source, 0), b = point(source, 1);
    const Vec2& end = (a - p).norm() <= (b - p).norm() ? a : b;
    return (end - p).norm() <= rounding ? end : p;
}

/// Arc length on a line of the end that comes first, over the line's length. Negative on a half plane's behind its point.
double parameter_on_line(const Segment& line, const Vec2& p) {
    const Vec2 d = line.to - line.from;
    return (p - line.from).dot(d) / d.squaredNorm();
}

Piece restored_line(const Run& run, const Curve& source, double rounding) {
    const Segment& line = std::get<Segment>(source);
    const Segment piece{snapped(run.from.at, source, rounding), snapped(run.to.at, source, rounding)};
    return {piece, run.source, parameter_on_line(line, piece.from), parameter_on_line(line, piece.to)};
}

/// The angle of p on the arc's circle: the source's own where p is one of its ends.
double angle_of(const Vec2& p, const Arc& source, double rounding) {
    if ((point(source, 0) - p).norm() <= rounding) return source.start;
    if ((point(source, 1) - p).norm() <= rounding) return source.start + source.sweep;
    const Vec2 d = p - source.center;
    return std::atan2(d.y(), d.x());
}

/// Parameter on the source's circle of the angle where a piece begins, in [0, one turn).
double parameter_on_circle(const Arc& source, double angle) {
    double turn = std::fmod((angle - source.start) * (source.sweep > 0 ? 1 : -1), two_pi);
    if (turn < 0) turn += two_pi;
    const double behind = two_pi - std::abs(source.sweep);  // the part of the circle that the source leaves out
    if (turn > two_pi - std::max(turn_rounding, behind / 2)) turn = 0;
    return turn / std::abs(source.sweep);
}

Piece restored_arc(const Run& run, const Curve& source, double rounding) {
    const Arc& own = std::get<Arc>(source);
    const int turn = (own.sweep > 0) == run.along ? 1 : -1;
    Arc arc{own.center, own.radius, own.start, turn * two_pi};
    if (!run.whole) {
        arc.start = angle_of(run.from.at, own, rounding);
        const double end = angle_of(run.to.at, own, rounding);
        double turned = std::fmod((end - arc.start) * turn, two_pi);
        if (turned <= 0) turned += two_pi;
        arc.sweep = turn * turned;
    }
    const double first = parameter_on_circle(own, run.along ? arc.start : arc.start + arc.sweep);
    const double last = first + std::abs(arc.sweep / own.sweep);
    return run.along ? Piece{arc, run.source, first, last} : Piece{arc, run.source, last, first};
}

Piece restored_general(const Run& run, const Curve& source) {
    double from = run.from.t, to = run.to.t + run.seams;
    if (run.whole) {
        from = run.along ? 0 : 1;
        to = 1 - from;
    }
    if (is_full(source)) shift_into_first_turn(from, to);
    const Curve curve = from < to ? trimmed(source, from, to) : reversed(trimmed(source, to, from));
    return {curve, run.source, from, to};
}

}  // namespace

bool is_general(const Curve& curve) {
    return !std::holds_alternative<Segment>(curve) && !std::holds_alternative<Arc>(curve);
}

bool is_full(const Curve& curve) {
    if (const auto* arc = std::get_if<Arc>(&curve)) return std::abs(arc->sweep) == two_pi;
    if (const auto* arc = std::get_if<EllipticArc>(&curve)) return std::abs(arc->sweep) == two_pi;
    return false;
}

void shift_into_first_turn(double& t_begin, double& t_end) {
    double& low = t_begin < t_end ? t_begin : t_end;
    const double turns = std::floor(low + turn_rounding);
    t_begin -= turns;
    t_end -= turns;
    if (low <= turn_rounding) low = 0;
}

std::vector<Run> runs_of(std::vector<RawPiece> loop, const std::vector<PlacedSource>& sources, double rounding) {
    const auto curve = [&](const RawPiece& piece) -> const Curve& {
        return sources[static_cast<std::size_t>(piece.source)].curve;
    };
    const auto goes_on = [&](const RawPiece& a, const RawPiece& b) {
        return a.source == b.source && a.along == b.along && !(is_closed_spline(curve(a), rounding) && seam_between(a, b) != 0);
    };
    std::size_t start = 0;  // a piece that does not go on from the one before it
    while (start < loop.size() && goes_on(loop[(start + loop.size() - 1) % loop.size()], loop[start])) ++start;
    const bool whole = start == loop.size();
    if (!whole) std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(start), loop.end());
    std::vector<Run> runs;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const RawPiece& piece = loop[i];
        if (i > 0 && goes_on(loop[i - 1], piece)) {
            runs.back().seams += std::holds_alternative<EllipticArc>(curve(piece)) ? seam_between(loop[i - 1], piece) : 0;
        } else {
            runs.push_back({piece.source, piece.along, run_end(curve(piece), piece.from, piece), {}, 0, whole});
        }
        runs.back().to.at = piece.to;
        if (i + 1 == loop.size() || !goes_on(piece, loop[i + 1])) runs.back().to = run_end(curve(piece), piece.to, piece);
    }
    return runs;
}

bool goes_on(const Run& a, const Run& b, const Curve& source) {
    if (a.source != b.source || a.along != b.along) return false;
    return !std::holds_alternative<Spline>(source) || std::lround(a.to.t - b.from.t) == 0;
}

double run_length(const Run& run, const Curve& source) {
    const double sign = run.along ? 1 : -1;
    if (const auto* line = std::get_if<Segment>(&source))
        return sign * (run.to.at - run.from.at).dot((line->to - line->from).normalized());
    if (const auto* own = std::get_if<Arc>(&source)) {
        if (run.whole) return two_pi * own->radius;
        const double turn = own->sweep > 0 ? sign : -sign;
        const auto angle = [&](const Vec2& from, const Vec2& to) {
            const Vec2 a = from - own->center, b = to - own->center;
            return turn * angle_between(a, b);
        };
        double turned = angle(run.from.vertex, run.to.vertex);
        if (turned <= 0) turned += two_pi;
        return own->radius * (turned + angle(run.to.vertex, run.to.at) - angle(run.from.vertex, run.from.at));
    }
    return run.whole ? length(source) : sign * length(source, run.from.t, run.to.t + run.seams);
}

Piece restored(const Run& run, const Curve& source, const MergeLengths& lengths) {
    if (std::holds_alternative<Segment>(source)) return restored_line(run, source, lengths.rounding);
    if (std::holds_alternative<Arc>(source)) return restored_arc(run, source, lengths.rounding);
    return restored_general(run, source);
}

}  // namespace abut::geometry
