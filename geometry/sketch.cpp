// SPDX-License-Identifier: GPL-3.0-or-later
// Each group of entities (a layer, a block, ...) by itself: lines that two groups share are a contact between two parts, never
// a joint.
//   1. Entities are grouped (sketch_grouping). Far from the origin they are moved to it, by a number that loses no digit.
//   2. Those of each group are closed to outlines (sketch_outlines); insertions of a block that close by themselves have
//   nothing
//      to do with the others of their group here.
//   3. The outlines of a group are nested into parts (sketch_nesting), which are named (sketch_names).
#include "geometry/sketch.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "geometry/sketch_grouping.hpp"
#include "geometry/sketch_names.hpp"
#include "geometry/sketch_outlines.hpp"

namespace abut::geometry {

namespace {

template <class T>
void append(std::vector<T>& to, std::vector<T> from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

// ---- a local origin ----

/// Farther from the origin than so many diagonals, coordinates are taken from a local one.
constexpr double far_ratio = 16;

Box2 box_of(const std::vector<SketchEntity>& entities) {
    Box2 box;
    for (const SketchEntity& entity : entities) box.extend(bounding_box(entity.curve));
    return box;
}

double largest_coordinate(const Box2& box) {
    return box.empty() ? 0.0 : std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff());
}

/// A multiple of a power of two about as large as the drawing: subtracting it, and adding it again, rounds nothing.
Vec2 local_origin(const Box2& box) {
    const double diagonal = box.diagonal();
    if (!(diagonal > 0) || largest_coordinate(box) <= far_ratio * diagonal) return {0, 0};
    const double step = std::exp2(std::ceil(std::log2(diagonal)));
    return {step * std::round(box.center().x() / step), step * std::round(box.center().y() / step)};
}

std::vector<SketchEntity> moved(std::vector<SketchEntity> entities, const Vec2& by) {
    if (by == Vec2(0, 0)) return entities;
    for (SketchEntity& entity : entities) entity.curve = transformed(entity.curve, 1, 0, by);
    return entities;
}

void move(SketchParts& sketch, const Vec2& by) {
    if (by == Vec2(0, 0)) return;
    for (Part& part : sketch.parts) part = transformed(part, 1, 0, by);
    for (Repair& repair : sketch.repairs) repair.at += by;
    for (SketchProblem& problem : sketch.problems) problem.at += by;
}

// ---- one group ----

/// Adds what closes among some entities to a group's outlines.
void add_outlines(Outlines& to, Outlines from) {
    const int offset = static_cast<int>(to.entities.size());
    const auto shift = [&](Chain& chain) {
        for (ChainLink& link : chain) link.entity += offset;
    };
    for (Chain& chain : from.closed) shift(chain);
    for (DividedOutline& divided : from.divided) {
        shift(divided.contour);
        for (Face& face : divided.faces) shift(face.boundary);
    }
    append(to.entities, std::move(from.entities));
    append(to.closed, std::move(from.closed));
    append(to.divided, std::move(from.divided));
}

/// What closes among the entities of a group, and the largest tolerance it took.
struct GroupOutlines {
    Outlines outlines;
    double tolerance = 0, coincidence = 0;
};

void add_closed(GroupOutlines& group, ClosedOutlines closed, SketchParts& sketch) {
    add_outlines(group.outlines, std::move(closed.outlines));
    append(sketch.repairs, std::move(closed.repairs));
    append(sketch.problems, std::move(closed.problems));
    group.tolerance = std::max(group.tolerance, closed.tolerance);
    group.coincidence = std::max(group.coincidence, closed.coincidence);
}

/// An insertion of a block that does not close by itself is a portion of something larger.
GroupOutlines close_group(const EntityGroup& group, const SketchOptions& options, double rounding, SketchParts& sketch) {
    GroupOutlines found;
    std::vector<std::vector<SketchEntity>> instances = by_instance(group.entities);
    std::vector<SketchEntity> rest = std::move(instances.front());
    for (std::size_t k = 1; k < instances.size(); ++k) {
        ClosedOutlines closed = close_outlines(instances[k], options, rounding);
        if (closed.problems.empty())
            add_closed(found, std::move(closed), sketch);
        else
            append(rest, std::move(instances[k]));
    }
    add_closed(found, close_outlines(rest, options, rounding), sketch);
    return found;
}

struct FoundPart {
    Part part;
    std::string label;
    int line = 0;
};

void add_parts(const EntityGroup& group, const SketchOptions& options, double rounding, SketchParts& sketch,
               std::vector<FoundPart>& found) {
    const GroupOutlines closed = close_group(group, options, rounding, sketch);
    sketch.tolerance = std::max(sketch.tolerance, closed.tolerance);
    NestedParts nested = nest(closed.outlines, closed.tolerance, closed.coincidence);
    append(sketch.problems, std::move(nested.problems));
    append(sketch.repairs, std::move(nested.remarks));
    for (std::size_t k = 0; k < nested.parts.size(); ++k) {
        std::vector<const SketchPiece*> entity;
        for (const int e : nested.entity[k]) entity.push_back(&closed.outlines.entities[static_cast<std::size_t>(e)]);
        Part& part = nested.parts[k];
        name_edges(part, entity);
        entity.resize(part.loops.front().edges.size());
        part.name = part_name(entity, group.name);
        found.push_back({std::move(part), group.name.empty() ? entity.front()->layer : group.name, entity.front()->line});
    }
}

// ---- all groups ----

SketchParts sketch_by(const Drawing& drawing, const SketchOptions& options, PartsBy parts_by) {
    const Box2 box = box_of(drawing.entities);
    const Vec2 origin = local_origin(box);
    const double rounding = rounding_fraction * std::max(box.diagonal(), largest_coordinate(box));
    SketchParts sketch;
    sketch.parts_by = parts_by;
    std::vector<FoundPart> found;
    for (const EntityGroup& group : group_entities(moved(drawing.entities, -origin), parts_by))
        add_parts(group, options, rounding, sketch, found);
    std::stable_sort(found.begin(), found.end(), [](const FoundPart& a, const FoundPart& b) { return a.line < b.line; });
    for (FoundPart& one : found) {
        sketch.parts.push_back(std::move(one.part));
        sketch.layers.push_back(std::move(one.label));
    }
    number_parts(sketch.parts);
    move(sketch, origin);
    return sketch;
}

SketchParts with_reason(SketchParts sketch, const std::string& why) {
    sketch.why = why;
    return sketch;
}

std::string quoted_layers(const std::set<std::string>& layers) {
    if (layers.empty()) return "no layer by itself holds a closed outline";
    return layers.size() == 1 ? "layer " + *layers.begin() + " alone holds closed outlines"
                              : std::to_string(layers.size()) + " layers hold closed outlines";
}

/// By layer where several hold closed outlines, by block where everything lies in several blocks, else by outline. Layers that
/// do not close without each other do not separate parts, nor do layers or blocks that hold the holes of another one.
SketchParts automatic_parts(const Drawing& drawing, const SketchOptions& options) {
    SketchParts by_layer = sketch_by(drawing, options, PartsBy::layer);
    const std::set<std::string> layers(by_layer.layers.begin(), by_layer.layers.end());
    std::string why = quoted_layers(layers);
    if (layers.size() > 1) {
        const bool are_holes = !are_bodies(drawing.entities) && are_others_its_holes(by_layer.parts, by_layer.layers);
        if (!are_holes && by_layer.problems.empty()) return with_reason(std::move(by_layer), why);
        SketchParts by_loop = sketch_by(drawing, options, PartsBy::loop);
        const std::string reason = are_holes ? why + ", but all others lie in the material of one, as holes do"
                                             : why + ", but not all close without what is on other layers";
        if (by_loop.problems.empty() || (are_holes && !by_layer.problems.empty()))
            return with_reason(std::move(by_loop), reason);
        return with_reason(std::move(by_layer), why);
    }
    if (is_all_in_blocks(drawing.entities)) {
        SketchParts by_block = sketch_by(drawing, options, PartsBy::block);
        why += ", and everything lies in several blocks";
        if (!are_others_its_holes(by_block.parts, by_block.layers)) return with_reason(std::move(by_block), why);
        why += ", but all others lie in the material of one, as holes do";
    }
    return with_reason(sketch_by(drawing, options, PartsBy::loop), why);
}

}  // namespace

SketchParts parts_of(const Drawing& drawing, const SketchOptions& options) {
    if (options.parts_by == PartsBy::automatic) return automatic_parts(drawing, options);
    return with_reason(sketch_by(drawing, options, options.parts_by), "asked for");
}

SketchParts parts_by_layer(const Drawing& drawing, const SketchOptions& options) {
    return with_reason(sketch_by(drawing, options, PartsBy::layer), "asked for");
}

}  // namespace abut::geometry
