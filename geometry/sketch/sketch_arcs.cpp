// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_arcs.hpp"

#include <algorithm>

#include "geometry/brep/message_text.hpp"
#include "geometry/sketch/arc_fit.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

std::string description(const Curve& curve) {
    const auto* arc = std::get_if<Arc>(&curve);
    if (!arc) return "a line";
    return std::string(is_full_turn(curve) ? "a circle" : "an arc") + " of radius " + number_text(arc->radius);
}

// ---- chains of segments ----

/// Segments joined two by two, as far as they go.
struct FacetRun {
    std::vector<int> entities;
    std::vector<bool> along;
    bool is_closed = false;
};

struct FacetChains {
    const std::vector<SketchPiece>& entities;
    const Joints& joints;

    bool is_segment(int e) const { return std::holds_alternative<Segment>(entities[at(e)].curve); }
    const Joint& joint(const EntityEnd& end) const {
        return joints.joints[at((end.is_begin ? joints.at_begin : joints.at_end)[at(end.entity)])];
    }
    /// The segment's end that continues this one; entity -1 if none does.
    EntityEnd partner(const EntityEnd& end) const {
        const auto& ends = joint(end).ends;
        if (ends.size() != 2) return {-1, true};
        const bool is_first = ends[0].entity == end.entity && ends[0].is_begin == end.is_begin;
        const EntityEnd other = ends[is_first ? 1 : 0];
        return is_segment(other.entity) ? other : EntityEnd{-1, true};
    }

    /// All that hangs together with the segment, begun at its end that comes first.
    FacetRun run_through(int first) const {
        EntityEnd head{first, true};
        for (EntityEnd before = partner(head); before.entity >= 0; before = partner(head)) {
            if (before.entity == first) break;
            head = {before.entity, !before.is_begin};
        }
        const bool is_closed = partner(head).entity == first;
        EntityEnd at = is_closed ? EntityEnd{first, true} : head;
        FacetRun run;
        run.is_closed = is_closed;
        while (at.entity >= 0) {
            run.entities.push_back(at.entity);
            run.along.push_back(at.is_begin);
            at = partner({at.entity, !at.is_begin});
            if (at.entity == run.entities.front()) break;
        }
        return run;
    }

    std::vector<Vec2> points(const FacetRun& run) const {
        std::vector<Vec2> found;
        for (std::size_t k = 0; k < run.entities.size(); ++k) found.push_back(joint({run.entities[k], run.along[k]}).at);
        if (!run.is_closed) found.push_back(joint({run.entities.back(), !run.along.back()}).at);
        return found;
    }
};

// ---- arcs in place of facets ----

struct Replacement {
    int first = -1;  ///< the entity that becomes the arc
    Curve curve;
    int n_facets = 0;
    std::string names;
    double residual = 0;
};

/// Of the facets the one that comes first in the file stands for all; the arc runs its way.
Replacement replacement(const std::vector<SketchPiece>& entities, const FacetRun& run, const FittedPiece& piece,
                        std::size_t n_facets) {
    Replacement found;
    const std::size_t n = run.entities.size();
    std::size_t first_at = at(piece.first) % n;
    for (std::size_t k = 0; k < n_facets; ++k) {
        const std::size_t here = (at(piece.first) + k) % n;
        if (run.entities[here] < run.entities[first_at]) first_at = here;
    }
    found.first = run.entities[first_at];
    found.curve = run.along[first_at] ? piece.curve : reversed(piece.curve);
    found.n_facets = static_cast<int>(n_facets);
    const std::size_t last_at = (at(piece.first) + n_facets - 1) % n;
    found.names = entities[at(run.entities[at(piece.first) % n])].name + "..." + entities[at(run.entities[last_at])].name;
    found.residual = piece.residual;
    return found;
}

/// Notes the arcs of one run and which of its entities they replace.
void find_arcs(const FacetChains& chains, const FacetRun& run, double tolerance, double written, std::vector<Replacement>& arcs,
               std::vector<bool>& is_replaced) {
    if (run.entities.size() < static_cast<std::size_t>(least_facets)) return;
    const std::size_t n = run.entities.size();
    for (const FittedPiece& piece : fit_lines_and_arcs(chains.points(run), run.is_closed, tolerance, written)) {
        if (!std::holds_alternative<Arc>(piece.curve)) continue;
        const std::size_t begin = at(piece.first), end = at(piece.last);
        const std::size_t n_facets = end > begin ? end - begin : end + n - begin;  // all the way around: n
        arcs.push_back(replacement(chains.entities, run, piece, n_facets));
        for (std::size_t k = 0; k < n_facets; ++k) is_replaced[at(run.entities[(begin + k) % n])] = true;
    }
}

}  // namespace

void recognise_curves(std::vector<SketchPiece>& entities, std::vector<Repair>& repairs) {
    for (SketchPiece& entity : entities) {
        if (std::holds_alternative<Segment>(entity.curve) || std::holds_alternative<Arc>(entity.curve)) continue;
        const double tolerance = arc_likeness * bounding_box(entity.curve).diagonal();
        const std::optional<Curve> simple = as_line_or_arc(entity.curve, tolerance);
        if (!simple) continue;
        repairs.push_back(
            {entity.kind + " " + entity.name + " recognised as " + description(*simple), point(*simple, 0.5), tolerance});
        entity.curve = *simple;
    }
}

bool recognise_facets(std::vector<SketchPiece>& entities, const Joints& joints, double tolerance, double written,
                      std::vector<Repair>& repairs) {
    const FacetChains chains{entities, joints};
    std::vector<bool> is_seen(entities.size(), false), is_replaced(entities.size(), false);
    std::vector<Replacement> arcs;
    for (std::size_t i = 0; i < entities.size(); ++i) {
        const int e = static_cast<int>(i);
        if (is_seen[i] || !chains.is_segment(e)) continue;
        const FacetRun run = chains.run_through(e);
        for (const int other : run.entities) is_seen[at(other)] = true;
        find_arcs(chains, run, tolerance, written, arcs, is_replaced);
    }
    for (const Replacement& arc : arcs) {
        is_replaced[at(arc.first)] = false;
        entities[at(arc.first)].curve = arc.curve;
        repairs.push_back({std::to_string(arc.n_facets) + " lines recognised as " + description(arc.curve) + ", " + arc.names,
                           point(arc.curve, 0.5), arc.residual});
    }
    std::size_t i = 0;
    std::erase_if(entities, [&](const SketchPiece&) { return is_replaced[i++]; });
    return !arcs.empty();
}

}  // namespace abut::geometry
