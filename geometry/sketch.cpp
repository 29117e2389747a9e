// SPDX-License-Identifier: GPL-3.0-or-later
// Each layer by itself: lines that two layers share are a contact between two parts, never a joint.
//   1. Entities without length go.
//   2. Of entities drawn twice the first stays (sketch_overlaps).
//   3. Ends are joined (sketch_joints).
//   4. Joined entities are walked into closed chains (sketch_chains). Where some stay loose, those that lie on others go, and
//      3 and 4 are done again.
//   5. Curves are moved to their joints (sketch_joints).
//   6. Closed chains are nested into parts (sketch_nesting).
#include "geometry/sketch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/sketch_chains.hpp"
#include "geometry/sketch_joints.hpp"
#include "geometry/sketch_nesting.hpp"
#include "geometry/sketch_overlaps.hpp"

namespace abut::geometry {

namespace {

struct LayerParts {
    std::string layer;
    std::vector<Part> parts;
    std::vector<int> lines;  ///< of each part's first entity in the file
};

Box2 box_of(const std::vector<SketchEntity>& entities) {
    Box2 box;
    for (const SketchEntity& entity : entities) box.extend(bounding_box(entity.curve));
    return box;
}

/// Coordinates carry rounding errors of their own size, which far from the origin is more than the drawing's.
double rounding_of(const Box2& box) {
    return rounding_fraction * std::max({box.diagonal(), box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff()});
}

void remove_without_length(std::vector<SketchEntity>& entities, std::vector<Repair>& repairs) {
    const double shortest = merge_fraction * box_of(entities).diagonal();
    std::erase_if(entities, [&](const SketchEntity& entity) {
        const double own = length(entity.curve);
        if (own > shortest) return false;
        repairs.push_back({entity.kind + " " + entity.name + " without length removed", point(entity.curve, 0), own});
        return true;
    });
}

double joining_tolerance(const std::vector<SketchEntity>& entities, const SketchOptions& options) {
    double shortest = std::numeric_limits<double>::infinity();
    for (const SketchEntity& entity : entities) shortest = std::min(shortest, length(entity.curve));
    const double wanted = options.tolerance > 0 ? options.tolerance : joining_fraction * box_of(entities).diagonal();
    return std::min(wanted, shortest / 2);
}

void report_joints(const std::vector<SketchEntity>& entities, const Joints& joints, double rounding,
                   std::vector<Repair>& repairs) {
    for (const Joint& joint : joints.joints) {
        if (joint.ends.size() != 2 || joint.gap <= rounding) continue;
        const auto name = [&](std::size_t i) { return entities[static_cast<std::size_t>(joint.ends[i].entity)].name; };
        repairs.push_back({"gap closed between " + name(0) + " and " + name(1), joint.at, joint.gap});
    }
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

/// Steps 1 to 6 for one layer; not empty.
LayerParts parts_of_layer(std::vector<SketchEntity> entities, const SketchOptions& options, SketchParts& sketch) {
    LayerParts found;
    found.layer = entities.front().layer;
    remove_without_length(entities, sketch.repairs);
    if (entities.empty()) return found;
    const double rounding = rounding_of(box_of(entities));
    const double tolerance = std::max(joining_tolerance(entities, options), rounding);
    sketch.tolerance = std::max(sketch.tolerance, tolerance);
    remove_duplicates(entities, tolerance, sketch.repairs);

    Joints joints = join_ends(entities, tolerance, rounding);
    Chains chains = trace_chains(entities, joints, tolerance);
    if (!chains.problems.empty() && remove_covered(entities, chains.is_loose, tolerance, sketch.repairs)) {
        joints = join_ends(entities, tolerance, rounding);
        chains = trace_chains(entities, joints, tolerance);
    }
    append(sketch.problems, chains.problems);
    report_joints(entities, joints, rounding, sketch.repairs);
    close_joints(entities, joints, rounding);
    NestedParts nested = nest(entities, chains.closed, tolerance);
    append(sketch.problems, nested.problems);

    found.parts = std::move(nested.parts);
    for (int entity : nested.first_entity) found.lines.push_back(entities[static_cast<std::size_t>(entity)].line);
    return found;
}

std::vector<std::vector<SketchEntity>> split_by_layer(const std::vector<SketchEntity>& entities) {
    std::vector<std::vector<SketchEntity>> layers;
    std::map<std::string, std::size_t> index;
    for (const SketchEntity& entity : entities) {
        const auto [at, is_new] = index.emplace(entity.layer, layers.size());
        if (is_new) layers.emplace_back();
        layers[at->second].push_back(entity);
    }
    return layers;
}

void name_parts(LayerParts& found) {
    for (std::size_t k = 0; k < found.parts.size(); ++k)
        found.parts[k].name = found.parts.size() == 1 ? found.layer : found.layer + "#" + std::to_string(k);
}

void collect(std::vector<LayerParts>& layers, SketchParts& sketch) {
    struct Entry {
        int line;
        Part* part;
        const std::string* layer;
    };
    std::vector<Entry> entries;
    for (LayerParts& found : layers)
        for (std::size_t k = 0; k < found.parts.size(); ++k) entries.push_back({found.lines[k], &found.parts[k], &found.layer});
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.line < b.line; });
    for (const Entry& entry : entries) {
        sketch.parts.push_back(std::move(*entry.part));
        sketch.layers.push_back(*entry.layer);
    }
}

}  // namespace

SketchParts parts_by_layer(const Drawing& drawing, const SketchOptions& options) {
    SketchParts sketch;
    std::vector<LayerParts> layers;
    for (std::vector<SketchEntity>& entities : split_by_layer(drawing.entities)) {
        layers.push_back(parts_of_layer(std::move(entities), options, sketch));
        name_parts(layers.back());
    }
    collect(layers, sketch);
    return sketch;
}

}  // namespace abut::geometry
