// SPDX-License-Identifier: GPL-3.0-or-later
// 1. Turns and curvatures at the vertices between single facets; runs of them (arc_fit_curves.hpp).
// 2. A tangent at each vertex: of the circle through it and its neighbours. It lies between the directions of the two facets,
//    so that arcs which keep to it turn one way. At the ends of a run: of the arc through the outer facet that keeps to the
//    tangent of its other end; or the neighbour's tangent, if that is near.
// 3. Two arcs through two vertices with their tangents (of the pairs of arcs there are that with tangents of equal length,
//    Bolton, Biarc curves, Computer-Aided Design 7, 1975), over as many facets as the vertices between allow.
#include "geometry/arc_fit_curves.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace abut::geometry {

namespace {

using std::size_t;

/// The tangent of what is beside a run is that of the curve if they differ by less than this part of the outer facet's turn.
constexpr double tangent_share = 0.25;
/// Two arcs whose angles with the chord differ by less, radians, are one.
constexpr double equal_angles = 1e-9;
/// Radius of an arc in units of its chord: a flatter one is a line.
constexpr double flattest_radius = 1e5;
/// Limits the work on vertices between two arcs, and how far these turn.
constexpr int most_spanned = 8;
constexpr double most_turn_spanned = 1.0;

double angle_between(const Vec2& a, const Vec2& b) {
    return std::atan2(cross(a, b), a.dot(b));
}

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
    if (std::abs(angle_between(t0, chord) - angle_between(chord, t1)) <= equal_angles) return {arc_along(from, t0, to)};
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
struct Run {
    int first = 0, n = 0;
    bool is_closed = false;
    std::vector<Vec2> tangents;  ///< n + 1
};

class FacetRuns {
public:
    FacetRuns(const std::vector<Vec2>& points, const std::vector<FittedPiece>& pieces)
        : points_(points), n_(static_cast<int>(points.size())), is_single_(points.size(), false), is_taken_(points.size(), false),
          beside_(points.size()) {
        for (const FittedPiece& piece : pieces) {
            const int n_facets = piece.last > piece.first ? piece.last - piece.first : piece.last - piece.first + n_;
            is_single_[index(piece.first)] = n_facets == 1;
            for (int k = 0; k < n_facets; ++k) beside_[index(piece.first + k)] = &piece.curve;
        }
        for (int k = 0; k < n_; ++k) turns_.push_back(angle_between(chord(k - 1), chord(k)));
    }

    std::vector<FacetCurve> curves() {
        std::vector<FacetCurve> found;
        for (Run& run : runs()) found.push_back(curve(run));
        std::sort(found.begin(), found.end(), [](const FacetCurve& a, const FacetCurve& b) { return a.first < b.first; });
        return found;
    }

private:
    size_t index(int k) const { return static_cast<size_t>(((k % n_) + n_) % n_); }
    const Vec2& at(int k) const { return points_[index(k)]; }
    Vec2 chord(int k) const { return at(k + 1) - at(k); }
    double turn(int k) const { return turns_[index(k)]; }
    double curvature_at(int k) const { return 2 * turn(k) / (chord(k - 1).norm() + chord(k).norm()); }

    bool is_smooth(int k) const {
        const double before = chord(k - 1).norm(), after = chord(k).norm();
        return is_single_[index(k - 1)] && is_single_[index(k)] && turn(k) != 0 && std::abs(turn(k)) <= largest_facet_turn &&
               std::max(before, after) <= most_length_step * std::min(before, after);
    }
    /// Do both vertices of the facet belong to one curve?
    bool goes_on(int facet) const {
        if (!is_smooth(facet) || !is_smooth(facet + 1)) return false;
        const double ratio = curvature_at(facet + 1) / curvature_at(facet);
        return ratio <= most_curvature_step && ratio * most_curvature_step >= 1;
    }

    // ---- runs ----

    std::vector<Run> runs() {
        if (n_ < least_facets) return {};
        int begin = 0;
        while (begin < n_ && goes_on(begin)) ++begin;
        std::vector<Run> found;
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
        for (Run& run : found) set_inner_tangents(run);
        for (Run& run : found) set_end_tangents(run);
        agree_where_runs_meet(found);
        return found;
    }

    /// Of the vertices first..last and the facets at them, those no run has taken yet.
    void add(int first, int last, std::vector<Run>& found) {
        int begin = first - 1, end = last;  // facets
        if (first == last) return;
        if (is_taken_[index(begin)] || !is_like_others(begin, first, first, last)) ++begin;
        if (is_taken_[index(end)] || !is_like_others(end, last, first, last)) --end;
        end = std::min(end, begin + n_ - 1);
        const int n_facets = end - begin + 1;
        if (n_facets < least_facets) return;
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
    void set_inner_tangents(Run& run) const {
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

    void set_end_tangents(Run& run) const {
        if (run.is_closed) return;
        Vec2 &first = run.tangents.front(), &last = run.tangents.back();
        const Vec2 &second = run.tangents[1], &before_last = run.tangents[static_cast<size_t>(run.n) - 1];
        first = mirrored(second, chord(run.first));
        last = mirrored(before_last, chord(run.first + run.n - 1));
        const size_t before = index(run.first - 1), after = index(run.first + run.n);
        if (!is_taken_[before]) first = near_or(first, unit_tangent(*beside_[before], 1), angle_between(first, second));
        if (!is_taken_[after]) last = near_or(last, unit_tangent(*beside_[after], 0), angle_between(before_last, last));
    }

    static Vec2 near_or(const Vec2& own, const Vec2& neighbour, double facet_turn) {
        return std::abs(angle_between(own, neighbour)) <= tangent_share * std::abs(facet_turn) ? neighbour : own;
    }

    /// One curve whose curvature changed too fast for one run.
    void agree_where_runs_meet(std::vector<Run>& found) const {
        for (Run& run : found)
            for (Run& next : found) {
                if (run.is_closed || next.is_closed || index(run.first + run.n) != index(next.first)) continue;
                Vec2 &end = run.tangents.back(), &begin = next.tangents.front();
                const double least = std::min(std::abs(angle_between(run.tangents[static_cast<size_t>(run.n) - 1], end)),
                                              std::abs(angle_between(begin, next.tangents[1])));
                if (std::abs(angle_between(end, begin)) <= tangent_share * least) end = begin = (end + begin).normalized();
            }
    }

    // ---- arcs ----

    double facet_sagitta(const Run& run, int k) const {
        const double sweep = std::abs(angle_between(run.tangents[static_cast<size_t>(k)], run.tangents[static_cast<size_t>(k) + 1]));
        return chord(run.first + k).norm() * sweep / 8;
    }

    struct Span {
        std::vector<Curve> arcs;
        double residual = 0;
    };
    std::vector<Curve> arcs_over(const Run& run, int from, int to) const {
        return arcs_between(at(run.first + from), run.tangents[static_cast<size_t>(from)], at(run.first + to),
                            run.tangents[static_cast<size_t>(to)]);
    }
    std::optional<Span> span(const Run& run, int from, int to, double allowed) const {
        Span found{arcs_over(run, from, to), 0};
        for (int k = from + 1; k < to; ++k) found.residual = std::max(found.residual, distance_from(found.arcs, at(run.first + k)));
        return found.residual <= allowed ? std::optional(found) : std::nullopt;
    }

    FacetCurve curve(const Run& run) const {
        FacetCurve found;
        found.first = static_cast<int>(index(run.first));
        found.last = static_cast<int>(index(run.first + run.n));
        found.n_facets = run.n;
        for (int from = 0; from < run.n;) {
            int to = from + 1;
            double least = facet_sagitta(run, from), turn_so_far = std::abs(turn_of(run, from));
            Span best{arcs_over(run, from, to), 0};
            found.sagitta = std::max(found.sagitta, least);
            for (int next = to + 1; next <= run.n && next - from <= most_spanned; ++next) {
                least = std::min(least, facet_sagitta(run, next - 1));
                turn_so_far += std::abs(turn_of(run, next - 1));
                if (turn_so_far > most_turn_spanned) break;
                const auto longer = span(run, from, next, vertex_share * least);
                if (!longer) break;
                best = *longer;
                to = next;
                found.sagitta = std::max(found.sagitta, facet_sagitta(run, next - 1));
            }
            found.residual = std::max(found.residual, best.residual);
            found.arcs.insert(found.arcs.end(), best.arcs.begin(), best.arcs.end());
            from = to;
        }
        return found;
    }
    static double turn_of(const Run& run, int facet) {
        return angle_between(run.tangents[static_cast<size_t>(facet)], run.tangents[static_cast<size_t>(facet) + 1]);
    }

    const std::vector<Vec2>& points_;
    int n_;
    std::vector<bool> is_single_;         ///< facet that is a piece by itself, and a line
    std::vector<bool> is_taken_;          ///< by a run
    std::vector<const Curve*> beside_;    ///< the piece that a facet belongs to
    std::vector<double> turns_;           ///< at the beginning of each facet
};

}  // namespace

std::vector<FacetCurve> curves_through_facets(const std::vector<Vec2>& points, const std::vector<FittedPiece>& pieces) {
    return FacetRuns(points, pieces).curves();
}

}  // namespace abut::geometry
