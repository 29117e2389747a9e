// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/boolean.hpp"

#include <variant>

#include "geometry/csg/exact_regions.hpp"
#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

/// Walks the tree in reading order, so that the next leaf is always the next primitive.
class Evaluator {
public:
    Evaluator(ExactPrimitives& primitives, const BoundingDisc& disc) : primitives_(primitives), disc_(disc) {}

    ExactRegion evaluate(const CsgNode& node) {
        if (const auto* place = std::get_if<Placed>(&node.shape)) return evaluate(place->of.front());
        if (const auto* common = std::get_if<Intersection>(&node.shape)) return intersection(*common);
        if (std::holds_alternative<Difference>(node.shape)) return difference(node);
        ExactPolygons polygons;
        gather(node, polygons);
        return joined(polygons);
    }

    std::vector<GeometryProblem> problems;

private:
    /// Polygons whose union is the node: nested unions are opened, so that everything is joined in one go.
    void gather(const CsgNode& node, ExactPolygons& polygons) {
        if (const auto* place = std::get_if<Placed>(&node.shape)) return gather(place->of.front(), polygons);
        if (const auto* all = std::get_if<Union>(&node.shape)) {
            for (const CsgNode& child : all->of) gather(child, polygons);
        } else if (std::holds_alternative<Intersection>(node.shape) || std::holds_alternative<Difference>(node.shape)) {
            append(evaluate(node), polygons);
        } else {
            add_primitive(node, polygons);
        }
    }

    ExactRegion intersection(const Intersection& node) {
        ExactRegion region = evaluate(node.of.front());
        for (std::size_t i = 1; i < node.of.size(); ++i) intersect(region, evaluate(node.of[i]));
        return region;
    }

    /// (a less b) less c is a less (b and c): one difference whatever the number of tools.
    ExactRegion difference(const CsgNode& node) {
        ExactPolygons tools;
        ExactRegion region = minuend(node, tools);
        subtract(region, joined(tools));
        return region;
    }

    ExactRegion minuend(const CsgNode& node, ExactPolygons& tools) {
        if (const auto* place = std::get_if<Placed>(&node.shape)) return minuend(place->of.front(), tools);
        const auto* difference = std::get_if<Difference>(&node.shape);
        if (!difference) return evaluate(node);
        ExactRegion region = minuend(difference->of.front(), tools);
        for (std::size_t i = 1; i < difference->of.size(); ++i) gather(difference->of[i], tools);
        return region;
    }

    void add_primitive(const CsgNode& node, ExactPolygons& polygons) {
        const std::size_t k = next_primitive_++;
        if (const auto* half = std::get_if<HalfPlane>(&node.shape))
            primitives_.append_half_plane(k, *half, disc_, polygons);
        else
            primitives_.append(k, polygons, problems);
    }

    ExactPrimitives& primitives_;
    BoundingDisc disc_;
    std::size_t next_primitive_ = 0;
};

}  // namespace

BooleanBoundary boolean_boundary(const CsgNode& tree, const std::vector<Primitive>& primitives,
                                 const std::vector<PlacedSource>& sources, const Carriers& carriers, const BoundingDisc& disc) {
    ENSURE(carriers.of_source.size() == sources.size(), "it is known of every source where it lies on carriers");
    ENSURE(disc.radius > 0, "half planes reach beyond what is bounded");
    ExactPrimitives exact(primitives, sources, carriers);
    Evaluator evaluator(exact, disc);
    const ExactRegion region = evaluator.evaluate(tree);
    BooleanBoundary boundary;
    boundary.problems = std::move(evaluator.problems);
    if (boundary.problems.empty()) boundary.loops = exact.loops(region);
    return boundary;
}

}  // namespace abut::geometry
