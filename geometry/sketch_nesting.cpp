// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch_nesting.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/sketch_crossings.hpp"

namespace abut::geometry {

namespace {

/// A closed chain as a part without holes, run counter-clockwise.
struct Outline {
    Part region;
    Box2 box;
    double area = 0;
    int first_entity = 0;
    int depth = 0;    ///< number of outlines around it
    int parent = -1;  ///< the smallest of them
};

Edge edge_of(const SketchEntity& entity, bool along) {
    return {along ? entity.curve : reversed(entity.curve), entity.name, entity.name, along, 0.0};
}

/// The same boundary run the other way.
std::vector<Edge> turned(std::vector<Edge> edges) {
    std::reverse(edges.begin() + 1, edges.end());  // the first edge stays first
    for (Edge& edge : edges) {
        edge.curve = reversed(edge.curve);
        edge.along_source = !edge.along_source;
    }
    return edges;
}

Outline outline_of(const std::vector<SketchEntity>& entities, const std::vector<ChainLink>& chain) {
    Outline outline;
    for (const ChainLink& link : chain)
        outline.region.edges.push_back(edge_of(entities[static_cast<std::size_t>(link.entity)], link.along));
    outline.area = area(outline.region);
    if (outline.area < 0) outline.region.edges = turned(std::move(outline.region.edges));
    outline.area = std::abs(outline.area);
    outline.box = bounding_box(outline.region);
    outline.first_entity = chain.front().entity;
    return outline;
}

double distance_to(const Part& region, const Vec2& p) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Edge& edge : region.edges)
        smallest = std::min(smallest, (point(edge.curve, closest_parameter(edge.curve, p)) - p).norm());
    return smallest;
}

bool is_within(const Box2& inner, const Box2& outer, double margin) {
    return (inner.min.array() >= outer.min.array() - margin).all() && (inner.max.array() <= outer.max.array() + margin).all();
}

/// Outlines do not cross here, so one point decides; it is to be clear of the other's boundary, which the inner one may touch.
bool is_inside(const Outline& inner, const Outline& outer, double tolerance) {
    if (inner.area >= outer.area || !is_within(inner.box, outer.box, tolerance)) return false;
    for (const Edge& edge : inner.region.edges)
        for (double t : {0.0, 0.5}) {
            const Vec2 p = point(edge.curve, t);
            if (distance_to(outer.region, p) > tolerance) return contains(outer.region, p);
        }
    return false;
}

void find_depths(std::vector<Outline>& outlines, double tolerance) {
    for (Outline& inner : outlines)
        for (std::size_t k = 0; k < outlines.size(); ++k) {
            if (&inner == &outlines[k] || !is_inside(inner, outlines[k], tolerance)) continue;
            ++inner.depth;
            if (inner.parent < 0 || outlines[k].area < outlines[static_cast<std::size_t>(inner.parent)].area)
                inner.parent = static_cast<int>(k);
        }
}

bool is_hole(const Outline& outline) {
    return outline.depth % 2 == 1;
}

void append_loop(Part& part, const std::vector<Edge>& edges) {
    Loop loop;
    for (const Edge& edge : edges) {
        loop.edges.push_back(static_cast<int>(part.edges.size()));
        part.edges.push_back(edge);
    }
    part.loops.push_back(std::move(loop));
}

void assemble(const std::vector<Outline>& outlines, NestedParts& nested) {
    std::vector<int> part_of(outlines.size(), -1);
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        if (is_hole(outlines[i])) continue;
        part_of[i] = static_cast<int>(nested.parts.size());
        nested.first_entity.push_back(outlines[i].first_entity);
        append_loop(nested.parts.emplace_back(), outlines[i].region.edges);
    }
    for (const Outline& outline : outlines)
        if (is_hole(outline)) {
            const int part = part_of[static_cast<std::size_t>(outline.parent)];
            append_loop(nested.parts[static_cast<std::size_t>(part)], turned(outline.region.edges));
        }
}

}  // namespace

NestedParts nest(const std::vector<SketchEntity>& entities, const std::vector<std::vector<ChainLink>>& chains,
                 double tolerance) {
    NestedParts nested;
    std::vector<std::vector<ChainLink>> sound = chains;
    nested.problems = remove_crossing(entities, sound, tolerance);
    std::vector<Outline> outlines;
    for (const auto& chain : sound) outlines.push_back(outline_of(entities, chain));
    find_depths(outlines, tolerance);
    assemble(outlines, nested);
    return nested;
}

}  // namespace abut::geometry
