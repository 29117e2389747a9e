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
#include <utility>

#include "geometry/sketch/sketch_arcs.hpp"
#include "geometry/sketch/sketch_names.hpp"
#include "geometry/sketch/sketch_open.hpp"
#include "geometry/sketch/sketch_splits.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

/// Puts back what was drawn over other outlines, its ends joined.
void put_back(Outlines& outlines, MendedLines& lines) {
    const JoiningTolerances& near = lines.tolerances;
    close_joints(lines.over, join_ends(lines.over, near.joining, near.coincidence, near.rounding), near.rounding);
    const int offset = static_cast<int>(outlines.entities.size());
    outlines.entities.insert(outlines.entities.end(), lines.over.begin(), lines.over.end());
    for (EntityChain& chain : lines.over_chains) {
        for (ChainLink& link : chain) link.entity += offset;
        outlines.closed.push_back(std::move(chain));
    }
}

void report_joints(MendedLines& lines) {
    for (const Joint& joint : lines.joints.joints) {
        if (joint.ends.size() < 2 || joint.gap <= lines.tolerances.rounding) continue;
        std::string names;
        for (std::size_t i = 0; i < joint.ends.size(); ++i)
            names += (i == 0                       ? ""
                      : i + 1 == joint.ends.size() ? " and "
                                                   : ", ") +
                     lines.entities[static_cast<std::size_t>(joint.ends[i].entity)].name;
        lines.repairs.push_back({"gap closed between " + names, joint.at, joint.gap, Repair::Kind::joined});
    }
}

SketchProblem crossing_lines(const std::vector<SketchPiece>& entities, const std::vector<int>& block, double coincidence) {
    const std::optional<CrossingPair> pair = first_crossing(entities, block, coincidence);
    const SketchPiece& first = entities[at(pair ? pair->entity : block.front())];
    const auto of_insertion = std::find_if(block.begin(), block.end(), [&](int e) { return entities[at(e)].insertion >= 0; });
    const std::string hint = of_insertion == block.end() ? "" : block_hint(entities[at(*of_insertion)]);
    return {"lines that share areas on layer " + first.layer + " cross each other, " +
                (pair ? first.name + " and " + entities[at(pair->other)].name : "near " + first.name),
            pair ? pair->at : point(first.curve, 0.5),
            first.name,
            first.line,
            "put each part on a layer of its own, or mend it in CAD" + hint,
            true};
}

}  // namespace

ClosedOutlines close_outlines(MendedLines lines, const SketchOptions& options) {
    ClosedOutlines found;
    const JoiningTolerances& near = lines.tolerances;
    found.tolerance = near.joining;
    found.coincidence = near.coincidence;
    report_joints(lines);
    if (options.recognise_arcs && recognise_facets(lines.entities, lines.joints, near.facets, near.written, lines.repairs))
        trace(lines);
    close_joints(lines.entities, lines.joints, near.rounding);

    OpenLines open = tell_open_lines(lines.entities, lines.chains, near.joining, options.leave_open);
    found.repairs = std::move(lines.repairs);
    found.problems = std::move(open.problems);
    found.warnings = std::move(open.warnings);
    found.open_length = open.length;
    found.loose = std::move(lines.chains.loose);
    found.outlines.closed = std::move(lines.chains.closed);
    for (const std::vector<int>& block : lines.chains.divided) {
        DividedOutline divided = walk_faces(lines.entities, lines.joints, block);
        if (is_plane(divided, lines.joints, block))
            found.outlines.divided.push_back(std::move(divided));
        else
            found.problems.push_back(crossing_lines(lines.entities, block, near.coincidence));
    }
    found.outlines.entities = std::move(lines.entities);
    put_back(found.outlines, lines);
    return found;
}

}  // namespace abut::geometry
