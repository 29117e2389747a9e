// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_mended.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

#include "geometry/curves/written_digits.hpp"
#include "geometry/sketch/sketch_arcs.hpp"
#include "geometry/sketch/sketch_crossings.hpp"
#include "geometry/sketch/sketch_overlaid.hpp"
#include "geometry/sketch/sketch_overlaps.hpp"
#include "geometry/sketch/sketch_shared.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

using Pieces = std::vector<SketchPiece>;

Box2 box_of(const Pieces& entities) {
    Box2 box;
    for (const SketchPiece& entity : entities) box.extend(bounding_box(entity.curve));
    return box;
}

Pieces pieces_of(const std::vector<SketchEntity>& entities) {
    Pieces pieces;
    for (const SketchEntity& entity : entities)
        pieces.push_back({entity, entity.name, 0, 1, {static_cast<int>(pieces.size())}, length(entity.curve)});
    return pieces;
}

void remove_without_length(Pieces& entities, double rounding, std::vector<Repair>& repairs) {
    const double shortest = std::max(merge_fraction * box_of(entities).diagonal(), rounding);
    std::erase_if(entities, [&](const SketchPiece& entity) {
        const double own = length(entity.curve);
        if (own > shortest) return false;
        repairs.push_back(
            {entity.kind + " " + entity.name + " without length removed", point(entity.curve, 0), own, Repair::Kind::removed});
        return true;
    });
}

/// Curves closer than this fraction of the diagonal are one: exporters write six digits or more. Far below the joining
/// tolerance: the clearance between two outlines may be as small as that.
constexpr double coincidence_fraction = 1e-6;

/// What is drawn is not larger than it is long: with a stray line far away the diagonal says nothing about the outlines' size,
/// and half the shortest entity would be no limit worth the name.
double size_of(const Pieces& entities, double total_length) {
    return std::min(box_of(entities).diagonal(), total_length);
}

/// What rounding may put beside what it was meant to be on: lines that are not along an axis.
void set_slack(Pieces& entities, double written) {
    for (SketchPiece& entity : entities)
        if (const auto* line = std::get_if<Segment>(&entity.curve))
            if (line->from.x() != line->to.x() && line->from.y() != line->to.y()) entity.slack = 2 * written;
}

JoiningTolerances tolerances_of(const Pieces& entities, const SketchOptions& options, const Precision& precision,
                                bool is_rough) {
    const double rounding = precision.rounding;
    double shortest = std::numeric_limits<double>::infinity(), total = 0;
    for (const SketchPiece& entity : entities) {
        const double own = length(entity.curve);
        shortest = std::min(shortest, own);
        total += own;
    }
    const double size = size_of(entities, total), by_size = joining_fraction * size;
    const double joining = std::max(std::min(options.tolerance > 0 ? options.tolerance : by_size, shortest / 2), rounding);
    return {joining,
            is_rough ? std::max(std::min(joining, by_size), 2 * precision.written)
                     : std::max(std::min(joining, coincidence_fraction * size), rounding),
            std::min(joining, by_size), rounding, precision.written};
}

/// Entities that are neither in a closed chain nor in a divided outline.
std::vector<bool> not_closed(const EntityChains& chains) {
    std::vector<bool> found = chains.is_loose;
    for (const std::vector<int>& block : chains.divided)
        for (const int e : block) found[static_cast<std::size_t>(e)] = false;
    return found;
}

/// What is to be cut where others end on it: all that is not closed by itself, and what outlines share that lie in each other.
std::vector<bool> to_cut(const MendedLines& lines) {
    std::vector<bool> found = shared_from_inside(lines.entities, lines.chains.closed, lines.tolerances.coincidence);
    if (std::find(found.begin(), found.end(), true) != found.end())  // what crosses is told as it is drawn
        for (const Crossing& crossing : find_crossings(lines.entities, lines.chains.closed, lines.tolerances.coincidence))
            for (const int chain : {crossing.chain, crossing.other})
                for (const ChainLink& link : lines.chains.closed[at(chain)]) found[at(link.entity)] = false;
    for (std::size_t i = 0; i < found.size(); ++i) found[i] = found[i] || lines.chains.is_loose[i];
    return found;
}

/// Step 4.
void mend(MendedLines& lines) {
    constexpr int most_rounds = 8;  // each round only removes or cuts; what takes more is no drawing to be mended
    const JoiningTolerances& near = lines.tolerances;
    for (int round = 0; round < most_rounds; ++round) {
        const bool is_less =
            !lines.chains.loose.empty() &&
            remove_covered(lines.entities, lines.joints, not_closed(lines.chains), near.coincidence, lines.repairs);
        if (!is_less &&
            !split_at_ends(lines.entities, lines.joints, to_cut(lines), near.joining, near.coincidence, lines.repairs))
            return;
        trace(lines);
    }
}

/// Takes out what is drawn over other outlines, which it would cut to pieces.
void take_overlaid(MendedLines& lines) {
    const std::vector<bool> is_overlaid = overlaid_chains(lines.entities, lines.chains.closed, lines.tolerances.coincidence);
    std::vector<bool> is_taken(lines.entities.size(), false);
    for (std::size_t c = 0; c < is_overlaid.size(); ++c) {
        if (!is_overlaid[c]) continue;
        lines.over_chains.emplace_back();
        for (const ChainLink& link : lines.chains.closed[c]) {
            is_taken[at(link.entity)] = true;
            lines.over_chains.back().push_back({static_cast<int>(lines.over.size()), link.along});
            lines.over.push_back(lines.entities[at(link.entity)]);
        }
    }
    std::size_t i = 0;
    std::erase_if(lines.entities, [&](const SketchPiece&) { return is_taken[i++]; });
}

void cut_everywhere(MendedLines& lines) {
    std::vector<int> all(lines.entities.size());
    std::iota(all.begin(), all.end(), 0);
    if (split_at_crossings(lines.entities, all, CrossingLines::all, lines.tolerances.coincidence, lines.repairs)) trace(lines);
}

}  // namespace

Precision precision_of(const Drawing& drawing, double size) {
    const double unit = drawing.factor;
    double total = 0;
    Box2 box;
    std::vector<Vec2> ends, centres;
    std::vector<double> radii;
    for (const SketchEntity& entity : drawing.entities) {
        total += length(entity.curve);
        box.extend(bounding_box(entity.curve));
        if (const auto* line = std::get_if<Segment>(&entity.curve)) {
            ends.push_back(line->from / unit);
            ends.push_back(line->to / unit);
        } else if (const auto* arc = std::get_if<Arc>(&entity.curve); arc && is_full_turn(entity.curve)) {
            centres.push_back(arc->center / unit);
            radii.push_back(arc->radius / unit);
        }
    }
    const double all = std::min(total, box.diagonal()) / unit;
    return {rounding_fraction * size, unit * written_rounding(ends, all),
            unit * (written_rounding(centres, all) + written_rounding(radii, all))};
}

void trace(MendedLines& lines) {
    const JoiningTolerances& near = lines.tolerances;
    const auto join = [&] { return join_ends(lines.entities, near.joining, near.coincidence, near.rounding); };
    remove_duplicates(lines.entities, near.coincidence, lines.repairs);
    lines.joints = join();
    if (remove_twins(lines.entities, lines.joints, near.joining, lines.repairs)) lines.joints = join();
    lines.chains = trace_chains(lines.entities, lines.joints);
}

MendedLines mended_lines(const std::vector<SketchEntity>& entities, const SketchOptions& options, const Precision& precision,
                         Mending how) {
    MendedLines lines{pieces_of(entities)};
    remove_without_length(lines.entities, precision.rounding, lines.repairs);
    if (lines.entities.empty()) return lines;
    if (options.recognise_arcs) recognise_curves(lines.entities, lines.repairs);
    lines.tolerances = tolerances_of(lines.entities, options, precision, how == Mending::rough);
    set_slack(lines.entities, lines.tolerances.written);
    trace(lines);
    if (how == Mending::cut_at_crossings)
        cut_everywhere(lines);
    else
        take_overlaid(lines);
    if (!lines.over.empty()) trace(lines);
    mend(lines);
    return lines;
}

void cut_tables(MendedLines& lines) {
    for (std::size_t k = 0; k < lines.chains.divided.size(); ++k) {
        const std::vector<int> block = lines.chains.divided[k];
        if (is_plane(walk_faces(lines.entities, lines.joints, block), lines.joints, block)) continue;
        if (!split_at_crossings(lines.entities, block, CrossingLines::upright, lines.tolerances.coincidence, lines.repairs))
            continue;
        trace(lines);
        mend(lines);
        k = static_cast<std::size_t>(-1);  // from the first again; a block that was cut is plane, or cannot be cut any more
    }
}

// By Euler's formula.
bool is_plane(const DividedOutline& divided, const Joints& joints, const std::vector<int>& block) {
    std::set<int> corners;
    for (const int e : block) corners.insert({joints.at_begin[at(e)], joints.at_end[at(e)]});
    return corners.size() + divided.faces.size() + 1 == block.size() + 2;
}

}  // namespace abut::geometry
