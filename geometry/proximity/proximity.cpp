// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/proximity/proximity.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/brep/closest_points.hpp"
#include "geometry/brep/edge_tree.hpp"

namespace abut::geometry {

namespace {

/// Parameters nearer than this to 0 or 1 are the edge's end: what Newton iterations and rounding leave.
constexpr double end_parameter = 1e-9;
/// Boxes are searched this fraction of the size farther, so that their rounding loses nothing.
constexpr double box_rounding_fraction = 1e-12;

void add(OutwardDirections& directions, const Vec2& normal) {
    directions.normals[static_cast<std::size_t>(directions.n_normals++)] = normal;
}

/// Adds what the corner between two edges has beside the one edge's own normal, already there.
void add_corner(OutwardDirections& directions, const Vec2& arriving, const Vec2& leaving, const Vec2& other_normal) {
    add(directions, other_normal);
    const double sine = cross(arriving, leaving), cosine = arriving.dot(leaving);
    const bool is_tip = cosine < 0 && std::abs(sine) <= opposed_cosine;
    if (is_tip)
        add(directions, arriving);
    else if (sine > 0)
        add(directions, (right_of(arriving) + right_of(leaving)).normalized());
}

/// Boxes of all edges of all parts in one list, and whose they are.
struct AllEdges {
    std::vector<Box2> boxes;
    std::vector<int> part, edge;
    explicit AllEdges(const std::vector<Part>& parts) {
        for (std::size_t p = 0; p < parts.size(); ++p)
            for (std::size_t e = 0; e < parts[p].edges.size(); ++e) {
                boxes.push_back(bounding_box(parts[p].edges[e].curve));
                part.push_back(static_cast<int>(p));
                edge.push_back(static_cast<int>(e));
            }
    }
    double size() const {
        Box2 all;
        for (const Box2& box : boxes) all.extend(box);
        return all.diagonal() + (boxes.empty() ? 0.0 : all.center().norm());
    }
};

double distance_between(const Box2& a, const Box2& b) {
    return (a.min - b.max).cwiseMax(b.min - a.max).cwiseMax(0.0).norm();
}

}  // namespace

bool oppose(const OutwardDirections& first, const OutwardDirections& second) {
    for (int i = 0; i < first.n_normals; ++i)
        for (int k = 0; k < second.n_normals; ++k)
            if (first.normals[static_cast<std::size_t>(i)].dot(second.normals[static_cast<std::size_t>(k)]) < -opposed_cosine)
                return true;
    return false;
}

EdgeNeighbours::EdgeNeighbours(const Part& part) : before(part.edges.size(), -1), after(part.edges.size(), -1) {
    const auto join = [&](int e, int next) {
        after[static_cast<std::size_t>(e)] = next;
        before[static_cast<std::size_t>(next)] = e;
    };
    for (const Loop& loop : part.loops)
        for (std::size_t i = 0; i < loop.edges.size(); ++i) join(loop.edges[i], loop.edges[(i + 1) % loop.edges.size()]);
    const int n = static_cast<int>(part.edges.size());
    for (int e = 0; part.loops.empty() && e < n; ++e) join(e, (e + 1) % n);
}

OutwardDirections outward_directions(const Part& part, const EdgeNeighbours& neighbours, int edge, double t) {
    const Curve& curve = curve_of(part, edge);
    const Vec2 tangent = unit_tangent(curve, t);
    OutwardDirections directions;
    add(directions, right_of(tangent));
    if (t <= end_parameter) {
        const Vec2 arriving = unit_tangent(curve_of(part, neighbours.before[static_cast<std::size_t>(edge)]), 1);
        add_corner(directions, arriving, tangent, right_of(arriving));
    } else if (t >= 1 - end_parameter) {
        const Vec2 leaving = unit_tangent(curve_of(part, neighbours.after[static_cast<std::size_t>(edge)]), 0);
        add_corner(directions, tangent, leaving, right_of(leaving));
    }
    return directions;
}

std::optional<EdgePairCandidate> close_edge_pair(const Part& part1, const EdgeNeighbours& neighbours1, int edge1,
                                                 const Part& part2, const EdgeNeighbours& neighbours2, int edge2,
                                                 double distance) {
    const ClosestPoints c = closest_points(curve_of(part1, edge1), curve_of(part2, edge2));
    if (!(c.distance <= distance)) return std::nullopt;
    if (!oppose(outward_directions(part1, neighbours1, edge1, c.t1), outward_directions(part2, neighbours2, edge2, c.t2)))
        return std::nullopt;
    return EdgePairCandidate{-1, edge1, -1, edge2, c.t1, c.t2, c.x1, c.x2, c.distance};
}

std::vector<EdgePairCandidate> close_edge_pairs(const std::vector<Part>& parts, double distance) {
    std::vector<EdgeNeighbours> neighbours;
    for (const Part& part : parts) neighbours.emplace_back(part);
    const AllEdges all(parts);
    const EdgeTree tree(all.boxes);
    const double reach = distance + box_rounding_fraction * all.size();
    std::vector<EdgePairCandidate> found;
    for (std::size_t i = 0; i < all.boxes.size(); ++i) {
        const auto p1 = static_cast<std::size_t>(all.part[i]);
        for (const int other : tree.near(all.boxes[i], reach)) {
            const auto k = static_cast<std::size_t>(other);
            const auto p2 = static_cast<std::size_t>(all.part[k]);
            if (p2 <= p1 || distance_between(all.boxes[i], all.boxes[k]) > reach) continue;
            auto candidate =
                close_edge_pair(parts[p1], neighbours[p1], all.edge[i], parts[p2], neighbours[p2], all.edge[k], distance);
            if (!candidate) continue;
            candidate->part1 = all.part[i];
            candidate->part2 = all.part[k];
            found.push_back(*candidate);
        }
    }
    std::sort(found.begin(), found.end(), [](const EdgePairCandidate& a, const EdgePairCandidate& b) {
        return std::tie(a.part1, a.part2, a.edge1, a.edge2) < std::tie(b.part1, b.part2, b.edge1, b.edge2);
    });
    return found;
}

}  // namespace abut::geometry
