// SPDX-License-Identifier: GPL-3.0-or-later
// A run of points is an arc where
//   - a circle through its first and last point, with its centre where the others fit best, passes all within the tolerance;
//   - seen from the centre, every facet turns the same way, by at most largest_facet_turn;
//   - every facet's side is within the tolerance of the arc, too, or the facets are alike: none stands off by more than
//     most_sagitta_of_median times what most do, and the points are on the arc far more closely than the facets. What follows a
//     rounded corner is long beside its facets, and would bulge;
//   - it has at least least_facets facets.
// Runs are grown by doubling and then bisection: each costs O(n log n) of its own length, not of the polyline's.
#include "geometry/sketch/arc_fit.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/curves/numbers.hpp"

namespace abut::geometry {

namespace {

/// Points of a polyline from one of them on, around a closed one as far as wanted.
struct PolylineWalk {
    const std::vector<Vec2>& points;
    std::size_t start = 0;
    double written = 0;  ///< what rounding moves the points by
    const Vec2& operator[](std::size_t i) const { return points[(start + i) % points.size()]; }
    int index(std::size_t i) const { return static_cast<int>((start + i) % points.size()); }
};

// ---- lines ----

std::optional<FittedPiece> line_through(const PolylineWalk& p, std::size_t i, std::size_t j, double tolerance) {
    const Vec2 chord = p[j] - p[i];
    if (chord.norm() <= tolerance) return std::nullopt;
    const Vec2 u = chord.normalized();
    double residual = 0, last = 0;
    for (std::size_t k = i + 1; k < j; ++k) {
        const Vec2 d = p[k] - p[i];
        const double along = d.dot(u);
        residual = std::max(residual, std::abs(cross(u, d)));
        if (along < last - tolerance || residual > tolerance) return std::nullopt;  // it runs back, or leaves the line
        last = along;
    }
    if (last > chord.norm() + tolerance) return std::nullopt;
    return FittedPiece{Segment{p[i], p[j]}, p.index(i), p.index(j), residual};
}

// ---- arcs ----

/// Points written with a few digits, in units of their rounding: off the arc through two of them, or off the best circle of
/// all; and facets that stand off by no more than that.
constexpr double arc_of_written = 2, circle_of_written = 1.2, facets_of_written = 4;

/// Angle from first to last, seen from the centre, over all the points between; nothing if they turn back or too far at once.
std::optional<double> sweep_about(const PolylineWalk& p, std::size_t i, std::size_t j, const Vec2& center) {
    double sweep = 0;
    for (std::size_t k = i; k < j; ++k) {
        const double turn = angle_between(p[k] - center, p[k + 1] - center);
        if (turn == 0 || turn * sweep < 0 || std::abs(turn) > largest_facet_turn) return std::nullopt;
        sweep += turn;
    }
    return sweep;
}

/// h with |p_k - c(h)| = |p_i - c(h)| in the mean, c(h) = middle + h n: Newton's method for least squares, started from the
/// circle through the run's middle point. The squares' difference is linear in h, so that few steps do.
double best_offset(const PolylineWalk& p, std::size_t i, std::size_t j, const Vec2& middle, const Vec2& n, double half_chord) {
    const auto through = [&](const Vec2& q) {
        const Vec2 d = q - middle;
        return (d.squaredNorm() - half_chord * half_chord) / (2 * d.dot(n));
    };
    double h = through(p[(i + j) / 2]);
    constexpr int n_steps = 4;
    for (int step = 0; step < n_steps && std::isfinite(h); ++step) {
        const Vec2 c = middle + h * n;
        const double r = std::hypot(h, half_chord);
        double slope_squared = 0, slope_residual = 0;
        for (std::size_t k = i + 1; k < j; ++k) {
            const Vec2 d = p[k] - c;
            const double slope = -d.dot(n) / d.norm() - h / r;
            slope_squared += slope * slope;
            slope_residual += slope * (d.norm() - r);
        }
        if (!(slope_squared > 0)) break;
        h -= slope_residual / slope_squared;
    }
    return h;
}

/// How far each facet stands off the arc; the squares of their lengths over 8 R.
std::vector<double> sagittas(const PolylineWalk& p, std::size_t i, std::size_t j, double radius) {
    std::vector<double> found;
    found.reserve(j - i);
    for (std::size_t k = i; k < j; ++k) found.push_back((p[k + 1] - p[k]).squaredNorm() / (8 * radius));
    return found;
}

/// Do the sides of the facets, not their ends alone, say that they stand for the arc?
bool are_sides_of_arc(const PolylineWalk& p, std::size_t i, std::size_t j, double radius, double residual, double tolerance) {
    std::vector<double> of_facets = sagittas(p, i, j, radius);
    const double largest = *std::max_element(of_facets.begin(), of_facets.end());
    if (largest + residual <= std::max(tolerance, facets_of_written * p.written)) return true;
    const auto middle = of_facets.begin() + static_cast<std::ptrdiff_t>((of_facets.size() - 1) / 2);
    std::nth_element(of_facets.begin(), middle, of_facets.end());
    const double explained = std::min(2 * p.written, rounded_share * largest);
    return largest <= std::max(tolerance, most_sagitta_of_median * *middle) &&
           residual <= std::max(points_share * largest, explained);
}

double largest_miss(const PolylineWalk& p, std::size_t i, std::size_t j, const Vec2& center, double radius) {
    double largest = 0;
    for (std::size_t k = i; k <= j; ++k) largest = std::max(largest, std::abs((p[k] - center).norm() - radius));
    return largest;
}

Arc arc_from(const Vec2& center, const Vec2& first, double sweep) {
    const Vec2 d = first - center;
    return {center, d.norm(), std::atan2(d.y(), d.x()), sweep};
}

/// An arc through the points; their connections are another matter.
std::optional<FittedPiece> arc_through_points(const PolylineWalk& p, std::size_t i, std::size_t j, double tolerance) {
    if (j - i < least_facets) return std::nullopt;
    const Vec2 chord = p[j] - p[i], middle = 0.5 * (p[i] + p[j]);
    if (chord.norm() <= tolerance) return std::nullopt;
    const Vec2 n = left_of(chord).normalized();
    const double h = best_offset(p, i, j, middle, n, chord.norm() / 2);
    const Vec2 center = middle + h * n;
    if (!(std::abs(h) <= flattest_radius * chord.norm())) return std::nullopt;
    const double residual = largest_miss(p, i, j, center, (p[i] - center).norm());
    if (!(residual <= std::max(tolerance, arc_of_written * p.written))) return std::nullopt;
    const auto sweep = sweep_about(p, i, j, center);
    if (!sweep || std::abs(*sweep) >= two_pi) return std::nullopt;
    return FittedPiece{arc_from(center, p[i], *sweep), p.index(i), p.index(j), residual};
}

std::optional<FittedPiece> arc_through(const PolylineWalk& p, std::size_t i, std::size_t j, double tolerance) {
    std::optional<FittedPiece> arc = arc_through_points(p, i, j, tolerance);
    const bool is_arc = arc && are_sides_of_arc(p, i, j, std::get<Arc>(arc->curve).radius, arc->residual, tolerance);
    return is_arc ? arc : std::nullopt;
}

/// The least-squares circle of all points (Kasa's linear form), about their mean.
std::optional<Vec2> center_of_all(const std::vector<Vec2>& points) {
    Vec2 mean(0, 0);
    for (const Vec2& q : points) mean += q / static_cast<double>(points.size());
    double xx = 0, xy = 0, yy = 0;
    Vec2 right(0, 0);
    for (const Vec2& q : points) {
        const Vec2 d = q - mean;
        xx += d.x() * d.x();
        xy += d.x() * d.y();
        yy += d.y() * d.y();
        right += 0.5 * d.squaredNorm() * d;
    }
    const double det = xx * yy - xy * xy;
    if (!(det > 0)) return std::nullopt;
    return Vec2(mean + Vec2(yy * right.x() - xy * right.y(), xx * right.y() - xy * right.x()) / det);
}

/// A circle is given with no more digits than its points are written with: it is that one, if their rounding explains them.
void take_written(const PolylineWalk& p, std::size_t n, double written, Vec2& center, double& radius) {
    constexpr double beside = 1e-6;
    const double digit = std::sqrt(2.0) * written;
    const auto rounded = [&](double x) { return digit * std::round(x / digit); };
    const Vec2 at(rounded(center.x()), rounded(center.y()));
    if (!(largest_miss(p, 0, n, at, rounded(radius)) <= (1 + beside) * written)) return;
    radius = rounded(radius);
    center = at;
}

std::optional<FittedPiece> full_circle(const std::vector<Vec2>& points, double tolerance, double written) {
    if (points.size() < least_facets) return std::nullopt;
    std::optional<Vec2> center = center_of_all(points);
    if (!center) return std::nullopt;
    const PolylineWalk p{points, 0, written};
    const std::size_t n = points.size();
    double radius = 0;
    for (const Vec2& q : points) radius += (q - *center).norm() / static_cast<double>(n);
    if (written > 0) take_written(p, n, written, *center, radius);
    const double residual = largest_miss(p, 0, n, *center, radius);
    if (!(residual <= std::max(tolerance, circle_of_written * written)) ||
        !are_sides_of_arc(p, 0, n, radius, residual, tolerance))
        return std::nullopt;
    const auto sweep = sweep_about(p, 0, n, *center);
    // All facets turn one way: their sum is one turn, or more of a polyline that runs around several times.
    if (!sweep || std::abs(*sweep) > 1.5 * two_pi) return std::nullopt;
    Arc circle = arc_from(*center, points[0], std::copysign(two_pi, *sweep));
    circle.radius = radius;
    return FittedPiece{circle, 0, 0, residual};
}

// ---- runs ----

/// The longest run from i, at most to `end`, that the fit accepts: doubled while it does, then bisected.
template <class Fit>
std::optional<FittedPiece> longest(std::size_t i, std::size_t end, std::size_t least, const Fit& fit, std::size_t& reached) {
    if (i + least > end) return std::nullopt;
    std::optional<FittedPiece> best = fit(i, i + least);
    if (!best) return std::nullopt;
    std::size_t good = i + least, bad = end + 1;
    for (std::size_t step = 1; good < end && bad > end; step *= 2) {
        const std::size_t next = std::min(good + step, end);
        std::optional<FittedPiece> tried = fit(i, next);
        if (!tried) {
            bad = next;
            break;
        }
        best = tried;
        good = next;
    }
    while (bad <= end && bad - good > 1) {
        const std::size_t next = good + (bad - good) / 2;
        std::optional<FittedPiece> tried = fit(i, next);
        if (tried) best = tried;
        (tried ? good : bad) = next;
    }
    reached = good;
    return best;
}

/// Where vertices lie on their arc by far better than the tolerance, that tells where it ends: with the tolerance alone it
/// would take in what follows, as far as that stays near.
constexpr double exact_fraction = 1e-3;
/// The exact arc is taken if it has at least this part of the other's facets; what is drawn roughly is not broken up.
constexpr double exact_facet_share = 0.8;

struct ArcRun {
    FittedPiece piece;
    std::size_t first, last;
};

/// The arc that begins at i or, where the facet from i to i + 1 is not quite on it, one facet later.
std::optional<ArcRun> longest_arc(const PolylineWalk& p, std::size_t i, std::size_t end, double tolerance) {
    const auto within = [&](double limit) {
        return [&p, limit](std::size_t a, std::size_t b) { return arc_through(p, a, b, limit); };
    };
    std::size_t rough_end = i;
    const auto rough = longest(i, end, least_facets, within(tolerance), rough_end);
    if (!rough) return std::nullopt;
    for (const std::size_t begin : {i, i + 1}) {
        std::size_t exact_end = begin;
        const auto exact = longest(begin, end, least_facets, within(exact_fraction * tolerance), exact_end);
        if (exact && static_cast<double>(exact_end - begin) >= exact_facet_share * static_cast<double>(rough_end - i))
            return ArcRun{*exact, begin, exact_end};
    }
    return ArcRun{*rough, i, rough_end};
}

/// Pieces of the walk's points 0..end, greedily: the run that reaches farther, the line of two that reach as far.
std::vector<FittedPiece> fitted_pieces(const PolylineWalk& p, std::size_t end, double tolerance) {
    const auto as_line = [&](std::size_t i, std::size_t j) {
        return j == i + 1 ? std::optional(FittedPiece{Segment{p[i], p[j]}, p.index(i), p.index(j), 0})
                          : line_through(p, i, j, tolerance);
    };
    std::vector<FittedPiece> pieces;
    for (std::size_t i = 0; i < end;) {
        std::size_t line_end = i;
        const auto line = longest(i, end, 1, as_line, line_end);
        const auto arc = longest_arc(p, i, end, tolerance);
        const bool is_arc = arc && arc->last > line_end;
        if (is_arc && arc->first > i) pieces.push_back(*as_line(i, arc->first));
        pieces.push_back(is_arc ? arc->piece : *line);
        i = is_arc ? arc->last : line_end;
    }
    return pieces;
}

std::size_t begin_of_longest_facet(const std::vector<Vec2>& points) {
    std::size_t best = 0;
    double longest_facet = -1;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const double facet = (points[(k + 1) % points.size()] - points[k]).norm();
        if (facet <= longest_facet) continue;
        longest_facet = facet;
        best = k;
    }
    return best;
}

// ---- one curve ----

/// Points of the curve, as many on each of its smooth portions that nothing of it can hide between them.
std::vector<Vec2> sampled(const Curve& curve) {
    constexpr int per_portion = 64;
    const std::vector<double> breaks = smooth_cuts(curve);
    std::vector<Vec2> points{point(curve, 0)};
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        for (int k = 1; k <= per_portion; ++k)
            points.push_back(point(curve, breaks[i] + (breaks[i + 1] - breaks[i]) * k / per_portion));
    return points;
}

}  // namespace

std::vector<FittedPiece> fit_lines_and_arcs(const std::vector<Vec2>& points, bool closed, double tolerance, double written) {
    if (points.size() < 2) return {};
    if (!closed) return fitted_pieces({points, 0, written}, points.size() - 1, tolerance);
    if (auto circle = full_circle(points, tolerance, written)) return {*circle};
    // Where the runs begin matters on a closed polyline. From the longest facet, which is a line's if there are lines; then
    // once more from the first joint that was found, so that no run is cut in two where the first walk happened to begin.
    const PolylineWalk first{points, begin_of_longest_facet(points), written};
    const std::vector<FittedPiece> found = fitted_pieces(first, points.size(), tolerance);
    if (found.size() < 2) return found;
    return fitted_pieces({points, static_cast<std::size_t>(found[1].first), written}, points.size(), tolerance);
}

std::optional<Curve> as_line_or_arc(const Curve& curve, double tolerance) {
    if (std::holds_alternative<Segment>(curve) || std::holds_alternative<Arc>(curve)) return curve;
    std::vector<Vec2> points = sampled(curve);
    const PolylineWalk p{points};
    const std::size_t last = points.size() - 1;
    if ((points.back() - points.front()).norm() <= tolerance) {
        points.pop_back();
        const auto circle = full_circle(points, tolerance, 0);
        return circle ? std::optional(circle->curve) : std::nullopt;
    }
    if (const auto line = line_through(p, 0, last, tolerance)) return line->curve;
    const auto arc = arc_through_points(p, 0, last, tolerance);
    return arc ? std::optional(arc->curve) : std::nullopt;
}

}  // namespace abut::geometry
