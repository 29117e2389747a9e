// SPDX-License-Identifier: GPL-3.0-or-later
// Each group of entities (a layer, a block, ...) by itself: lines that two groups share are a contact between two parts, never
// a joint.
//   1. Entities are grouped (sketch_grouping). Far from the origin they are moved to it, by a number that loses no digit.
//   2. Those of each group are closed to outlines (sketch_outlines); insertions of a block that close by themselves have
//   nothing
//      to do with the others of their group here.
//   3. The outlines of a group are nested into parts (sketch_nesting), which are named (sketch_names).
//   4. Exact arithmetic has the last word on every part (csg/exact_outline).
#include "geometry/sketch/sketch.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

#include "geometry/brep/message_text.hpp"
#include "geometry/csg/exact_outline.hpp"
#include "geometry/sketch/sketch_drafting.hpp"
#include "geometry/sketch/sketch_grouping.hpp"
#include "geometry/sketch/sketch_names.hpp"
#include "geometry/sketch/sketch_outlines.hpp"
#include "geometry/sketch/sketch_pins.hpp"
#include "geometry/sketch/sketch_silhouettes.hpp"
#include "src/base/index.hpp"

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

std::vector<Hatch> moved(std::vector<Hatch> hatches, const Vec2& by) {
    if (by == Vec2(0, 0)) return hatches;
    for (Hatch& hatch : hatches)
        for (std::vector<Curve>& loop : hatch.loops)
            for (Curve& curve : loop) curve = transformed(curve, 1, 0, by);
    return hatches;
}

void move(SketchParts& sketch, const Vec2& by) {
    if (by == Vec2(0, 0)) return;
    for (Part& part : sketch.parts) part = transformed(part, 1, 0, by);
    for (Repair& repair : sketch.repairs) repair.at += by;
    for (SketchProblem& problem : sketch.problems) problem.at += by;
    for (SketchProblem& warning : sketch.warnings) warning.at += by;
    for (SketchRegion& region : sketch.regions) region.at += by;
}

// ---- one group ----

/// Adds what closes among some entities to a group's outlines.
void add_outlines(Outlines& to, Outlines from) {
    const int offset = static_cast<int>(to.entities.size());
    const auto shift = [&](EntityChain& chain) {
        for (ChainLink& link : chain) link.entity += offset;
    };
    for (EntityChain& chain : from.closed) shift(chain);
    for (DividedOutline& divided : from.divided) {
        shift(divided.contour);
        for (Face& face : divided.faces) shift(face.boundary);
    }
    append(to.entities, std::move(from.entities));
    append(to.closed, std::move(from.closed));
    append(to.divided, std::move(from.divided));
}

/// What closes among the entities of a group, by blocks of very different size perhaps.
struct GroupOutlines {
    Outlines outlines;
    double tolerance = 0;                                          ///< the largest that outlines took
    double coincidence = std::numeric_limits<double>::infinity();  ///< the smallest: what is large to one block is another
    double largest_tolerance = 0;                                  ///< also of what did not close
};

void add_closed(GroupOutlines& group, ClosedOutlines closed, SketchParts& sketch) {
    group.largest_tolerance = std::max(group.largest_tolerance, closed.tolerance);
    sketch.merged = std::max(sketch.merged, closed.coincidence);
    if (!closed.outlines.closed.empty() || !closed.outlines.divided.empty()) {
        group.tolerance = std::max(group.tolerance, closed.tolerance);
        group.coincidence = std::min(group.coincidence, closed.coincidence);
    }
    add_outlines(group.outlines, std::move(closed.outlines));
    append(sketch.repairs, std::move(closed.repairs));
    append(sketch.problems, std::move(closed.problems));
    append(sketch.warnings, std::move(closed.warnings));
    sketch.open_length += closed.open_length;
}

/// How a drawing's lines are mended.
struct MendingAs {
    SketchOptions options;
    Precision precision;
    Mending how = Mending::usual;
};

ClosedOutlines closed(const std::vector<SketchEntity>& entities, const MendingAs& as) {
    return close_outlines(mended_lines(entities, as.options, as.precision, as.how), as.options);
}

/// An insertion of a block that does not close by itself is a portion of something larger. `mended`: the whole group; null
/// where that is not known.
GroupOutlines close_group(const EntityGroup& group, const MendedLines* mended, const MendingAs& as, SketchParts& sketch) {
    GroupOutlines found;
    std::vector<std::vector<SketchEntity>> instances = by_instance(group.entities);
    std::vector<SketchEntity> rest = std::move(instances.front());
    for (std::size_t k = 1; k < instances.size(); ++k) {
        ClosedOutlines own = closed(instances[k], as);
        if (own.problems.empty() && own.open_length == 0)
            add_closed(found, std::move(own), sketch);
        else
            append(rest, std::move(instances[k]));
    }
    const bool is_known = mended && instances.size() == 1 && as.how == Mending::usual &&
                          mended->tolerances.rounding == as.precision.rounding &&
                          mended->tolerances.written == as.precision.written;
    add_closed(found, is_known ? close_outlines(*mended, as.options) : closed(rest, as), sketch);
    return found;
}

struct FoundPart {
    Part part;
    std::string label;
    int line = 0;
    int number = 0;  ///< in the order in which they were found
};

/// Is the part no wider than ends of so large a one are joined across? It lies between two drawings of one outline. Where it is
/// a ring that is hardly wider, that is in doubt.
void tell_film(const FoundPart& found, const SketchOptions& options, const Vec2& origin, SketchParts& sketch) {
    constexpr double doubtful_wall = 5e-4;  // of its size: less than any tube has that is not rolled of foil
    const double size = bounding_box(found.part).diagonal(), width = 2 * area(found.part) / perimeter(found.part),
                 tolerance = options.tolerance > 0 ? options.tolerance : joining_fraction * size;
    const Edge& edge = found.part.edges.front();
    const Vec2 place = point(edge.curve, 0) + origin;
    if (width <= tolerance)
        sketch.problems.push_back(
            {"part " + found.part.name + " is " + number_text(width) + " wide, less than what ends are joined across (" +
                 number_text(tolerance) + "): its outline is drawn twice",
             place, edge.name, found.line, "delete one of them, or give a smaller tolerance where it is a foil"});
    else if (found.part.loops.size() > 1 && width < doubtful_wall * size)
        sketch.warnings.push_back({"part " + found.part.name + " is hollow, its wall only " + number_text(width) +
                                       " thick: its outline may be drawn twice",
                                   place, edge.name, found.line, "if so, delete one of the two"});
}

/// `region_parts`: by region, its part among those found; -1 where it is none.
void add_parts(const std::string& group, const GroupOutlines& closed, const MaterialHints& hints, SketchParts& sketch,
               std::vector<FoundPart>& found, std::vector<int>& region_parts) {
    NestedParts nested = nest(closed.outlines, closed.tolerance, closed.coincidence, hints);
    for (SketchProblem& problem : nested.problems) problem.is_crossing = true;
    append(sketch.problems, std::move(nested.problems));
    append(sketch.warnings, std::move(nested.warnings));
    for (std::size_t r = 0; r < nested.regions.size(); ++r)
        region_parts.push_back(nested.part_of_region[r] < 0 ? -1 : static_cast<int>(found.size()) + nested.part_of_region[r]);
    append(sketch.regions, std::move(nested.regions));
    std::vector<std::vector<const SketchPiece*>> entities(nested.parts.size());
    std::vector<std::size_t> n_outer;
    for (std::size_t k = 0; k < nested.parts.size(); ++k) {
        for (const int e : nested.entity[k]) entities[k].push_back(&closed.outlines.entities[at(e)]);
        n_outer.push_back(nested.parts[k].loops.front().edges.size());
    }
    const std::vector<std::string> layers = group.empty() ? layers_of_parts(entities, n_outer) : std::vector<std::string>();
    for (std::size_t k = 0; k < nested.parts.size(); ++k) {
        Part& part = nested.parts[k];
        const SketchPiece& first = *entities[k].front();
        name_edges(part, entities[k]);
        part.name = nested.name[k].empty() ? part_name(first, group.empty() ? layers[k] : group) : nested.name[k];
        found.push_back({std::move(part), group.empty() ? layers[k] : group, first.line, static_cast<int>(found.size())});
    }
}

std::vector<Region> regions_inside(const Outlines& outlines) {
    std::vector<Region> regions;
    for (const EntityChain& chain : outlines.closed) regions.push_back(region_of(outlines.entities, chain));
    for (const DividedOutline& divided : outlines.divided) regions.push_back(region_of(outlines.entities, divided.contour));
    return regions;
}

// ---- all groups ----

/// What is made into parts.
struct DrawnLines {
    Drawing drawing;
    std::optional<MendedLines> mended{};  ///< of all entities, where that is known
};

/// What lies on a layer of its own says something about all parts, on the layer of a part about that.
std::vector<Hatch> hatches_of(const EntityGroup& group, const std::vector<EntityGroup>& groups, std::vector<Hatch> hatches) {
    std::erase_if(hatches, [&](const Hatch& hatch) {
        return hatch.look.layer != group.name && std::any_of(groups.begin(), groups.end(), [&](const EntityGroup& other) {
                   return other.name == hatch.look.layer;
               });
    });
    return hatches;
}

SketchParts sketch_by(const DrawnLines& lines, const SketchOptions& options, PartsBy parts_by, Mending how) {
    const Drawing& drawing = lines.drawing;
    const Box2 box = box_of(drawing.entities);
    const Vec2 origin = local_origin(box);
    const MendingAs as{options, precision_of(drawing, std::max(box.diagonal(), largest_coordinate(box))), how};
    SketchParts sketch;
    sketch.parts_by = parts_by;
    sketch.rounding = std::max(as.precision.written, as.precision.circles);
    std::vector<FoundPart> found;
    std::vector<int> region_parts;
    const std::vector<Hatch> hatches = moved(drawing.hatches, -origin);
    const std::vector<EntityGroup> groups = group_entities(moved(drawing.entities, -origin), parts_by);
    const MendedLines* mended = parts_by == PartsBy::loop && lines.mended ? &*lines.mended : nullptr;
    std::vector<GroupOutlines> closed;
    std::vector<std::vector<Region>> of_groups;
    for (const EntityGroup& group : groups) {
        closed.push_back(close_group(group, mended, as, sketch));
        sketch.tolerance = std::max(sketch.tolerance, closed.back().largest_tolerance);
        if (!hatches.empty() && groups.size() > 1) of_groups.push_back(regions_inside(closed.back().outlines));
    }
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const std::string& name = groups[g].name;
        const int first_number = static_cast<int>(sketch.regions.size()) + 1;
        const std::vector<Hatch> own = hatches_of(groups[g], groups, hatches);
        add_parts(name, closed[g],
                  {own, options.regions, first_number, !name.empty(), options.parts_by == PartsBy::automatic,
                   drawing.hole_layers, of_groups, g},
                  sketch, found, region_parts);
    }
    std::stable_sort(found.begin(), found.end(), [](const FoundPart& a, const FoundPart& b) { return a.line < b.line; });
    for (FoundPart& one : found) {
        tell_film(one, options, origin, sketch);
        sketch.parts.push_back(std::move(one.part));
        sketch.layers.push_back(std::move(one.label));
    }
    number_parts(sketch.parts);
    if (parts_by != PartsBy::loop && !are_bodies(drawing.entities)) cut_pins(sketch.parts, sketch.layers, sketch.warnings);
    std::vector<std::size_t> place(found.size());
    for (std::size_t k = 0; k < found.size(); ++k) place[at(found[k].number)] = k;
    for (std::size_t r = 0; r < region_parts.size(); ++r)
        if (region_parts[r] >= 0) sketch.regions[r].part = sketch.parts[place[at(region_parts[r])]].name;
    move(sketch, origin);
    return sketch;
}

/// Where lines or outlines cross: with all that lies within joining_fraction, or the coordinates' digits, taken for one,
/// if that leaves no problem. Where outlines are open that would close clearances.
SketchParts sketch_by(const DrawnLines& lines, const SketchOptions& options, PartsBy parts_by) {
    SketchParts usual = sketch_by(lines, options, parts_by, Mending::usual);
    const auto is_crossing = [](const SketchProblem& problem) { return problem.is_crossing; };
    if (usual.problems.empty() || !std::all_of(usual.problems.begin(), usual.problems.end(), is_crossing)) return usual;
    SketchParts rough = sketch_by(lines, options, parts_by, Mending::rough);
    if (!rough.problems.empty()) return usual;
    const SketchProblem& solved = usual.problems.front();
    rough.warnings.push_back({"lines less than " + number_text(rough.merged) +
                                  " apart are taken as one, since areas do not come out otherwise: " + solved.what,
                              solved.at, solved.entity, solved.line,
                              "draw ends on each other, or give a smaller tolerance to keep what is drawn apart"});
    return rough;
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

/// A drawing's diagonal times this: closer outlines touch. Exporters write six digits or more.
constexpr double touching_fraction = 1e-6;

/// Does all of it close?
bool is_whole(const SketchParts& sketch) {
    return sketch.problems.empty() && sketch.open_length == 0;
}

/// Does more of it close? Lines that bound nothing either way do not count.
bool closes_more(const SketchParts& sketch, const SketchParts& other) {
    constexpr double same = 1e-9;  // lengths are summed in another order
    if (sketch.problems.empty() != other.problems.empty()) return sketch.problems.empty();
    return sketch.open_length < (1 - same) * other.open_length;
}

/// Several layers hold closed outlines: they separate the parts, unless they do not close without each other, or hold holes of
/// others: by their names, or where all but one lie in the material of that.
SketchParts by_layers(const DrawnLines& lines, const SketchOptions& options, SketchParts by_layer, const std::string& why) {
    const Drawing& drawing = lines.drawing;
    const double coincidence = touching_fraction * box_of(drawing.entities).diagonal();
    const bool is_inside = !are_bodies(drawing.entities) && are_others_its_holes(by_layer.parts, by_layer.layers);
    const bool is_assembly = is_inside && do_others_touch(by_layer.parts, by_layer.layers, coincidence);
    const bool are_holes = is_inside && !is_assembly;
    const auto named = std::find_if(by_layer.layers.begin(), by_layer.layers.end(),
                                    [&](const std::string& layer) { return drawing.hole_layers.contains(layer); });
    const bool has_named = named != by_layer.layers.end();
    if (!are_holes && !has_named && is_whole(by_layer))
        return with_reason(
            std::move(by_layer),
            is_assembly ? why + "; one is drawn behind all others, as the frame of a sheet is: ignore it then" : why);
    SketchParts by_loop = sketch_by(lines, options, PartsBy::loop);
    if (has_named && is_whole(by_loop)) return with_reason(std::move(by_loop), why + ", of which " + *named + " holds holes");
    const std::string reason = are_holes ? why + ", but all others lie in the material of one, as holes do"
                                         : why + ", but not all close without what is on other layers";
    const bool is_cut_only = !are_holes && are_divided(by_layer.parts, by_loop.parts);
    if (are_holes ? by_loop.problems.empty() || !by_layer.problems.empty() : closes_more(by_loop, by_layer) && !is_cut_only)
        return with_reason(std::move(by_loop), reason);
    return with_reason(std::move(by_layer), why);
}

bool is_on_one_layer(const std::vector<SketchEntity>& entities) {
    return std::all_of(entities.begin(), entities.end(),
                       [&](const SketchEntity& entity) { return entity.layer == entities.front().layer; });
}

/// By outline, unless what other layers hold cuts a layer's parts and bounds nothing else: edges that are hidden, bent or
/// engraved.
SketchParts by_loop_or_undivided(SketchParts by_loop, SketchParts by_layer, const std::string& why) {
    const bool is_cut = !is_whole(by_layer) && are_divided(by_layer.parts, by_loop.parts);
    return with_reason(std::move(is_cut ? by_layer : by_loop), why);
}

/// By layer where several hold closed outlines, by block where everything lies in several blocks, else by outline.
SketchParts automatic_parts(const DrawnLines& lines, const SketchOptions& options) {
    const Drawing& drawing = lines.drawing;
    if (is_on_one_layer(drawing.entities) && !is_all_in_blocks(drawing.entities)) {
        SketchParts by_loop = sketch_by(lines, options, PartsBy::loop);
        const std::string why = quoted_layers({by_loop.layers.begin(), by_loop.layers.end()});
        if (is_whole(by_loop)) return with_reason(std::move(by_loop), why);  // the layer tells nothing more
        return by_loop_or_undivided(std::move(by_loop), sketch_by(lines, options, PartsBy::layer), why);
    }
    SketchParts by_layer = sketch_by(lines, options, PartsBy::layer);
    const std::set<std::string> layers(by_layer.layers.begin(), by_layer.layers.end());
    std::string why = quoted_layers(layers);
    if (layers.size() > 1) return by_layers(lines, options, std::move(by_layer), why);
    if (is_all_in_blocks(drawing.entities)) {
        SketchParts by_block = sketch_by(lines, options, PartsBy::block);
        why += ", and everything lies in several blocks";
        if (!are_others_its_holes(by_block.parts, by_block.layers)) {
            if (is_whole(by_block)) return with_reason(std::move(by_block), why);
            SketchParts joined = sketch_by(lines, options, PartsBy::loop);
            if (!closes_more(joined, by_block)) return with_reason(std::move(by_block), why);
            return with_reason(std::move(joined), why + ", but these close only together");
        }
        why += ", but all others lie in the material of one, as holes do";
    }
    return by_loop_or_undivided(sketch_by(lines, options, PartsBy::loop), std::move(by_layer), why);
}

/// Is there no curve that may turn out to be a line or an arc?
bool has_plain_curves(const std::vector<SketchEntity>& entities) {
    return std::all_of(entities.begin(), entities.end(), [](const SketchEntity& entity) {
        return std::holds_alternative<Segment>(entity.curve) || std::holds_alternative<Arc>(entity.curve);
    });
}

/// The drawing without its sheet and what explains it, which the warnings tell.
DrawnLines without_drafting(Drawing drawing, const SketchOptions& options, std::vector<SketchProblem>& warnings) {
    if (options.keep_drafting || are_bodies(drawing.entities)) return {std::move(drawing)};
    const Vec2 origin = local_origin(box_of(drawing.entities));
    Drawing local;
    local.entities = moved(drawing.entities, -origin);
    local.texts = drawing.texts;
    for (DrawnText& text : local.texts) text.at -= origin;
    for (const Vec2& tip : drawing.arrows) local.arrows.push_back(tip - origin);
    DraftingFound found = find_drafting(local, options);
    for (SketchProblem& warning : found.warnings) warning.at += origin;
    append(warnings, std::move(found.warnings));
    std::size_t i = 0;
    std::erase_if(drawing.entities, [&](const SketchEntity&) { return found.is_drafting[i++]; });
    if (options.recognise_arcs && !has_plain_curves(drawing.entities)) found.mended.reset();
    return {std::move(drawing), std::move(found.mended)};
}

/// The drawing with outlines around blocks in place of these, where that is asked for.
Drawing with_block_outlines(Drawing drawing, const SketchOptions& options, SketchParts& told) {
    if (options.block_outline.empty()) return drawing;
    const Vec2 origin = local_origin(box_of(drawing.entities));
    Drawing local;
    local.entities = moved(drawing.entities, -origin);
    local.insertions = drawing.insertions;
    Silhouettes found = block_silhouettes(local, options);
    drawing.entities = moved(std::move(found.entities), origin);
    told.repairs = std::move(found.repairs);
    told.problems = std::move(found.problems);
    told.warnings = std::move(found.warnings);
    move(told, origin);
    return drawing;
}

/// Without any part, what does not close is a fault.
void refuse_without_parts(SketchParts& sketch) {
    if (!sketch.parts.empty() || !sketch.problems.empty()) return;
    sketch.problems = std::exchange(sketch.warnings, {});
}

/// What was merged, in one warning for each kind: the repairs have all of it.
void tell_repairs(SketchParts& sketch) {
    for (const Repair::Kind kind : {Repair::Kind::removed, Repair::Kind::joined}) {
        const Repair* largest = nullptr;
        int n = 0;
        for (const Repair& repair : sketch.repairs) {
            if (repair.kind != kind) continue;
            ++n;
            if (!largest || repair.size > largest->size) largest = &repair;
        }
        if (!largest) continue;
        const std::string what = kind == Repair::Kind::removed
                                     ? "lines or arcs that lie on others, or have no length, merged with these"
                                     : "gaps between ends closed";
        sketch.warnings.push_back(
            {std::to_string(n) + " " + what + "; the largest: " + largest->what + ", " + number_text(largest->size),
             largest->at,
             {},
             0,
             "abut inspect lists them"});
    }
}

void check_exactly(SketchParts& sketch) {
    for (const Part& part : sketch.parts)
        if (const std::optional<OutlineFault> fault = exact_fault(part))
            sketch.problems.push_back(
                {"part " + part.name + ": " + fault->what + " near " + place_text(fault->at), fault->at, "", 0, fault->hint});
}

}  // namespace

SketchParts parts_of(const Drawing& drawing, const SketchOptions& options) {
    SketchParts before;
    const DrawnLines outlines = without_drafting(with_block_outlines(drawing, options, before), options, before.warnings);
    SketchParts sketch = options.parts_by == PartsBy::automatic
                             ? automatic_parts(outlines, options)
                             : with_reason(sketch_by(outlines, options, options.parts_by), "asked for");
    sketch.repairs.insert(sketch.repairs.begin(), before.repairs.begin(), before.repairs.end());
    sketch.problems.insert(sketch.problems.begin(), before.problems.begin(), before.problems.end());
    sketch.warnings.insert(sketch.warnings.begin(), before.warnings.begin(), before.warnings.end());
    refuse_without_parts(sketch);
    tell_repairs(sketch);
    check_exactly(sketch);
    return sketch;
}

}  // namespace abut::geometry
