// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/general_meetings.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/curves/curve_meetings.hpp"
#include "geometry/curves/curve_polish.hpp"
#include "geometry/curves/piece_pairs.hpp"

namespace abut::geometry {

namespace {

/// Hits closer than this fraction of the curves' size are one.
constexpr double same_fraction = 1e-13;
/// Curvatures that differ by less, times the size, are the same: those of one curve at two computed places.
constexpr double same_bend = 1e-6;

struct Hit {
    ParameterPair t;
    Vec2 x{0, 0};
    bool lasting = false;  ///< an end of one of the curves or a touching point: kept even inside a shared stretch
};

class MeetingSearch {
public:
    MeetingSearch(const Curve& a, const Curve& b, double tolerance)
        : a_(a), b_(b), tolerance_(tolerance), size_a_(bounding_box(a).diagonal()), size_b_(bounding_box(b).diagonal()) {}

    std::vector<Hit> run() {
        for (const double end : {0.0, 1.0}) {
            keep({end, closest_parameter(b_, point(a_, end))}, true);
            keep({closest_parameter(a_, point(b_, end)), end}, true);
        }
        const PieceTree tree_a = piece_tree(a_, arc_spline_fraction * size_a_),
                        tree_b = piece_tree(b_, arc_spline_fraction * size_b_);
        const double reach = tolerance_ + tree_a.tolerance + tree_b.tolerance;
        visit_near(
            tree_a, tree_b, [&] { return reach; },
            [&](const ArcPiece& piece_a, const ArcPiece& piece_b) {
                for (const Vec2& p : meeting_points(piece_a.curve, piece_b.curve, reach))
                    try_start({parameter_near(a_, piece_a, p, reach), parameter_near(b_, piece_b, p, reach)});
            });
        sort_and_merge();
        drop_inside_shared();
        return hits_;
    }

private:
    /// Of the curve's point next to p, a point of one of its arcs. Where the curve turns sharply inside an arc, angles of the
    /// arc say little about its parameter.
    static double parameter_near(const Curve& curve, const ArcPiece& piece, const Vec2& p, double reach) {
        const double t = nearby_closest_parameter(curve, p, curve_parameter(piece, p));
        return (point(curve, t) - p).norm() <= 2 * reach ? t : closest_parameter(curve, p);
    }

    void try_start(const ParameterPair& start) {
        if (seen(start)) return;
        starts_.push_back(start);
        keep({start.a, nearby_closest_parameter(b_, point(a_, start.a), start.b)}, false);
        if (const auto crossing = polished_crossing(a_, b_, start)) keep(*crossing, false);
        const auto parallel = polished_parallel(a_, b_, start);
        if (!parallel) return;
        try_both_sides(*parallel);
    }

    /// Neighbouring arcs give the same start at their joint.
    bool seen(const ParameterPair& start) const {
        constexpr double same_start = 1e-9;
        const auto same = [&](const ParameterPair& t) {
            return std::abs(t.a - start.a) <= same_start && std::abs(t.b - start.b) <= same_start;
        };
        const auto recent = starts_.size() - std::min<std::size_t>(starts_.size(), 16);
        return std::any_of(starts_.begin() + static_cast<std::ptrdiff_t>(recent), starts_.end(), same);
    }

    /// In the frame of a's tangent b lies at height g + (kappa_b - kappa_a) s^2 / 2 over a. Where the curvatures are the same,
    /// the curves share a stretch, and the place found on it means nothing.
    void try_both_sides(const ParameterPair& t) {
        const Vec2 u = unit_tangent(a_, t.a);
        const double along = u.dot(unit_tangent(b_, t.b)) > 0 ? 1.0 : -1.0;
        const double height = cross(u, point(b_, t.b) - point(a_, t.a));
        const double bend = along * curvature(b_, t.b) - curvature(a_, t.a);
        keep(t, std::abs(bend) * std::max(size_a_, size_b_) > same_bend);
        const double squared = -2 * height / bend;
        if (!(squared > 0) || !std::isfinite(squared)) return;
        const double half = std::sqrt(squared), rate_a = half / derivative(a_, t.a).norm(),
                     rate_b = along * half / derivative(b_, t.b).norm();
        for (const double side : {-1.0, 1.0}) {
            const ParameterPair start{std::clamp(t.a + side * rate_a, 0.0, 1.0), std::clamp(t.b + side * rate_b, 0.0, 1.0)};
            if (const auto crossing = polished_crossing(a_, b_, start)) keep(*crossing, false);
        }
    }

    void keep(const ParameterPair& t, bool lasting) {
        const Vec2 p = point(a_, t.a), q = point(b_, t.b);
        if ((p - q).norm() > tolerance_) return;
        const bool end_of_b = t.b == 0 || t.b == 1;
        hits_.push_back({t, lasting && end_of_b ? q : p, lasting});
    }

    void sort_and_merge() {
        std::stable_sort(hits_.begin(), hits_.end(), [](const Hit& p, const Hit& q) {
            if (p.t.a != q.t.a) return p.t.a < q.t.a;
            return p.t.b != q.t.b ? p.t.b < q.t.b : p.lasting > q.lasting;
        });
        const double same = same_fraction * std::max(size_a_, size_b_);
        std::vector<Hit> kept;
        for (const Hit& hit : hits_) {
            if (!kept.empty() && (kept.back().x - hit.x).norm() <= same) {
                if (hit.lasting && !kept.back().lasting) kept.back() = hit;
                continue;
            }
            kept.push_back(hit);
        }
        hits_ = kept;
    }

    /// Do the curves stay together from one hit to the next? Asked at the middle only: where they part between hits and come
    /// together again, there is a hit at each place.
    bool together(const Hit& from, const Hit& to) const {
        const Vec2 p = point(a_, 0.5 * (from.t.a + to.t.a));
        const double near = nearby_closest_parameter(b_, p, 0.5 * (from.t.b + to.t.b));
        if ((point(b_, near) - p).norm() <= tolerance_) return true;
        return (point(b_, closest_parameter(b_, p)) - p).norm() <= tolerance_;
    }

    void drop_inside_shared() {
        std::vector<Hit> kept;
        bool before = false;
        for (std::size_t i = 0; i < hits_.size(); ++i) {
            const bool after = i + 1 < hits_.size() && together(hits_[i], hits_[i + 1]);
            if (hits_[i].lasting || !before || !after) kept.push_back(hits_[i]);
            before = after;
        }
        hits_ = kept;
    }

    const Curve &a_, &b_;
    double tolerance_, size_a_, size_b_;
    std::vector<ParameterPair> starts_;
    std::vector<Hit> hits_;
};

}  // namespace

std::vector<Vec2> general_meeting_points(const Curve& a, const Curve& b, double tolerance) {
    std::vector<Vec2> points;
    if (!bounding_box(a).overlaps(bounding_box(b), tolerance)) return points;
    for (const Hit& hit : MeetingSearch(a, b, tolerance).run()) points.push_back(hit.x);
    return points;
}

}  // namespace abut::geometry
