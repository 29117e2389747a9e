// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/closest_points.hpp"

#include <algorithm>

#include "geometry/brep/edge_tree.hpp"
#include "geometry/curves/curve_meetings.hpp"
#include "geometry/curves/curve_polish.hpp"
#include "geometry/curves/piece_pairs.hpp"
#include "geometry/curves/tangent_ball.hpp"
#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

/// Differences below this fraction of the size do not make another pair the closer one: equal distances come out in any order.
constexpr double rounding_fraction = 1e-14;

class ClosestPair {
public:
    ClosestPair(const Curve& curve1, const Curve& curve2) : curve1_(&curve1), curve2_(&curve2) {
        best_.distance = std::numeric_limits<double>::infinity();
    }
    /// Takes the pair if it is closer than the best one by more than `lead`.
    void try_pair(double t1, double t2, double lead = 0) {
        const Vec2 x1 = point(*curve1_, t1), x2 = point(*curve2_, t2);
        const double distance = (x2 - x1).norm();
        if (distance < best_.distance - lead) best_ = {distance, -1, -1, t1, t2, x1, x2};
    }
    void try_first(double t1) { try_pair(t1, closest_parameter(*curve2_, point(*curve1_, t1))); }
    void try_second(double t2) { try_pair(closest_parameter(*curve1_, point(*curve2_, t2)), t2); }
    const ClosestPoints& best() const { return best_; }

private:
    const Curve *curve1_, *curve2_;
    ClosestPoints best_;
};

bool is_line_or_circle(const Curve& curve) {
    return std::holds_alternative<Segment>(curve) || std::holds_alternative<Arc>(curve);
}

/// The closest points of two arcs, as parameters of the curves that they follow.
struct ArcPair {
    ParameterPair t;
    double distance;
};

/// Pairs of arcs that may carry the closest points of the curves: the distance of arcs errs by their tolerances, that of the
/// closest arcs as well.
std::vector<ArcPair> close_arcs(const Curve& curve1, const Curve& curve2, double upper_bound) {
    const PieceTree tree1 = piece_tree(curve1, arc_spline_fraction * bounding_box(curve1).diagonal()),
                    tree2 = piece_tree(curve2, arc_spline_fraction * bounding_box(curve2).diagonal());
    const double error = tree1.tolerance + tree2.tolerance;
    double best = upper_bound + error;
    std::vector<ArcPair> pairs;
    visit_near(
        tree1, tree2, [&] { return best + 2 * error; },
        [&](const ArcPiece& piece1, const ArcPiece& piece2) {
            const ClosestPoints c = closest_points(piece1.curve, piece2.curve);
            best = std::min(best, c.distance);
            pairs.push_back({{curve_parameter(piece1, c.x1), curve_parameter(piece2, c.x2)}, c.distance});
            // crossings of arcs of large radius come out with rounding errors far above those of their ends
            for (const Vec2& p : meeting_points(piece1.curve, piece2.curve, error)) {
                best = std::min(best, error);
                pairs.push_back({{curve_parameter(piece1, p), curve_parameter(piece2, p)}, 0});
            }
        });
    std::erase_if(pairs, [&](const ArcPair& pair) { return pair.distance > best + 2 * error; });
    std::sort(pairs.begin(), pairs.end(),
              [](const ArcPair& p, const ArcPair& q) { return p.t.a != q.t.a ? p.t.a < q.t.a : p.t.b < q.t.b; });
    return pairs;
}

/// From one curve to the other and back: slow, but always downhill.
ParameterPair downhill(const Curve& curve1, const Curve& curve2, ParameterPair t) {
    constexpr int rounds = 4;
    for (int k = 0; k < rounds; ++k) {
        t.b = nearby_closest_parameter(curve2, point(curve1, t.a), t.b);
        t.a = nearby_closest_parameter(curve1, point(curve2, t.b), t.a);
    }
    return t;
}

/// Where at least one curve is an ellipse or a spline. A pair of parallel normals is taken even where a rounding makes another
/// one closer: along the curves, points of equal distance to rounding lie far apart.
void try_arcs(const Curve& curve1, const Curve& curve2, double rounding, ClosestPair& nearest) {
    ClosestPair ends = nearest;
    for (const double end : {0.0, 1.0}) {
        ends.try_first(end);
        ends.try_second(end);
    }
    for (const ArcPair& pair : close_arcs(curve1, curve2, ends.best().distance)) {
        const ParameterPair start = downhill(curve1, curve2, pair.t);
        ClosestPair here(curve1, curve2);
        here.try_pair(start.a, start.b);
        if (const auto t = polished_crossing(curve1, curve2, start)) here.try_pair(t->a, t->b, rounding);
        if (const auto t = polished_parallel(curve1, curve2, start)) here.try_pair(t->a, t->b, -rounding);
        nearest.try_pair(here.best().t1, here.best().t2, rounding);
    }
    nearest.try_pair(ends.best().t1, ends.best().t2, rounding);
}

}  // namespace

ClosestPoints closest_points(const Curve& curve1, const Curve& curve2) {
    ClosestPair nearest(curve1, curve2);
    const double rounding = rounding_fraction * (bounding_box(curve1).diagonal() + bounding_box(curve2).diagonal());
    if (!is_line_or_circle(curve1) || !is_line_or_circle(curve2)) {
        try_arcs(curve1, curve2, rounding, nearest);
        return nearest.best();
    }
    for (const double end : {0.0, 1.0}) {
        nearest.try_first(end);
        nearest.try_second(end);
    }
    for (const double t : parallel_points(curve1, curve2))
        if (t > 0 && t < 1) nearest.try_first(t);
    for (const Vec2& p : meeting_points(curve1, curve2, rounding))
        nearest.try_pair(closest_parameter(curve1, p), closest_parameter(curve2, p));
    return nearest.best();
}

std::optional<ClosestPoints> closest_points(const Part& part1, const Part& part2, double limit) {
    ENSURE(limit >= 0, "boundaries are looked at up to a distance");
    std::optional<ClosestPoints> best;
    if (!bounding_box(part1).overlaps(bounding_box(part2), limit)) return best;
    const EdgeTree tree(part2);
    const double rounding = rounding_fraction * (bounding_box(part1).diagonal() + bounding_box(part2).diagonal());
    for (std::size_t e1 = 0; e1 < part1.edges.size(); ++e1) {
        const Curve& curve1 = part1.edges[e1].curve;
        for (const int e2 : tree.near(bounding_box(curve1), best ? best->distance : limit)) {
            ClosestPoints pair = closest_points(curve1, part2.edges[static_cast<std::size_t>(e2)].curve);
            if (pair.distance > limit || (best && pair.distance >= best->distance - rounding)) continue;
            pair.edge1 = static_cast<int>(e1);
            pair.edge2 = e2;
            best = pair;
        }
    }
    return best;
}

}  // namespace abut::geometry
