// SPDX-License-Identifier: GPL-3.0-or-later
// The R-function of a geometry tree.
#include <variant>

#include "geometry/csg/primitives.hpp"
#include "geometry/implicit/field_shape.hpp"
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

    ImplicitField field_of(const CsgNode& node) {
        return std::visit([&](const auto& shape) { return of_shape(shape); }, node.shape);
    }

private:
    std::vector<ImplicitField> fields_of(const std::vector<CsgNode>& nodes) {
        std::vector<ImplicitField> fields;
        for (const CsgNode& node : nodes) fields.push_back(field_of(node));
        return fields;
    }

    ImplicitField of_shape(const Union& join) { return disjunction(fields_of(join.of), alpha_); }
    ImplicitField of_shape(const Intersection& meet) { return conjunction(fields_of(meet.of), alpha_); }
    ImplicitField of_shape(const Placed& place) { return field_of(place.of.front()); }
    /// The first and not (the others' union).
    ImplicitField of_shape(const Difference& difference) {
        std::vector<ImplicitField> fields = fields_of(difference.of);
        if (fields.size() == 1) return fields.front();
        const ImplicitField first = fields.front();
        fields.erase(fields.begin());
        return conjunction({first, negation(disjunction(fields, alpha_))}, alpha_);
    }

    ImplicitField of_shape(const HalfPlane&) { return line_field(next(), 0); }
    ImplicitField of_shape(const Circle&) { return closed_field(next()); }
    ImplicitField of_shape(const Ellipse&) { return closed_field(next()); }
    ImplicitField of_shape(const Rectangle&) {
        const Primitive& primitive = next();
        std::vector<ImplicitField> sides;
        for (std::size_t e = 0; e < primitive.edges.size(); ++e) sides.push_back(line_field(primitive, e));
        return conjunction(sides, alpha_);
    }
    /// Everything else is known by its edges alone.
    template <class Shape>
    ImplicitField of_shape(const Shape&) {
        return distance_field(placed_part(next()), leaf_join_order);
    }

    const Primitive& next() { return primitives_[n_read_++]; }

    const std::vector<Primitive>& primitives_;
    double alpha_;
    std::size_t n_read_ = 0;
};

}  // namespace

ImplicitField implicit_of(const CsgNode& tree, double alpha) {
    std::vector<GeometryProblem> problems;
    const std::vector<Primitive> primitives = primitives_of(tree, problems);
    ENSURE(problems.empty(), problems.front().where + ": " + problems.front().what);
    return Builder(primitives, alpha).field_of(tree);
}

}  // namespace abut::geometry
