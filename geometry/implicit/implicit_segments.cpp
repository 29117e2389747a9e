// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of boundaries given by their edges.

#include "geometry/implicit/boundary_side.hpp"
#include "geometry/implicit/field_shape.hpp"
#include "geometry/implicit/trimmed_edge.hpp"
#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

template <class T>
NearCurve<T> near_edges(const std::vector<TrimmedEdge>& edges, const PointOf<T>& p, int m) {
    std::vector<NearCurve<T>> near;
    near.reserve(edges.size());
    for (const TrimmedEdge& edge : edges) near.push_back(trimmed(edge, p));
    return joined(near, m);
}

}  // namespace

BoundarySide boundary_side(const Part& part) {
    return {slabbed(monotone_pieces(part)), on_edge_fraction * bounding_box(part).diagonal()};
}

ImplicitField distance_field(const Part& part, int m) {
    ENSURE(!part.edges.empty() && m >= 1, "a part has edges, and a join is of order 1 at least");
    std::vector<TrimmedEdge> edges;
    for (const Edge& edge : part.edges) edges.push_back(trimmed_edge(edge.curve));
    return make_field([edges = std::move(edges), side = boundary_side(part), m]<class T>(const PointOf<T>& p) -> T {
        return with_side(near_edges(edges, p, m), side.on_edge, contains(side.pieces, position(p)));
    });
}

ImplicitField edge_field(const Part& part, const std::vector<int>& edges, int m) {
    ENSURE(!edges.empty() && m >= 1, "a field is of some edges, and a join of order 1 at least");
    std::vector<TrimmedEdge> chosen;
    for (const int e : edges) {
        ENSURE(e >= 0 && static_cast<std::size_t>(e) < part.edges.size(), "the edge is one of the part's");
        chosen.push_back(trimmed_edge(part.edges[static_cast<std::size_t>(e)].curve));
    }
    const double on_edge = on_edge_fraction * bounding_box(part).diagonal();
    return make_field([edges = std::move(chosen), on_edge, m]<class T>(const PointOf<T>& p) -> T {
        return without_side(near_edges(edges, p, m), on_edge);
    });
}

ImplicitField whole_field(const Curve& curve) {
    const TrimmedEdge edge = trimmed_edge(curve);
    if (edge.is_conic)
        return make_field([conic = edge.conic]<class T>(const PointOf<T>& p) -> T { return whole_curve(conic, p); });
    const double on_edge = on_edge_fraction * bounding_box(curve).diagonal();
    return make_field([edge, on_edge]<class T>(const PointOf<T>& p) -> T { return without_side(trimmed(edge, p), on_edge); });
}

}  // namespace abut::geometry
