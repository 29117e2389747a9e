// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/overlap.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "geometry/csg/common_boundary.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

double distance_to(const Box2& box, const Vec2& p) {
    return (box.min - p).cwiseMax(p - box.max).cwiseMax(0.0).norm();
}

struct NearestEdge {
    int edge = -1;
    double distance = std::numeric_limits<double>::infinity();
};
NearestEdge nearest_edge(const Part& part, const std::vector<Box2>& boxes, const Vec2& p) {
    NearestEdge nearest;
    for (std::size_t e = 0; e < part.edges.size(); ++e) {
        if (distance_to(boxes[e], p) >= nearest.distance) continue;
        const Curve& curve = part.edges[e].curve;
        const double distance = (point(curve, closest_parameter(curve, p)) - p).norm();
        if (distance < nearest.distance) nearest = {static_cast<int>(e), distance};
    }
    return nearest;
}

/// The deepest point of the common boundary, as far as the parts' edges know it.
void find_deepest(const std::array<const Part*, 2>& parts, const std::vector<BoundaryStretch>& boundary, Overlap& found) {
    constexpr int samples = 32;  // even: the middle is one
    std::array<std::vector<Box2>, 2> boxes;
    for (std::size_t side = 0; side < 2; ++side)
        for (const Edge& edge : parts[side]->edges) boxes[side].push_back(bounding_box(edge.curve));
    double deepest = -1;
    for (const BoundaryStretch& stretch : boundary) {
        const auto other = at(1 - stretch.part);
        const Curve& curve = parts[at(stretch.part)]->edges[at(stretch.edge)].curve;
        for (int i = 1; i < samples; ++i) {
            const Vec2 p = point(curve, stretch.t0 + (stretch.t1 - stretch.t0) * i / samples);
            const NearestEdge nearest = nearest_edge(*parts[other], boxes[other], p);
            if (nearest.distance <= deepest) continue;
            deepest = nearest.distance;
            found.edge1 = stretch.part == 0 ? stretch.edge : nearest.edge;
            found.edge2 = stretch.part == 0 ? nearest.edge : stretch.edge;
            found.at = p;
        }
    }
    found.depth = deepest;
}

using Stretches = std::vector<BoundaryStretch>;

Overlap overlap_within(const std::array<const Part*, 2>& parts, const Stretches& boundary, double tolerance) {
    if (boundary.empty()) return {};
    Part common;
    for (const BoundaryStretch& stretch : boundary) {
        Edge edge;
        edge.curve = trimmed(parts[at(stretch.part)]->edges[at(stretch.edge)].curve, stretch.t0, stretch.t1);
        common.edges.push_back(edge);
    }
    Overlap found;
    found.area = std::max(0.0, area(common));
    find_deepest(parts, boundary, found);
    if (found.depth <= tolerance) found.depth = 2 * found.area / perimeter(common);
    return found.depth > tolerance ? found : Overlap{};
}

Stretches stretches_of(const Part& part1, const Part& part2, double tolerance) {
    ENSURE(tolerance >= 0, "parts touch up to a distance");
    return bounding_box(part1).overlaps(bounding_box(part2), 0) ? common_boundary(part1, part2, tolerance) : Stretches{};
}

/// Each stretch is followed by the one that begins nearest to its end.
std::vector<Stretches> loops_of(const std::array<const Part*, 2>& parts, const Stretches& boundary) {
    const auto end_of = [&](const BoundaryStretch& s, double t) {
        return point(parts[at(s.part)]->edges[at(s.edge)].curve, t);
    };
    std::vector<Vec2> begins;
    for (const BoundaryStretch& s : boundary) begins.push_back(end_of(s, s.t0));
    std::vector<Stretches> loops;
    std::vector<char> is_taken(boundary.size(), 0);
    for (std::size_t first = 0; first < boundary.size(); ++first) {
        if (is_taken[first]) continue;
        loops.emplace_back();
        for (std::size_t k = first; !is_taken[k];) {
            is_taken[k] = 1;
            loops.back().push_back(boundary[k]);
            const Vec2 end = end_of(boundary[k], boundary[k].t1);
            const auto nearer = [&](const Vec2& a, const Vec2& b) { return (a - end).norm() < (b - end).norm(); };
            k = static_cast<std::size_t>(std::min_element(begins.begin(), begins.end(), nearer) - begins.begin());
        }
    }
    return loops;
}

}  // namespace

Overlap overlap(const Part& part1, const Part& part2, double tolerance) {
    return overlap_within({&part1, &part2}, stretches_of(part1, part2, tolerance), tolerance);
}

std::vector<Overlap> overlaps(const Part& part1, const Part& part2, double tolerance) {
    const std::array<const Part*, 2> parts{&part1, &part2};
    std::vector<Overlap> found;
    for (const Stretches& loop : loops_of(parts, stretches_of(part1, part2, tolerance)))
        if (const Overlap o = overlap_within(parts, loop, tolerance); o.depth > 0) found.push_back(o);
    return found;
}

Overlap joined(const std::vector<Overlap>& overlaps) {
    Overlap all;
    for (const Overlap& o : overlaps) {
        const double area = all.area + o.area;
        if (o.depth > all.depth) all = o;
        all.area = area;
    }
    return all;
}

}  // namespace abut::geometry
