// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/loop_rounding.hpp"

#include <algorithm>
#include <variant>

#include "geometry/csg/primitives.hpp"

namespace abut::geometry {

double size_of(const Primitive& primitive) {
    Box2 box;
    for (const SourceEdge& edge : primitive.edges) box.extend(bounding_box(placed(edge.curve, primitive.moves)));
    return box.diagonal() + box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff();
}

bool may_be_invalid(const Primitive& primitive, const BoundaryLoop& loop) {
    const auto curve = [&](const OrientedEdge& e) -> const Curve& {
        return primitive.edges[static_cast<std::size_t>(e.edge)].curve;
    };
    if (loop.edges.size() == 1) return std::holds_alternative<Spline>(curve(loop.edges.front()));
    return std::any_of(loop.edges.begin(), loop.edges.end(),
                       [&](const OrientedEdge& e) { return !std::holds_alternative<Segment>(curve(e)); });
}

GeometryProblem self_crossing(const Primitive& primitive, const BoundaryLoop& loop) {
    const SourceEdge& edge = primitive.edges[static_cast<std::size_t>(loop.edges.front().edge)];
    return {primitive.where, "the loop of edge '" + edge.name + "' crosses or touches itself within rounding",
            "look for very sharp corners between arcs, or move nearly touching edges apart",
            point(placed(edge.curve, primitive.moves), 0)};
}

}  // namespace abut::geometry
