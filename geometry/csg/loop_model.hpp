// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of `loops` in one list, and which of their ends belong together.
#pragma once
#include <string>
#include <vector>

#include "geometry/csg/csg.hpp"

namespace abut::geometry {

/// All edges of `loops` by number, and the lengths that they are judged by.
struct LoopModel {
    std::vector<LoopEdge> edges;  ///< in file order
    std::vector<int> list;        ///< by edge: which of the lists it stands in
    std::vector<int> first;       ///< first edge of each list, and the number of edges
    double size = 0;              ///< diagonal of the box around all edges
    double tolerance = 0;         ///< merge_fraction of the size
    /// The other ends of its list that lie within the tolerance of an end, by end (2 edge where it begins, 2 edge + 1 where it
    /// ends).
    std::vector<std::vector<int>> joined;

    const Curve& curve(int edge) const { return edges[static_cast<std::size_t>(edge)].curve; }
    const std::string& name(int edge) const { return edges[static_cast<std::size_t>(edge)].name; }
    int list_of(int edge) const { return list[static_cast<std::size_t>(edge)]; }
    Vec2 end_point(int end) const { return point(curve(end / 2), end % 2); }
    std::string pair(int a, int b) const { return "'" + name(a) + "' and '" + name(b) + "'"; }
    GeometryProblem problem(int edge, std::string what, std::string hint, const Vec2& at) const {
        return {edges[static_cast<std::size_t>(edge)].where, std::move(what), std::move(hint), at};
    }
};

/// A model of the edges and lists; `joined` is not filled in.
LoopModel loop_model(const Loops& loops);

/// Fills in `joined`, leaving out the ends of edges that are left out. Cost O(n log n).
void join_close_ends(LoopModel& model, const std::vector<bool>& is_left_out);

}  // namespace abut::geometry
