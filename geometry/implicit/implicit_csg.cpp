// SPDX-License-Identifier: GPL-3.0-or-later
// The R-function of a geometry tree.
#include <utility>
#include <variant>

#include "geometry/csg/primitives.hpp"
#include "geometry/implicit/field_shape.hpp"
#include "geometry/implicit/node_fields.hpp"
#include "geometry/implicit/trimmed_edge.hpp"
#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

Curve placed_edge(const Primitive& primitive, std::size_t edge, bool along) {
    const Curve curve = placed(primitive.edges[edge].curve, primitive.moves);
    return along ? curve : reversed(curve);
}

/// An edge whose own frame has the material on its left, where it has been placed.
Curve with_material_left(const Primitive& primitive, std::size_t edge) {
    return placed_edge(primitive, edge, !is_mirrored(primitive.moves));
}

Part placed_part(const Primitive& primitive) {
    Part part;
    for (const BoundaryLoop& boundary : primitive.loops) {
        Loop loop;
        for (const OrientedEdge& edge : boundary.edges) {
            loop.edges.push_back(static_cast<int>(part.edges.size()));
            part.edges.push_back({placed_edge(primitive, static_cast<std::size_t>(edge.edge), edge.along), "", ""});
        }
        part.loops.push_back(std::move(loop));
    }
    return part;
}

ImplicitField line_field(const Primitive& primitive, std::size_t edge) {
    return whole_field(with_material_left(primitive, edge));
}

/// Of a primitive whose one edge is a full circle or ellipse.
ImplicitField closed_field(const Primitive& primitive) {
    const Curve curve = with_material_left(primitive, 0);
    const TrimmedEdge edge = trimmed_edge(curve);
    ENSURE(edge.is_conic && edge.conic.is_closed, "a primitive with one edge is a whole circle or ellipse");
    return whole_field(curve);
}

/// Builds the fields from the leaves to the root; leaves come in the order of primitives_of.
class Builder {
public:
    Builder(const std::vector<Primitive>& primitives, double alpha) : primitives_(primitives), alpha_(alpha) {}

    NodeField field_of(const CsgNode& node) {
        return std::visit([&](const auto& shape) { return of_shape(shape); }, node.shape);
    }

private:
    std::vector<NodeField> nodes_of(const std::vector<CsgNode>& nodes) {
        std::vector<NodeField> fields;
        for (const CsgNode& node : nodes) fields.push_back(field_of(node));
        return fields;
    }
    static std::vector<ImplicitField> fields_of(const std::vector<NodeField>& nodes) {
        std::vector<ImplicitField> fields;
        for (const NodeField& node : nodes) fields.push_back(node.field);
        return fields;
    }

    NodeField of_shape(const Union& join) {
        std::vector<NodeField> nodes = nodes_of(join.of);
        return {disjunction(fields_of(nodes), alpha_), {}, std::move(nodes)};
    }
    NodeField of_shape(const Intersection& meet) {
        std::vector<NodeField> nodes = nodes_of(meet.of);
        return {conjunction(fields_of(nodes), alpha_), {}, std::move(nodes)};
    }
    NodeField of_shape(const Placed& place) { return field_of(place.of.front()); }
    /// The first and not (the others' union).
    NodeField of_shape(const Difference& difference) {
        std::vector<NodeField> nodes = nodes_of(difference.of);
        if (nodes.size() == 1) return nodes.front();
        std::vector<ImplicitField> others = fields_of(nodes);
        const ImplicitField first = others.front();
        others.erase(others.begin());
        for (std::size_t k = 1; k < nodes.size(); ++k) nodes[k].is_taken_away = true;
        return {conjunction({first, negation(disjunction(others, alpha_))}, alpha_), {}, std::move(nodes)};
    }

    NodeField of_shape(const HalfPlane&) { return leaf(line_field(primitive(), 0)); }
    NodeField of_shape(const Circle&) { return leaf(closed_field(primitive())); }
    NodeField of_shape(const Ellipse&) { return leaf(closed_field(primitive())); }
    NodeField of_shape(const Rectangle&) {
        std::vector<ImplicitField> sides;
        for (std::size_t e = 0; e < primitive().edges.size(); ++e) sides.push_back(line_field(primitive(), e));
        return leaf(conjunction(sides, alpha_));
    }
    /// Everything else is known by its edges alone.
    template <class Shape>
    NodeField of_shape(const Shape&) {
        return leaf(distance_field(placed_part(primitive()), leaf_join_order));
    }

    const Primitive& primitive() const { return primitives_[n_read_]; }

    /// Goes on to the next leaf.
    NodeField leaf(ImplicitField field) {
        NodeField node{std::move(field), {}, {}};
        if (!primitive().half_plane)
            for (std::size_t e = 0; e < primitive().edges.size(); ++e) node.curves.push_back(placed_edge(primitive(), e, true));
        ++n_read_;
        return node;
    }

    const std::vector<Primitive>& primitives_;
    double alpha_;
    std::size_t n_read_ = 0;
};

}  // namespace

NodeField node_fields(const CsgNode& tree, double alpha) {
    std::vector<GeometryProblem> problems;
    const std::vector<Primitive> primitives = primitives_of(tree, problems);
    ENSURE(problems.empty(), problems.front().where + ": " + problems.front().what);
    return Builder(primitives, alpha).field_of(tree);
}

ImplicitField implicit_of(const CsgNode& tree, double alpha) {
    return node_fields(tree, alpha).field;
}

}  // namespace abut::geometry
