// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/boolean.hpp"

#include <CGAL/Boolean_set_operations_2/Gps_polygon_validation.h>
#include <CGAL/General_polygon_2.h>
#include <CGAL/General_polygon_set_2.h>
#include <CGAL/Gps_traits_2.h>

#include <algorithm>
#include <map>
#include <utility>
#include <variant>

#include "geometry/boolean_model.hpp"

namespace abut::geometry {

namespace {

using namespace exact;
using Traits = CGAL::Gps_traits_2<EdgeTraits>;
using Region = CGAL::General_polygon_set_2<Traits>;
using Polygon2 = Traits::Polygon_2;
using PolygonWithHoles = Traits::Polygon_with_holes_2;

// ---- the tree --------------------------------------------------------------------------------------------------------

/// Only arcs that meet other edges, and arc splines, are moved by rounding; everything else is valid as it was checked.
bool may_be_invalid(const Primitive& primitive, const BoundaryLoop& loop) {
    const auto curve = [&](const OrientedEdge& e) -> const Curve& {
        return primitive.edges[static_cast<std::size_t>(e.edge)].curve;
    };
    if (loop.edges.size() == 1) return std::holds_alternative<Spline>(curve(loop.edges.front()));
    return std::any_of(loop.edges.begin(), loop.edges.end(),
                       [&](const OrientedEdge& e) { return !std::holds_alternative<Segment>(curve(e)); });
}

Polygon2 polygon_of(const std::vector<MonotoneCurve>& boundary) {
    return {boundary.begin(), boundary.end()};
}

/// Walks the tree in reading order, so that the next leaf is always the next primitive.
class Evaluator {
public:
    Evaluator(const std::vector<Primitive>& primitives, ExactModel& model, const Reach& reach)
        : primitives_(primitives), model_(model), reach_(reach) {}

    Region evaluate(const CsgNode& node) {
        if (const auto* place = std::get_if<Placed>(&node.shape)) return evaluate(place->of.front());
        if (const auto* common = std::get_if<Intersection>(&node.shape)) return intersection(*common);
        if (std::holds_alternative<Difference>(node.shape)) return difference(node);
        std::vector<PolygonWithHoles> polygons;
        gather(node, polygons);
        return joined(polygons);
    }

    std::vector<GeometryProblem> problems;

private:
    static Region joined(const std::vector<PolygonWithHoles>& polygons) {
        Region region;
        region.join(polygons.begin(), polygons.end());
        return region;
    }

    /// Polygons whose union is the node: nested unions are opened, so that everything is joined in one go.
    void gather(const CsgNode& node, std::vector<PolygonWithHoles>& polygons) {
        if (const auto* place = std::get_if<Placed>(&node.shape)) return gather(place->of.front(), polygons);
        if (const auto* all = std::get_if<Union>(&node.shape)) {
            for (const CsgNode& child : all->of) gather(child, polygons);
        } else if (std::holds_alternative<Intersection>(node.shape) || std::holds_alternative<Difference>(node.shape)) {
            evaluate(node).polygons_with_holes(std::back_inserter(polygons));
        } else {
            add_primitive(node, polygons);
        }
    }

    Region intersection(const Intersection& node) {
        Region region = evaluate(node.of.front());
        for (std::size_t i = 1; i < node.of.size(); ++i) region.intersection(evaluate(node.of[i]));
        return region;
    }

    /// (a less b) less c is a less (b and c): one difference whatever the number of tools.
    Region difference(const CsgNode& node) {
        std::vector<PolygonWithHoles> tools;
        Region region = minuend(node, tools);
        region.difference(joined(tools));
        return region;
    }

    Region minuend(const CsgNode& node, std::vector<PolygonWithHoles>& tools) {
        if (const auto* place = std::get_if<Placed>(&node.shape)) return minuend(place->of.front(), tools);
        const auto* difference = std::get_if<Difference>(&node.shape);
        if (!difference) return evaluate(node);
        Region region = minuend(difference->of.front(), tools);
        for (std::size_t i = 1; i < difference->of.size(); ++i) gather(difference->of[i], tools);
        return region;
    }

    void add_primitive(const CsgNode& node, std::vector<PolygonWithHoles>& polygons) {
        const std::size_t k = next_primitive_++;
        if (const auto* half = std::get_if<HalfPlane>(&node.shape))
            polygons.emplace_back(polygon_of(model_.half_plane(k, *half, reach_)));
        else
            add_bounded(k, polygons);
    }

    void add_bounded(std::size_t k, std::vector<PolygonWithHoles>& polygons) {
        const Primitive& primitive = primitives_[k];
        std::vector<Polygon2> loops;
        for (std::size_t l = 0; l < primitive.loops.size(); ++l) {
            const BoundaryLoop& loop = primitive.loops[l];
            loops.push_back(polygon_of(model_.boundary(k, l)));
            if (may_be_invalid(primitive, loop) && !CGAL::is_simple_polygon(loops.back(), Traits()))
                report_invalid(primitive, loop);
        }
        for (std::size_t outer = 0; outer < loops.size(); ++outer) {
            if (primitive.loops[outer].hole_of >= 0) continue;
            PolygonWithHoles polygon(loops[outer]);
            for (std::size_t hole = 0; hole < loops.size(); ++hole)
                if (primitive.loops[hole].hole_of == static_cast<int>(outer)) polygon.add_hole(loops[hole]);
            polygons.push_back(std::move(polygon));
        }
    }

    void report_invalid(const Primitive& primitive, const BoundaryLoop& loop) {
        const SourceEdge& edge = primitive.edges[static_cast<std::size_t>(loop.edges.front().edge)];
        problems.push_back({primitive.where, "the loop of edge '" + edge.name + "' crosses or touches itself within rounding",
                            "look for very sharp corners between arcs, or move nearly touching edges apart",
                            point(placed(edge.curve, primitive.moves), 0)});
    }

    const std::vector<Primitive>& primitives_;
    ExactModel& model_;
    Reach reach_;
    std::size_t next_primitive_ = 0;
};

// ---- the result ----------------------------------------------------------------------------------------------------

struct BeforeXy {
    bool operator()(const OneRoot& a, const OneRoot& b) const {
        return PlaneTraits().compare_xy_2_object()(a, b) == CGAL::SMALLER;
    }
};
using VertexNumbers = std::map<OneRoot, int, BeforeXy>;

int turn_of(const MonotoneCurve& curve) {
    if (curve.is_linear()) return 0;
    return curve.orientation() == CGAL::COUNTERCLOCKWISE ? 1 : -1;
}

/// Does the curve run the way of the source that it is a portion of?
bool runs_along(const MonotoneCurve& curve, const SourcePortion& portion, const Vec2& from, const Vec2& to) {
    const int turn = turn_of(curve);
    return turn == 0 || portion.turn == 0 ? (to - from).dot(portion.way) > 0 : turn == portion.turn;
}

RawPiece raw_piece(const MonotoneCurve& curve, const std::vector<SourcePortion>& portions) {
    RawPiece piece;
    piece.from = rounded(curve.source());
    piece.to = rounded(curve.target());
    piece.source = curve.data();
    if (piece.source == bridge_source || piece.source == far_source) return piece;
    const SourcePortion& portion = portions[static_cast<std::size_t>(curve.data())];
    piece.source = portion.source;
    piece.t0 = portion.t0;
    piece.t1 = portion.t1;
    piece.along = runs_along(curve, portion, piece.from, piece.to);
    return piece;
}

std::vector<RawPiece> raw_loop(const Polygon2& polygon, const std::vector<SourcePortion>& portions, VertexNumbers& vertices) {
    std::vector<RawPiece> loop;
    for (auto curve = polygon.curves_begin(); curve != polygon.curves_end(); ++curve) {
        loop.push_back(raw_piece(*curve, portions));
        loop.back().from_vertex = vertices.emplace(curve->source(), static_cast<int>(vertices.size())).first->second;
    }
    return loop;
}

}  // namespace

BooleanBoundary boolean_boundary(const CsgNode& tree, const std::vector<Primitive>& primitives,
                                 const std::vector<PlacedSource>& sources, const Carriers& carriers, const Reach& reach) {
    ExactModel model(primitives, sources, carriers);
    Evaluator evaluator(primitives, model, reach);
    const Region region = evaluator.evaluate(tree);
    BooleanBoundary boundary;
    boundary.problems = std::move(evaluator.problems);
    if (!boundary.problems.empty()) return boundary;

    std::vector<PolygonWithHoles> polygons;
    region.polygons_with_holes(std::back_inserter(polygons));
    VertexNumbers vertices;
    for (const PolygonWithHoles& polygon : polygons) {
        boundary.loops.push_back(raw_loop(polygon.outer_boundary(), model.portions, vertices));
        for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole)
            boundary.loops.push_back(raw_loop(*hole, model.portions, vertices));
    }
    return boundary;
}

}  // namespace abut::geometry
