// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluation of a geometry tree: a tree without Booleans is its one primitive's boundary, anything else goes through
// boolean.cpp.
#include "geometry/csg.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/boolean.hpp"
#include "geometry/csg_names.hpp"
#include "geometry/merge_pieces.hpp"
#include "geometry/primitives.hpp"

namespace abut::geometry {

namespace {

/// How far half planes reach beyond everything that is bounded.
constexpr double reach_factor = 4;
/// Lines whose directions differ by less, radians, do not cross within any model.
constexpr double parallel_sine = 1e-9;

bool is_boolean(const CsgNode& node) {
    if (const auto* place = std::get_if<Placed>(&node.shape)) return is_boolean(place->of.front());
    return std::holds_alternative<Union>(node.shape) || std::holds_alternative<Intersection>(node.shape) ||
           std::holds_alternative<Difference>(node.shape);
}

GeometryProblem unbounded(const CsgNode& tree) {
    return {tree.where,
            "the part is unbounded: a half plane is not cut off on all sides",
            "intersect the half plane with something bounded",
            {0, 0}};
}

Curve along_boundary(const OrientedEdge& edge, const std::vector<PlacedSource>& sources) {
    const Curve& curve = sources[static_cast<std::size_t>(edge.edge)].curve;
    return edge.along ? curve : reversed(curve);
}

std::vector<std::vector<Piece>> boundary_of_primitive(const Primitive& primitive, const std::vector<PlacedSource>& sources) {
    std::vector<std::vector<Piece>> loops;
    for (const BoundaryLoop& loop : primitive.loops) {
        std::vector<Piece> pieces;
        for (const OrientedEdge& edge : loop.edges) pieces.push_back({along_boundary(edge, sources), edge.edge});
        loops.push_back(std::move(pieces));
    }
    return loops;
}

const Imported& imported_leaf(const CsgNode& node) {
    if (const auto* place = std::get_if<Placed>(&node.shape)) return imported_leaf(place->of.front());
    return std::get<Imported>(node.shape);
}

/// An import keeps its own names, order and places along its sources.
Part placed_import(const Imported& imported, const Primitive& primitive) {
    Part part = imported.part;
    part.name.clear();
    for (Edge& edge : part.edges) {
        edge.curve = placed(edge.curve, primitive.moves);
        if (primitive.name.empty()) continue;
        edge.name = primitive.name + "/" + edge.name;
        edge.source = primitive.name + "/" + edge.source;
    }
    return part;
}

/// A disc that holds all bounded primitives and all crossings of half planes' lines, enlarged.
Reach reach_of(const std::vector<Primitive>& primitives, const std::vector<PlacedSource>& sources) {
    Box2 box;
    std::vector<Segment> lines;
    for (const PlacedSource& source : sources) {
        if (primitives[static_cast<std::size_t>(source.primitive)].half_plane) {
            lines.push_back(std::get<Segment>(source.curve));
            box.extend(lines.back().from);
        } else {
            box.extend(bounding_box(source.curve));
        }
    }
    for (std::size_t i = 0; i < lines.size(); ++i)
        for (std::size_t j = i + 1; j < lines.size(); ++j) {
            const Vec2 u = lines[i].to - lines[i].from, v = lines[j].to - lines[j].from;
            const double sine = cross(u, v);
            if (std::abs(sine) > parallel_sine) box.extend(lines[i].from + cross(lines[j].from - lines[i].from, v) / sine * u);
        }
    return {box.center(), reach_factor * std::max(box.diagonal(), 1e-3 * (1 + box.center().norm()))};
}

bool reaches_far(const std::vector<std::vector<RawPiece>>& loops) {
    return std::any_of(loops.begin(), loops.end(), [](const auto& loop) {
        return std::any_of(loop.begin(), loop.end(), [](const RawPiece& piece) { return piece.source == far_source; });
    });
}

}  // namespace

CsgResult evaluate(const CsgNode& tree) {
    CsgResult result;
    const std::vector<Primitive> primitives = primitives_of(tree, result.problems);
    if (!result.problems.empty()) return result;
    const std::vector<PlacedSource> sources = placed_sources(primitives);

    if (!is_boolean(tree)) {
        const Primitive& primitive = primitives.front();
        if (primitive.half_plane)
            result.problems.push_back(unbounded(tree));
        else if (primitive.imported)
            result.part = placed_import(imported_leaf(tree), primitive);
        else
            result.part = named_part(sources, boundary_of_primitive(primitive, sources));
        return result;
    }

    BooleanBoundary boundary = boolean_boundary(tree, primitives, reach_of(primitives, sources));
    result.problems = std::move(boundary.problems);
    if (!result.problems.empty()) return result;
    if (reaches_far(boundary.loops)) {
        result.problems.push_back(unbounded(tree));
        return result;
    }
    result.part = named_part(sources, merge_pieces(boundary.loops, sources));
    if (result.part.loops.empty())
        result.problems.push_back({tree.where,
                                   "the part is empty: nothing is left of it",
                                   "check the places and sizes of what is intersected or subtracted",
                                   {0, 0}});
    return result;
}

}  // namespace abut::geometry
