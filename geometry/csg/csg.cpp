// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluation of a geometry tree: a tree without Booleans is its one primitive's boundary, anything else goes through
// boolean.cpp.
#include "geometry/csg/csg.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/brep/touching_loops.hpp"
#include "geometry/csg/boolean.hpp"
#include "geometry/csg/carriers.hpp"
#include "geometry/csg/csg_names.hpp"
#include "geometry/csg/exact_outline.hpp"
#include "geometry/csg/merge_pieces.hpp"
#include "geometry/csg/pinches.hpp"
#include "geometry/csg/primitives.hpp"
#include "geometry/curves/arc_spline.hpp"

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
        for (const OrientedEdge& edge : loop.edges)
            pieces.push_back({along_boundary(edge, sources), edge.edge, edge.along ? 0.0 : 1.0, edge.along ? 1.0 : 0.0});
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
    const double scale = scale_of(primitive.moves);
    const bool mirrored = is_mirrored(primitive.moves);
    if (mirrored)
        for (Loop& loop : part.loops) std::reverse(loop.edges.begin(), loop.edges.end());
    for (Edge& edge : part.edges) {
        edge.curve = placed(mirrored ? reversed(edge.curve) : edge.curve, primitive.moves);
        edge.along_source = edge.along_source != mirrored;
        edge.source_begin *= scale;
        if (primitive.name.empty()) continue;
        edge.name = primitive.name + "/" + edge.name;
        edge.source = primitive.name + "/" + edge.source;
    }
    return part;
}

/// An import has been looked at where it was read (sketch.cpp), a Boolean is exact before it is rounded.
void check_outline(const CsgNode& tree, CsgResult& result) {
    const std::optional<OutlineFault> fault = exact_fault(result.part);
    if (fault) result.problems.push_back({tree.where, fault->what, fault->hint, fault->at});
}

/// A disc that holds all bounded primitives and all crossings of half planes' lines, enlarged.
BoundingDisc disc_of(const std::vector<Primitive>& primitives, const std::vector<PlacedSource>& sources) {
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

/// How fine the arc splines are, as fractions of each curve's size: finer ones are tried where the first do not show how the
/// curves meet (they nearly touch).
constexpr double arc_fractions[] = {arc_spline_fraction, 1e-2 * arc_spline_fraction, 1e-4 * arc_spline_fraction};

/// Sources that are one within this length share their arcs.
double same_length(const std::vector<Primitive>& primitives, const std::vector<PlacedSource>& sources) {
    Box2 box;
    for (const PlacedSource& source : sources)
        if (!primitives[static_cast<std::size_t>(source.primitive)].half_plane) box.extend(bounding_box(source.curve));
    if (box.empty()) return 0;
    return sliver_width_fraction * (box.diagonal() + box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff());
}

std::vector<double> arc_tolerances(const Carriers& carriers) {
    std::vector<double> tolerance;
    for (const CarrierRun& run : carriers.of_source)
        tolerance.push_back(run.carrier < 0 ? 0 : carriers.carriers[static_cast<std::size_t>(run.carrier)].tolerance);
    return tolerance;
}

/// The Boolean and its restored boundary, with arcs as fine as it takes. Problems go to the result.
MergedBoundary merged_boundary(const CsgNode& tree, const std::vector<Primitive>& primitives,
                               const std::vector<PlacedSource>& sources, std::vector<GeometryProblem>& problems) {
    const double same = same_length(primitives, sources);
    const BoundingDisc disc = disc_of(primitives, sources);
    MergedBoundary merged;
    for (const double fraction : arc_fractions) {
        const Carriers carriers = carriers_of(sources, same, fraction);
        BooleanBoundary boundary = boolean_boundary(tree, primitives, sources, carriers, disc);
        problems = std::move(boundary.problems);
        if (problems.empty() && reaches_far(boundary.loops)) problems.push_back(unbounded(tree));
        if (!problems.empty()) return {};
        merged = merge_pieces(boundary.loops, sources, arc_tolerances(carriers));
        if (!merged.uncertain) break;
    }
    problems = merged.unsolved;
    return merged;
}

}  // namespace

CsgNode transformed(CsgNode tree, double c, double s, const Vec2& d) {
    Placed place;
    place.rotate = std::atan2(s, c) * (180 / std::numbers::pi);
    place.translate = d;
    const std::string where = tree.where;
    place.of.push_back(std::move(tree));
    return {std::move(place), "", where};
}

CsgResult evaluate(const CsgNode& tree) {
    CsgResult result;
    const std::vector<Primitive> primitives = primitives_of(tree, result.problems);
    if (!result.problems.empty()) return result;
    for (const Primitive& primitive : primitives)
        result.repairs.insert(result.repairs.end(), primitive.repairs.begin(), primitive.repairs.end());
    const std::vector<PlacedSource> sources = placed_sources(primitives);

    if (!is_boolean(tree)) {
        const Primitive& primitive = primitives.front();
        if (primitive.half_plane)
            result.problems.push_back(unbounded(tree));
        else if (primitive.imported)
            result.part = placed_import(imported_leaf(tree), primitive);
        else
            result.part = named_part(sources, boundary_of_primitive(primitive, sources));
        if (!primitive.imported) check_outline(tree, result);
        return result;
    }

    MergedBoundary merged = merged_boundary(tree, primitives, sources, result.problems);
    if (!result.problems.empty()) return result;
    result.part = named_part(sources, cut_pinches(std::move(merged.loops), sources));
    result.repairs.insert(result.repairs.end(), merged.repairs.begin(), merged.repairs.end());
    const std::vector<Repair> touches = touching_loops(result.part);
    result.repairs.insert(result.repairs.end(), touches.begin(), touches.end());
    if (!result.part.loops.empty() && !(area(result.part) > 0))
        result.problems.push_back({tree.where, "the Boolean failed: its boundary encloses no area",
                                   "move parts that nearly touch apart, or let them overlap",
                                   point(result.part.edges.front().curve, 0)});
    if (result.part.loops.empty())
        result.problems.push_back({tree.where,
                                   "the part is empty: nothing is left of it",
                                   "check the places and sizes of what is intersected or subtracted",
                                   {0, 0}});
    return result;
}

}  // namespace abut::geometry
