// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/touching_loops.hpp"

#include <algorithm>
#include <string>

#include "geometry/brep/closest_points.hpp"
#include "geometry/brep/edge_tree.hpp"
#include "geometry/brep/message_text.hpp"

namespace abut::geometry {

namespace {

struct LoopOf {
    std::vector<int> loop;      ///< by edge
    std::vector<bool> is_hole;  ///< by loop
};

LoopOf loops_of_edges(const Part& part) {
    LoopOf of;
    of.loop.resize(part.edges.size(), -1);
    for (std::size_t l = 0; l < part.loops.size(); ++l) {
        Part alone;
        for (const int e : part.loops[l].edges) {
            of.loop[static_cast<std::size_t>(e)] = static_cast<int>(l);
            alone.edges.push_back(part.edges[static_cast<std::size_t>(e)]);
        }
        of.is_hole.push_back(area(alone) < 0);
    }
    return of;
}

std::string sentence(const Part& part, const LoopOf& of, int edge1, int edge2, const Vec2& at) {
    const auto name = [&](int e) { return "'" + part.edges[static_cast<std::size_t>(e)].name + "'"; };
    const auto hole = [&](int e) { return of.is_hole[static_cast<std::size_t>(of.loop[static_cast<std::size_t>(e)])]; };
    if (hole(edge1) && hole(edge2))
        return "the holes of edges " + name(edge1) + " and " + name(edge2) + " touch at " + place_text(at);
    if (hole(edge1)) return "the hole of edge " + name(edge1) + " touches the boundary at " + place_text(at);
    if (hole(edge2)) return "the hole of edge " + name(edge2) + " touches the boundary at " + place_text(at);
    return "the regions of edges " + name(edge1) + " and " + name(edge2) + " touch at the point " + place_text(at);
}

struct Touch {
    int loop1, loop2;
    Vec2 at;
};

}  // namespace

std::vector<Repair> touching_loops(const Part& part) {
    std::vector<Repair> found;
    if (part.loops.size() < 2) return found;
    const double merge = merge_length(part);
    const LoopOf of = loops_of_edges(part);
    const EdgeTree tree(part);
    std::vector<Touch> touches;
    for (std::size_t e = 0; e < part.edges.size(); ++e)
        for (const int other : tree.near(bounding_box(part.edges[e].curve), merge)) {
            const int loop1 = of.loop[e], loop2 = of.loop[static_cast<std::size_t>(other)];
            if (other <= static_cast<int>(e) || loop1 == loop2) continue;
            const ClosestPoints pair = closest_points(part.edges[e].curve, part.edges[static_cast<std::size_t>(other)].curve);
            if (pair.distance > merge) continue;
            const Touch touch{loop1, loop2, 0.5 * (pair.x1 + pair.x2)};
            const bool is_known = std::any_of(touches.begin(), touches.end(), [&](const Touch& t) {
                return t.loop1 == loop1 && t.loop2 == loop2 && (t.at - touch.at).norm() <= 2 * merge;
            });
            if (is_known) continue;
            touches.push_back(touch);
            found.push_back({sentence(part, of, static_cast<int>(e), other, touch.at), touch.at, 0});
        }
    return found;
}

}  // namespace abut::geometry
