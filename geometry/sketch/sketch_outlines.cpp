// SPDX-License-Identifier: GPL-3.0-or-later
//   1. Entities without length go. Splines that are arcs become arcs (sketch_arcs).
//   2. Of entities drawn twice the first stays (sketch_overlaps).
//   3. Ends are joined (sketch_joints), and joined entities walked into closed chains (sketch_chains).
//   4. Outlines that lines of others run through from corner to corner are drawn over them, and kept as they are
//   (sketch_overlaid). Where some do not close: those that lie on others go; if none does, they are cut where others end on
//   them, and the others
//      where they end (sketch_splits). So are outlines that share edges (sketch_shared). Then 2 and 3 again.
//   5. Facets that stand for arcs become arcs (sketch_arcs).
//   6. Curves are moved to their joints (sketch_joints), and the areas of outlines that share edges are found (sketch_faces).
#include "geometry/sketch/sketch_outlines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "geometry/sketch/sketch_arcs.hpp"
#include "geometry/sketch/sketch_crossings.hpp"
#include "geometry/sketch/sketch_names.hpp"
#include "geometry/sketch/sketch_open.hpp"
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

struct Tolerances {
    double joining = 0;      ///< ends
    double coincidence = 0;  ///< curves
    double facets = 0;       ///< of facets' joints from an arc: never more than what the size suggests
    double rounding = 0;
};

/// What is drawn is not larger than it is long: with a stray line far away the diagonal says nothing about the outlines' size,
/// and half the shortest entity would be no limit worth the name.
double size_of(const Pieces& entities, double total_length) {
    return std::min(box_of(entities).diagonal(), total_length);
}

Tolerances tolerances_of(const Pieces& entities, const SketchOptions& options, double rounding) {
    double shortest = std::numeric_limits<double>::infinity(), total = 0;
    for (const SketchPiece& entity : entities) {
        const double own = length(entity.curve);
        shortest = std::min(shortest, own);
        total += own;
    }
    const double size = size_of(entities, total), by_size = joining_fraction * size;
    const double joining = std::max(std::min(options.tolerance > 0 ? options.tolerance : by_size, shortest / 2), rounding);
    return {joining, std::max(std::min(joining, coincidence_fraction * size), rounding), std::min(joining, by_size), rounding};
}

/// Entities, and what they make as they are now.
struct State {
    Pieces entities;
    Joints joints;
    EntityChains chains;

    void trace(const Tolerances& tolerances, std::vector<Repair>& repairs) {
        remove_duplicates(entities, tolerances.coincidence, repairs);
        joints = join_ends(entities, tolerances.joining, tolerances.coincidence, tolerances.rounding);
        if (remove_twins(entities, joints, tolerances.joining, repairs))
            joints = join_ends(entities, tolerances.joining, tolerances.coincidence, tolerances.rounding);
        chains = trace_chains(entities, joints);
    }
};

/// Entities that are neither in a closed chain nor in a divided outline.
std::vector<bool> not_closed(const EntityChains& chains) {
    std::vector<bool> found = chains.is_loose;
    for (const std::vector<int>& block : chains.divided)
        for (const int e : block) found[static_cast<std::size_t>(e)] = false;
    return found;
}

/// What is to be cut where others end on it: all that is not closed by itself, and what outlines share that lie in each other.
std::vector<bool> to_cut(const State& state, const Tolerances& tolerances) {
    std::vector<bool> found = shared_from_inside(state.entities, state.chains.closed, tolerances.coincidence);
    if (std::find(found.begin(), found.end(), true) != found.end())  // what crosses is told as it is drawn
        for (const Crossing& crossing : find_crossings(state.entities, state.chains.closed, tolerances.coincidence))
            for (const int chain : {crossing.chain, crossing.other})
                for (const ChainLink& link : state.chains.closed[at(chain)]) found[at(link.entity)] = false;
    for (std::size_t i = 0; i < found.size(); ++i) found[i] = found[i] || state.chains.is_loose[i];
    return found;
}

/// Step 4.
void mend(State& state, const Tolerances& tolerances, std::vector<Repair>& repairs) {
    constexpr int most_rounds = 8;  // each round only removes or cuts; what takes more is no drawing to be mended
    for (int round = 0; round < most_rounds; ++round) {
        const bool is_less =
            !state.chains.loose.empty() &&
            remove_covered(state.entities, state.joints, not_closed(state.chains), tolerances.coincidence, repairs);
        if (!is_less && !split_at_ends(state.entities, state.joints, to_cut(state, tolerances), tolerances.joining,
                                       tolerances.coincidence, repairs))
            return;
        state.trace(tolerances, repairs);
    }
}

/// Takes out what is drawn over other outlines, which it would cut to pieces.
Pieces take_overlaid(State& state, const Tolerances& tolerances, std::vector<EntityChain>& chains) {
    const std::vector<bool> is_overlaid = overlaid_chains(state.entities, state.chains.closed, tolerances.coincidence);
    std::vector<bool> is_taken(state.entities.size(), false);
    Pieces taken;
    for (std::size_t c = 0; c < is_overlaid.size(); ++c) {
        if (!is_overlaid[c]) continue;
        chains.emplace_back();
        for (const ChainLink& link : state.chains.closed[c]) {
            is_taken[at(link.entity)] = true;
            chains.back().push_back({static_cast<int>(taken.size()), link.along});
            taken.push_back(state.entities[at(link.entity)]);
        }
    }
    std::size_t i = 0;
    std::erase_if(state.entities, [&](const SketchPiece&) { return is_taken[i++]; });
    return taken;
}

/// Puts back what take_overlaid took out, its ends joined.
void put_back(Outlines& outlines, Pieces taken, std::vector<EntityChain> chains, const Tolerances& tolerances) {
    close_joints(taken, join_ends(taken, tolerances.joining, tolerances.coincidence, tolerances.rounding), tolerances.rounding);
    const int offset = static_cast<int>(outlines.entities.size());
    outlines.entities.insert(outlines.entities.end(), taken.begin(), taken.end());
    for (EntityChain& chain : chains) {
        for (ChainLink& link : chain) link.entity += offset;
        outlines.closed.push_back(std::move(chain));
    }
}

void report_joints(const State& state, double rounding, std::vector<Repair>& repairs) {
    for (const Joint& joint : state.joints.joints) {
        if (joint.ends.size() < 2 || joint.gap <= rounding) continue;
        std::string names;
        for (std::size_t i = 0; i < joint.ends.size(); ++i)
            names += (i == 0                       ? ""
                      : i + 1 == joint.ends.size() ? " and "
                                                   : ", ") +
                     state.entities[static_cast<std::size_t>(joint.ends[i].entity)].name;
        repairs.push_back({"gap closed between " + names, joint.at, joint.gap, Repair::Kind::joined});
    }
}

/// Euler's formula: where lines cross without a joint, the areas about them are too few.
bool is_plane(const DividedOutline& divided, const Joints& joints, const std::vector<int>& block) {
    std::set<int> corners;
    for (const int e : block) corners.insert({joints.at_begin[at(e)], joints.at_end[at(e)]});
    return corners.size() + divided.faces.size() + 1 == block.size() + 2;
}

/// Blocks whose lines cross are cut there; the numbers of entities change with each.
void cut_tables(State& state, const Tolerances& tolerances, std::vector<Repair>& repairs) {
    for (std::size_t k = 0; k < state.chains.divided.size(); ++k) {
        const std::vector<int> block = state.chains.divided[k];
        if (is_plane(walk_faces(state.entities, state.joints, block), state.joints, block)) continue;
        if (!split_at_crossings(state.entities, block, CrossingLines::upright, tolerances.coincidence, repairs)) continue;
        state.trace(tolerances, repairs);
        mend(state, tolerances, repairs);
        k = static_cast<std::size_t>(-1);  // from the first again; a block that was cut is plane, or cannot be cut any more
    }
}

void cut_everywhere(State& state, const Tolerances& tolerances, std::vector<Repair>& repairs) {
    std::vector<int> all(state.entities.size());
    std::iota(all.begin(), all.end(), 0);
    if (split_at_crossings(state.entities, all, CrossingLines::all, tolerances.coincidence, repairs))
        state.trace(tolerances, repairs);
}

SketchProblem crossing_lines(const Pieces& entities, const std::vector<int>& block) {
    const SketchPiece& first = entities[at(block.front())];
    const auto of_insertion = std::find_if(block.begin(), block.end(), [&](int e) { return entities[at(e)].insertion >= 0; });
    const std::string hint = of_insertion == block.end() ? "" : block_hint(entities[at(*of_insertion)]);
    return {"lines that share areas on layer " + first.layer + " cross each other, near " + first.name, point(first.curve, 0.5),
            first.name, first.line, "put each part on a layer of its own, or mend it in CAD" + hint};
}

}  // namespace

ClosedOutlines close_outlines(const std::vector<SketchEntity>& entities, const SketchOptions& options, double rounding,
                              CrossingLines cut_at_crossings) {
    ClosedOutlines found;
    State state{pieces_of(entities), {}, {}};
    remove_without_length(state.entities, rounding, found.repairs);
    if (state.entities.empty()) return found;
    if (options.recognise_arcs) recognise_curves(state.entities, found.repairs);
    const Tolerances tolerances = tolerances_of(state.entities, options, rounding);
    found.tolerance = tolerances.joining;
    found.coincidence = tolerances.coincidence;

    state.trace(tolerances, found.repairs);
    std::vector<EntityChain> overlaid;
    Pieces over;
    if (cut_at_crossings == CrossingLines::all)
        cut_everywhere(state, tolerances, found.repairs);
    else
        over = take_overlaid(state, tolerances, overlaid);
    if (!over.empty()) state.trace(tolerances, found.repairs);
    mend(state, tolerances, found.repairs);
    if (cut_at_crossings == CrossingLines::upright) cut_tables(state, tolerances, found.repairs);
    report_joints(state, rounding, found.repairs);
    if (options.recognise_arcs && recognise_facets(state.entities, state.joints, tolerances.facets, found.repairs))
        state.trace(tolerances, found.repairs);
    close_joints(state.entities, state.joints, rounding);

    OpenLines open = tell_open_lines(state.entities, state.chains, tolerances.joining, options.leave_open);
    found.problems = std::move(open.problems);
    found.warnings = std::move(open.warnings);
    found.open_length = open.length;
    found.loose = state.chains.loose;
    found.outlines.closed = state.chains.closed;
    for (const std::vector<int>& block : state.chains.divided) {
        DividedOutline divided = walk_faces(state.entities, state.joints, block);
        if (is_plane(divided, state.joints, block))
            found.outlines.divided.push_back(std::move(divided));
        else
            found.problems.push_back(crossing_lines(state.entities, block));
    }
    found.outlines.entities = std::move(state.entities);
    put_back(found.outlines, std::move(over), std::move(overlaid), tolerances);
    return found;
}

}  // namespace abut::geometry
