// SPDX-License-Identifier: GPL-3.0-or-later
// 1. Turns and curvatures at the vertices between single facets; runs of them (arc_fit_curves.hpp).
// 2. A tangent at each vertex: of the circle through it and its neighbours. It lies between the directions of the two facets,
//    so that arcs which keep to it turn one way. At the ends of a run: of the arc through the outer facet that keeps to the
//    tangent of its other end; or the neighbour's tangent, if that is near.
// 3. Two arcs through two vertices with their tangents (of the pairs of arcs there are that with tangents of equal length,
//    Bolton, Biarc curves, Computer-Aided Design 7, 1975); one arc where that is near enough.
#include "geometry/sketch/arc_fit_curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/curves/arc_spline.hpp"

namespace abut::geometry {

namespace {

using std::size_t;

/// The tangent of what is beside a run is that of the curve if they differ by less than this part of the outer facet's turn.
constexpr double tangent_share = 0.25;
/// An arc whose points are off it by less than this part of the tolerance, and by less than its facets, is one: rounding to
/// single precision is less. Others may be pieces of a curve.
constexpr double exact_tolerance_share = 0.05;
/// Limits the work on vertices between two arcs, and how far these turn.
constexpr int most_spanned = 64;
constexpr double most_turn_spanned = 1.0;

Vec2 turned(const Vec2& v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

/// From one point along a tangent there to another.
Curve arc_along(const Vec2& from, const Vec2& tangent, const Vec2& to) {
    const Vec2 chord = to - from;
    const double angle = angle_between(tangent, chord);  // half the sweep
    if (2 * std::abs(std::sin(angle)) * flattest_radius <= 1) return Segment{from, to};
    const Vec2 center = 0.5 * (from + to) + left_of(chord) / (2 * std::tan(angle));
    const Vec2 spoke = from - center;
    return Arc{center, spoke.norm(), std::atan2(spoke.y(), spoke.x()), 2 * angle};
}

std::vector<Curve> arcs_between(const Vec2& from, const Vec2& t0, const Vec2& to, const Vec2& t1) {
    const Vec2 chord = to - from;
    const double begin = angle_between(t0, chord), end = angle_between(chord, t1);
    // One arc turns evenly: it misses both tangents by half the difference, and so may its neighbours.
    if (std::abs(begin - end) <= most_arc_kink) return {arc_along(from, turned(t0, 0.5 * (begin - end)), to)};
    // |to - d t1 - (from + d t0)| = 2 d
    const double along = chord.dot(t0 + t1), a = 2 * (1 - t0.dot(t1));
    const double d = chord.squaredNorm() / (along + std::sqrt(along * along + a * chord.squaredNorm()));
    const Vec2 joint = 0.5 * (from + d * t0 + to - d * t1);
    return {arc_along(from, t0, joint), reversed(arc_along(to, -t1, joint))};
}

double distance_from(const std::vector<Curve>& arcs, const Vec2& p) {
    double least = std::numeric_limits<double>::infinity();
    for (const Curve& arc : arcs) least = std::min(least, (point(arc, closest_parameter(arc, p)) - p).norm());
    return least;
}

/// Facets first..first + n - 1, counted on around the polyline. Vertices of a run have the numbers of the facets after them.
struct PolylineRun {
    int first = 0, n = 0;
    bool is_closed = false;
    std::vector<Vec2> tangents;  ///< n + 1
};

class FacetRuns {
public:
    FacetRuns(const std::vector<Vec2>& points, const std::vector<FittedPiece>& pieces, double tolerance)
        : points_(points),
          n_(static_cast<int>(points.size())),
          tolerance_(tolerance),
          is_free_(points.size(), false),
          is_taken_(points.size(), false),
          beside_(points.size()) {
        for (const FittedPiece& piece : pieces) {
            const int n_facets = n_facets_of(piece);
            const bool is_rough =
                n_facets < n_ && piece.residual > std::min(exact_tolerance_share * tolerance_, sagitta_of(piece));
            const bool is_free = n_facets == 1 || is_rough;
            for (int k = 0; k < n_facets; ++k) {
                is_free_[index(piece.first + k)] = is_free;
                beside_[index(piece.first + k)] = &piece;
            }
        }
        for (int k = 0; k < n_; ++k) turns_.push_back(angle_between(chord(k - 1), chord(k)));
    }

    std::vector<FacetCurve> curves() {
        std::vector<FacetCurve> found;
        for (PolylineRun& run : runs()) found.push_back(curve(run));
        std::sort(found.begin(), found.end(), [](const FacetCurve& a, const FacetCurve& b) { return a.first < b.first; });
        return found;
    }

private:
    size_t index(int k) const { return static_cast<size_t>(((k % n_) + n_) % n_); }
    const Vec2& at(int k) const { return points_[index(k)]; }
    Vec2 chord(int k) const { return at(k + 1) - at(k); }
    double turn(int k) const { return turns_[index(k)]; }
    double curvature_at(int k) const { return 2 * turn(k) / (chord(k - 1).norm() + chord(k).norm()); }

    int n_facets_of(const FittedPiece& piece) const {
        return piece.last > piece.first ? piece.last - piece.first : piece.last - piece.first + n_;
    }
    /// The farthest that facets stand off an arc.
    double sagitta_of(const FittedPiece& piece) const {
        const Arc* arc = std::get_if<Arc>(&piece.curve);
        double largest = 0;
        for (int k = 0; arc && k < n_facets_of(piece); ++k)
            largest = std::max(largest, chord(piece.first + k).squaredNorm() / (8 * arc->radius));
        return largest;
    }

    /// Is the arc that the facet belongs to farther from the points than the facets are from it?
    bool is_worse_than_facets(int facet) const {
        const FittedPiece& piece = *beside_[index(facet)];
        return std::holds_alternative<Arc>(piece.curve) && piece.residual > sagitta_of(piece);
    }

    bool is_smooth(int k) const {
        const double before = chord(k - 1).norm(), after = chord(k).norm();
        return is_free_[index(k - 1)] && is_free_[index(k)] && turn(k) != 0 && std::abs(turn(k)) <= largest_facet_turn &&
               std::max(before, after) <= most_length_step * std::min(before, after);
    }
    /// Do both vertices of the facet belong to one curve?
    bool goes_on(int facet) const {
        if (!is_smooth(facet) || !is_smooth(facet + 1)) return false;
        const double ratio = curvature_at(facet + 1) / curvature_at(facet);
        return ratio <= most_curvature_step && ratio * most_curvature_step >= 1;
    }

    // ---- runs ----

    std::vector<PolylineRun> runs() {
        if (n_ < least_facets) return {};
        int begin = 0;
        while (begin < n_ && goes_on(begin)) ++begin;
        std::vector<PolylineRun> found;
        if (begin == n_) {
            found.push_back({0, n_, true, {}});
        } else {
            for (int vertex = begin + 1; vertex <= begin + n_;) {  // the facet before does not go on
                int last = vertex;
                while (goes_on(last)) ++last;
                if (is_smooth(vertex)) add(vertex, last, found);
                vertex = last + 1;
            }
        }
        for (PolylineRun& run : found) set_inner_tangents(run);
        for (PolylineRun& run : found) set_end_tangents(run);
        agree_where_runs_meet(found);
        return found;
    }

    /// Of the vertices first..last and the facets at them, those no run has taken yet.
    void add(int first, int last, std::vector<PolylineRun>& found) {
        int begin = first - 1, end = last;  // facets
        if (first == last) return;
        if (is_taken_[index(begin)] || !is_like_others(begin, first, first, last)) ++begin;
        if (is_taken_[index(end)] || !is_like_others(end, last, first, last)) --end;
        end = std::min(end, begin + n_ - 1);
        while (begin <= end && beside_[index(begin - 1)] == beside_[index(begin)]) ++begin;  // whole pieces only
        while (begin <= end && beside_[index(end + 1)] == beside_[index(end)]) --end;
        const int n_facets = end - begin + 1;
        if (n_facets < least_facets || (n_facets == n_facets_of(*beside_[index(begin)]) && !is_worse_than_facets(begin)))
            return;
        for (int k = begin; k <= end; ++k) is_taken_[index(k)] = true;
        found.push_back({begin, n_facets, false, {}});
    }

    /// The outer facet at `vertex`; the others lie between the vertices first and last.
    bool is_like_others(int facet, int vertex, int first, int last) const {
        double most_turn = 0, most_sagitta = 0;
        for (int k = first; k < last; ++k) {
            const double curvature = 0.5 * std::abs(curvature_at(k) + curvature_at(k + 1)), own = chord(k).norm();
            most_turn = std::max(most_turn, curvature * own);
            most_sagitta = std::max(most_sagitta, curvature * own * own / 8);
        }
        const double turn = std::abs(curvature_at(vertex)) * chord(facet).norm(), sagitta = turn * chord(facet).norm() / 8;
        return turn <= most_turn_beyond_others * most_turn && sagitta <= most_sagitta_beyond_others * most_sagitta;
    }

    // ---- tangents ----

    /// Angles between a chord and the tangent at its end are those at the third point of the circle.
    void set_inner_tangents(PolylineRun& run) const {
        run.tangents.resize(static_cast<size_t>(run.n) + 1);
        for (int k = run.is_closed ? 0 : 1; k < run.n; ++k) {
            const int v = run.first + k;
            const double angle = angle_between(at(v + 1) - at(v - 1), chord(v));
            run.tangents[static_cast<size_t>(k)] = turned(chord(v - 1).normalized(), angle);
        }
        if (run.is_closed) run.tangents.back() = run.tangents.front();
    }

    /// The arc through the facet that has the tangent at its one end: its tangent at the other.
    static Vec2 mirrored(const Vec2& tangent, const Vec2& chord) {
        const Vec2 u = chord.normalized();
        return 2 * tangent.dot(u) * u - tangent;
    }

    void set_end_tangents(PolylineRun& run) const {
        if (run.is_closed) return;
        Vec2 &first = run.tangents.front(), &last = run.tangents.back();
        const Vec2 &second = run.tangents[1], &before_last = run.tangents[static_cast<size_t>(run.n) - 1];
        first = mirrored(second, chord(run.first));
        last = mirrored(before_last, chord(run.first + run.n - 1));
        const size_t before = index(run.first - 1), after = index(run.first + run.n);
        if (!is_taken_[before]) first = near_or(first, unit_tangent(beside_[before]->curve, 1), angle_between(first, second));
        if (!is_taken_[after]) last = near_or(last, unit_tangent(beside_[after]->curve, 0), angle_between(before_last, last));
    }

    static Vec2 near_or(const Vec2& own, const Vec2& neighbour, double facet_turn) {
        return std::abs(angle_between(own, neighbour)) <= tangent_share * std::abs(facet_turn) ? neighbour : own;
    }

    /// One curve whose curvature changed too fast for one run.
    void agree_where_runs_meet(std::vector<PolylineRun>& found) const {
        for (PolylineRun& run : found)
            for (PolylineRun& next : found) {
                if (run.is_closed || next.is_closed || index(run.first + run.n) != index(next.first)) continue;
                Vec2 &end = run.tangents.back(), &begin = next.tangents.front();
                const double least = std::min(std::abs(angle_between(run.tangents[static_cast<size_t>(run.n) - 1], end)),
                                              std::abs(angle_between(begin, next.tangents[1])));
                if (std::abs(angle_between(end, begin)) <= tangent_share * least) end = begin = (end + begin).normalized();
            }
    }

    // ---- arcs ----

    double facet_sagitta(const PolylineRun& run, int k) const {
        const auto i = static_cast<size_t>(k);
        return chord(run.first + k).norm() * std::abs(angle_between(run.tangents[i], run.tangents[i + 1])) / 8;
    }

    /// Facets from..to - 1 of the run as one or two arcs.
    struct Span {
        int to;
        std::vector<Curve> arcs;
        double residual;
    };
    Span span(const PolylineRun& run, int from, int to) const {
        const Vec2 &p = at(run.first + from), &q = at(run.first + to);
        Span found{to, arcs_between(p, run.tangents[static_cast<size_t>(from)], q, run.tangents[static_cast<size_t>(to)]), 0};
        for (int k = from; k <= to; ++k)
            found.residual = std::max(found.residual, distance_from(found.arcs, at(run.first + k)));
        return found;
    }

    Span longest_span(const PolylineRun& run, int from) const {
        Span best = span(run, from, from + 1);
        double least = facet_sagitta(run, from), turn_so_far = 0;
        for (int to = from + 2; to <= run.n && to - from <= most_spanned; ++to) {
            const double sagitta = facet_sagitta(run, to - 1);
            least = std::min(least, sagitta);
            turn_so_far += std::abs(turn(run.first + to - 1));
            if (sagitta > tolerance_ || turn_so_far > most_turn_spanned) break;
            Span longer = span(run, from, to);
            if (longer.residual > vertex_share * least) break;
            best = std::move(longer);
        }
        return best;
    }

    FacetCurve curve(const PolylineRun& run) const {
        FacetCurve found{{}, static_cast<int>(index(run.first)), static_cast<int>(index(run.first + run.n)), run.n, 0, 0};
        for (int k = 0; k < run.n; ++k) found.sagitta = std::max(found.sagitta, facet_sagitta(run, k));
        for (int from = 0; from < run.n;) {
            const Span next = facet_sagitta(run, from) > tolerance_ ? span(run, from, from + 1) : longest_span(run, from);
            found.arcs.insert(found.arcs.end(), next.arcs.begin(), next.arcs.end());
            found.residual = std::max(found.residual, next.residual);
            from = next.to;
        }
        return found;
    }

    const std::vector<Vec2>& points_;
    int n_;
    double tolerance_;
    std::vector<bool> is_free_;               ///< facet that may belong to a curve
    std::vector<bool> is_taken_;              ///< by a run
    std::vector<const FittedPiece*> beside_;  ///< the piece that a facet belongs to
    std::vector<double> turns_;               ///< at the beginning of each facet
};

}  // namespace

std::vector<FacetCurve> curves_through_facets(const std::vector<Vec2>& points, const std::vector<FittedPiece>& pieces,
                                              double tolerance) {
    return FacetRuns(points, pieces, tolerance).curves();
}

}  // namespace abut::geometry
