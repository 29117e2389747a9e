// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/closest_points.hpp"

#include "geometry/curve_meetings.hpp"
#include "geometry/edge_tree.hpp"
#include "geometry/tangent_ball.hpp"

namespace abut::geometry {

namespace {

/// Differences below this fraction of the size do not make another pair the closer one: equal distances come out in any order.
constexpr double rounding_fraction = 1e-14;

class Nearest {
public:
    Nearest(const Curve& curve1, const Curve& curve2) : curve1_(curve1), curve2_(curve2) {
        best_.distance = std::numeric_limits<double>::infinity();
    }
    void try_pair(double t1, double t2) {
        const Vec2 x1 = point(curve1_, t1), x2 = point(curve2_, t2);
        const double distance = (x2 - x1).norm();
        if (distance < best_.distance) best_ = {distance, -1, -1, t1, t2, x1, x2};
    }
    void try_first(double t1) { try_pair(t1, closest_parameter(curve2_, point(curve1_, t1))); }
    void try_second(double t2) { try_pair(closest_parameter(curve1_, point(curve2_, t2)), t2); }
    const ClosestPoints& best() const { return best_; }

private:
    const Curve &curve1_, &curve2_;
    ClosestPoints best_;
};

}  // namespace

ClosestPoints closest_points(const Curve& curve1, const Curve& curve2) {
    Nearest nearest(curve1, curve2);
    for (const double end : {0.0, 1.0}) {
        nearest.try_first(end);
        nearest.try_second(end);
    }
    for (const double t : parallel_points(curve1, curve2))
        if (t > 0 && t < 1) nearest.try_first(t);
    const double rounding = rounding_fraction * (bounding_box(curve1).diagonal() + bounding_box(curve2).diagonal());
    for (const Vec2& p : meeting_points(curve1, curve2, rounding))
        nearest.try_pair(closest_parameter(curve1, p), closest_parameter(curve2, p));
    return nearest.best();
}

std::optional<ClosestPoints> closest_points(const Part& part1, const Part& part2, double limit) {
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
