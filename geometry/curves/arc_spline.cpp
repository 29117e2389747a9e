// SPDX-License-Identifier: GPL-3.0-or-later
// Joints are sought on the whole ellipse, or the whole shape of a spline, in its own direction, and only then cut to the
// portion that the curve is: curves that share a stretch share the arcs that follow it, whichever way they run.
#include "geometry/curves/arc_spline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/curves/arc_portion.hpp"
#include "geometry/curves/general_curve.hpp"
#include "geometry/curves/homogeneous_span.hpp"
#include "geometry/curves/numbers.hpp"

namespace abut::geometry {

namespace {

/// Below this fraction of the curve's size rounding decides what is within tolerance.
constexpr double least_tolerance = 64 * epsilon;

/// The ellipse by its eccentric angle or the spline's whole shape, and the portion of it that the curve is.
struct WholeCurve {
    Curve curve;                 ///< parameter u = t: of an ellipse, start 0 and sweep 1
    double lo, hi;               ///< the portion, lo < hi
    bool backwards;              ///< does the original run from hi to lo?
    std::vector<double> breaks;  ///< joints there must be: ascending, from the last not above lo to the first not below hi
    double smallest = 0;         ///< shorter portions need no arc
};

/// Both roundings together give the same two angles for an arc and its reverse: ((x + w) - w) + w - w = (x + w) - w in doubles
/// [Knuth, The Art of Computer Programming 2, 4.2.2, theorem D].
std::pair<double, double> angles(const EllipticArc& arc) {
    const double w = std::abs(arc.sweep);
    double x = arc.start;
    if (arc.sweep < 0) x = x - w;
    x = x + w;
    const double lo = x - w;
    return {lo, lo + w};
}

WholeCurve whole_ellipse(const EllipticArc& arc) {
    const auto [lo, hi] = angles(arc);
    WholeCurve whole{EllipticArc{arc.center, arc.a, arc.b, 0, 1}, lo, hi, arc.sweep < 0, {}, 0};
    const double half_turn = std::numbers::pi;
    const double first = std::atan2(arc.b.x(), arc.a.x()), second = std::atan2(arc.b.y(), arc.a.y());
    for (double k = std::floor(lo / half_turn) - 2; k * half_turn < hi + 2 * half_turn; ++k)
        for (const double root : {first, second}) whole.breaks.push_back(root + k * half_turn);
    std::sort(whole.breaks.begin(), whole.breaks.end());
    return whole;
}

WholeCurve whole_spline(const Spline& spline) {
    const SplineShape& shape = *spline.shape;
    WholeCurve whole{Spline{spline.shape, 0, 1},
                     std::min(spline.begin, spline.end),
                     std::max(spline.begin, spline.end),
                     spline.end < spline.begin,
                     shape.breaks,
                     0};
    for (const int axis : {0, 1})
        for (const double u : stationary_parameters(shape, axis)) whole.breaks.push_back(u);
    std::sort(whole.breaks.begin(), whole.breaks.end());
    return whole;
}

/// Roundings of a parameter within which two joints are one.
double parameter_rounding(const WholeCurve& whole) {
    return 8 * epsilon * std::max({1.0, std::abs(whole.lo), std::abs(whole.hi)});
}

/// Only what bounds the portion, and no two within rounding.
void cut_breaks(WholeCurve& whole) {
    std::vector<double>& b = whole.breaks;
    const double rounding = parameter_rounding(whole);
    b.erase(std::unique(b.begin(), b.end(), [&](double x, double y) { return y - x <= rounding; }), b.end());
    const auto first = std::upper_bound(b.begin(), b.end(), whole.lo + rounding);
    b.erase(b.begin(), std::prev(first));
    b.erase(std::next(std::lower_bound(b.begin(), b.end(), whole.hi - rounding)), b.end());
}

/// The portion [u0, u1], inside one span, relative to its point at u0.
HomogeneousSpan span_between(const WholeCurve& whole, double u0, double u1, const Vec2& origin) {
    if (const auto* arc = std::get_if<EllipticArc>(&whole.curve)) return homogeneous_span(*arc, u0, u1, origin);
    const SplineShape& shape = *std::get<Spline>(whole.curve).shape;
    const auto behind = std::upper_bound(shape.breaks.begin() + 1, shape.breaks.end() - 1, 0.5 * (u0 + u1));
    const auto k = static_cast<std::size_t>(behind - shape.breaks.begin()) - 1;
    const double begin = shape.breaks[k], width = shape.breaks[k + 1] - begin;
    return portion(homogeneous_span(shape, k, origin), std::max(0.0, (u0 - begin) / width),
                   std::min(1.0, (u1 - begin) / width));
}

/// A monotone portion lies in the box of its ends: one this small, as a fraction of the curve's size and of the tolerance,
/// needs no arc. Without this the halving would not end beside a point where the curve stands still, whose tangents turn within
/// rounding.
constexpr double smallest_portion = 1e-9, smallest_of_tolerance = 0.5;

ArcFit fit(const WholeCurve& whole, double u0, double u1, const ArcBounds& bounds) {
    const auto first = general_values(whole.curve, u0), last = general_values(whole.curve, u1);
    if ((last[0] - first[0]).norm() <= whole.smallest) return {Segment{first[0], last[0]}, 1};
    const Portion portion{first[0],
                          general_values(whole.curve, 0.5 * (u0 + u1))[0],
                          last[0],
                          first[1].normalized(),
                          last[1].normalized(),
                          span_between(whole, u0, u1, first[0])};
    return fit_arc(portion, bounds);
}

struct PieceOfWhole {
    double u0, u1;
    Curve curve;
};

/// One arc, or halves until they fit.
void append(std::vector<PieceOfWhole>& pieces, const WholeCurve& whole, double u0, double u1, const ArcBounds& bounds) {
    const ArcFit found = fit(whole, u0, u1, bounds);
    const double middle = 0.5 * (u0 + u1);
    if (found.excess <= 1 || !(u0 < middle && middle < u1)) {
        pieces.push_back({u0, u1, found.curve});
        return;
    }
    append(pieces, whole, u0, middle, bounds);
    append(pieces, whole, middle, u1, bounds);
}

/// The excess grows with the third power of a piece's length; steps aim at this much of it.
constexpr double aim = 0.8;
/// The most that a step may grow, and shrink, at once.
constexpr double most_growth = 4, most_shrinkage = 0.25;

double growth(double excess) {
    return std::clamp(std::cbrt(aim / excess), most_shrinkage, most_growth);
}

/// A step along the curve, and the arc of the piece where that is known.
struct Step {
    double length;
    std::optional<Curve> arc{};
};

/// The longest step from u that keeps the bounds, or nearly so; `guess` is the one before it.
Step longest_step(const WholeCurve& whole, double u, double u1, double guess, const ArcBounds& bounds) {
    constexpr int most_trials = 4;
    constexpr double worthwhile = 1.2, slower = 0.9;
    double step = std::min(guess, u1 - u);
    ArcFit found = fit(whole, u, u + step, bounds);
    for (int trial = 0; trial < most_trials && found.excess <= 1 && step < u1 - u; ++trial) {
        const double factor = growth(found.excess);
        if (factor < worthwhile) return {step, found.curve};
        step = std::min(factor * step, u1 - u);
        found = fit(whole, u, u + step, bounds);
    }
    while (found.excess > 1 && step > parameter_rounding(whole)) {
        step *= std::min(slower, growth(found.excess));
        found = fit(whole, u, u + step, bounds);
    }
    if (found.excess > 1) return {step};
    return {step, found.curve};
}

/// The end of a piece, and its arc where that is known.
struct PieceEnd {
    double u;
    std::optional<Curve> arc{};
};

/// Pieces from one break to the next; the first end is the begin of all.
std::vector<PieceEnd> ends_between(const WholeCurve& whole, double u0, double u1, const ArcBounds& bounds) {
    std::vector<PieceEnd> ends{{u0}};
    Step step{u1 - u0};
    while (ends.back().u < u1) {
        const double u = ends.back().u;
        step = longest_step(whole, u, u1, step.length, bounds);
        const double left = u1 - u - step.length;
        if (left > 0 && left < step.length) step = {0.5 * (u1 - u)};  // the last two are equal: no sliver at the end
        const double end = left > 0 ? u + step.length : u1;
        ends.push_back({end, end == u + step.length ? step.arc : std::nullopt});
    }
    return ends;
}

/// A joint within this fraction of its pieces from an end of the portion would leave a sliver there.
constexpr double sliver_of_piece = 0.25;

/// The portion's ends and the joints between them. An arc is known of pieces that the portion does not cut.
std::vector<PieceEnd> portion_ends(const WholeCurve& whole, const ArcBounds& bounds) {
    std::vector<PieceEnd> ends{{whole.lo}};
    for (std::size_t i = 0; i + 1 < whole.breaks.size(); ++i) {
        std::vector<PieceEnd> here = ends_between(whole, whole.breaks[i], whole.breaks[i + 1], bounds);
        const auto add = [&](double u, std::size_t k) {
            const bool is_whole = ends.back().u == here[k - 1].u && u == here[k].u;
            ends.push_back({u, is_whole ? std::move(here[k].arc) : std::nullopt});
        };
        for (std::size_t k = 1; k + 1 < here.size(); ++k)
            if (here[k].u - whole.lo > sliver_of_piece * (here[k].u - here[k - 1].u) &&
                whole.hi - here[k].u > sliver_of_piece * (here[k + 1].u - here[k].u))
                add(here[k].u, k);
        add(i + 2 < whole.breaks.size() ? here.back().u : whole.hi, here.size() - 1);
    }
    return ends;
}

ArcPiece as_part_of(const Curve& curve, const WholeCurve& whole, const PieceOfWhole& piece) {
    const auto parameter = [&](double u) {
        if (u == whole.lo) return whole.backwards ? 1.0 : 0.0;
        if (u == whole.hi) return whole.backwards ? 0.0 : 1.0;
        if (const auto* arc = std::get_if<EllipticArc>(&curve)) return (u - arc->start) / arc->sweep;
        const Spline& spline = std::get<Spline>(curve);
        return (u - spline.begin) / (spline.end - spline.begin);
    };
    const double a = parameter(piece.u0), b = parameter(piece.u1);
    if (whole.backwards) return {reversed(piece.curve), b, a};
    return {piece.curve, a, b};
}

}  // namespace

std::vector<ArcPiece> arc_spline(const Curve& curve, ArcBounds bounds) {
    std::vector<ArcPiece> result;
    if (std::holds_alternative<Segment>(curve) || std::holds_alternative<Arc>(curve)) {
        result.push_back({curve, 0, 1});
        return result;
    }
    const auto* arc = std::get_if<EllipticArc>(&curve);
    WholeCurve whole = arc ? whole_ellipse(*arc) : whole_spline(std::get<Spline>(curve));
    cut_breaks(whole);
    const double size = bounding_box(curve).diagonal();
    bounds.tolerance = std::max(bounds.tolerance, least_tolerance * size);
    whole.smallest = std::min(smallest_portion * size, smallest_of_tolerance * bounds.tolerance);
    std::vector<PieceEnd> ends = portion_ends(whole, bounds);
    std::vector<PieceOfWhole> pieces;
    for (std::size_t i = 1; i < ends.size(); ++i) {
        const double u0 = ends[i - 1].u, u1 = ends[i].u;
        if (ends[i].arc)
            pieces.push_back({u0, u1, std::move(*ends[i].arc)});
        else
            append(pieces, whole, u0, u1, bounds);
    }
    for (const PieceOfWhole& piece : pieces) result.push_back(as_part_of(curve, whole, piece));
    if (whole.backwards) std::reverse(result.begin(), result.end());
    return result;
}

}  // namespace abut::geometry
