// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_splits.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "geometry/brep/edge_tree.hpp"
#include "geometry/curves/curve_meetings.hpp"
#include "geometry/sketch/sketch_crossings.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

/// Where on an entity, and the end there that a line whose coordinates are rounded as well was meant to go through.
struct CutPlace {
    double t;
    Vec2 through;
};
using Cuts = std::map<std::size_t, std::vector<CutPlace>>;  ///< by entity

int joint_of(const Joints& joints, const EntityEnd& end) {
    return (end.is_begin ? joints.at_begin : joints.at_end)[static_cast<std::size_t>(end.entity)];
}

/// Where the point lies on the entity, away from its ends.
std::optional<double> place_inside(const SketchPiece& entity, const Vec2& p, double reach, double coincidence) {
    const bool is_turn = is_full_turn(entity.curve);
    const auto is_near = [&](const Vec2& q, double distance) { return (q - p).norm() <= distance; };
    if (!is_turn && (is_near(point(entity.curve, 0), coincidence) || is_near(point(entity.curve, 1), coincidence)))
        return std::nullopt;
    const double t = closest_parameter(entity.curve, p);
    if (!is_near(point(entity.curve, t), reach) || (!is_turn && (t <= 0 || t >= 1))) return std::nullopt;
    return t;
}

/// Does the entity run along the other, off it: on the other side of a clearance?
bool runs_beside(const SketchPiece& entity, bool is_begin, const SketchPiece& other, double t, double coincidence) {
    const Vec2 p = point(entity.curve, is_begin ? 0 : 1);
    return (point(other.curve, t) - p).norm() > coincidence &&
           std::abs(leaving_direction(entity, is_begin).dot(unit_tangent(other.curve, t))) > side_by_side_cosine;
}

/// Notes the cut unless it repeats one.
bool note(Cuts& cuts, const SketchPiece& entity, std::size_t index, double t, const Vec2& through, double coincidence) {
    std::vector<CutPlace>& known = cuts[index];
    const Vec2 p = point(entity.curve, t);
    for (const CutPlace& other : known)
        if ((point(entity.curve, other.t) - p).norm() <= coincidence) return false;
    known.push_back({t, through});
    return true;
}

/// Entities that are asked for, by their boxes.
struct AskedEntities {
    std::vector<std::size_t> entity;
    EdgeTree tree;
};

AskedEntities asked_entities(const std::vector<SketchPiece>& entities, const std::vector<bool>& is_asked) {
    std::vector<Box2> boxes;
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < entities.size(); ++i) {
        if (!is_asked[i]) continue;
        boxes.push_back(bounding_box(entities[i].curve));
        numbers.push_back(i);
    }
    return {std::move(numbers), EdgeTree(std::move(boxes))};
}

/// Of ends that lie exactly in one place only the first of the troubled, or else the first, is looked at.
std::vector<EntityEnd> different_ends(const std::vector<SketchPiece>& entities, const std::vector<bool>& troubled) {
    std::vector<EntityEnd> ends;
    std::set<std::pair<double, double>> known;
    for (const bool is_asked : {true, false})
        for (std::size_t i = 0; i < entities.size(); ++i) {
            if (troubled[i] != is_asked || is_full_turn(entities[i].curve)) continue;
            for (const bool is_begin : {true, false}) {
                const EntityEnd end{static_cast<int>(i), is_begin};
                const Vec2 p = position(entities, end);
                if (known.emplace(p.x(), p.y()).second) ends.push_back(end);
            }
        }
    return ends;
}

Cuts find_cuts(const std::vector<SketchPiece>& entities, const Joints& joints, const std::vector<bool>& troubled,
               double tolerance, double coincidence, std::vector<Repair>& repairs) {
    const AskedEntities all = asked_entities(entities, std::vector<bool>(entities.size(), true));
    const AskedEntities in_trouble = asked_entities(entities, troubled);
    Cuts cuts;
    const double most_slack = largest_slack(entities);
    for (const EntityEnd& end : different_ends(entities, troubled)) {
        const auto i = static_cast<std::size_t>(end.entity);
        const AskedEntities& asked = troubled[i] ? all : in_trouble;
        const Vec2 p = position(entities, end);
        const int joint = joint_of(joints, end);
        const bool is_alone = joints.joints[static_cast<std::size_t>(joint)].ends.size() == 1;
        const double reach = is_alone ? tolerance : coincidence;
        Box2 place;
        place.extend(p);
        for (const int near : asked.tree.near(place, std::max(reach, most_slack))) {
            const std::size_t j = asked.entity[static_cast<std::size_t>(near)];
            if (i == j || joints.at_begin[j] == joint || joints.at_end[j] == joint) continue;
            double one = std::max(coincidence, entities[j].slack);
            for (const EntityEnd& here : joints.joints[static_cast<std::size_t>(joint)].ends)
                one = std::min(one, reach_of_line(entities[j], entities[static_cast<std::size_t>(here.entity)], coincidence));
            const std::optional<double> t = place_inside(entities[j], p, std::max(reach, one), coincidence);
            if (!t || runs_beside(entities[i], end.is_begin, entities[j], *t, one) ||
                !note(cuts, entities[j], j, *t, p, coincidence))
                continue;
            const Vec2 at = point(entities[j].curve, *t);
            repairs.push_back({entities[j].kind + " " + entities[j].name + " cut where " + entities[i].name + " ends on it", at,
                               (at - p).norm()});
        }
    }
    return cuts;
}

/// From t0 on around the whole turn to t1 + 1.
Curve over_the_seam(const Curve& full_turn, double t0, double t1) {
    const auto continued = [&](auto arc) {
        arc.start += arc.sweep * t0;
        arc.sweep *= 1 - t0 + t1;
        return Curve(arc);
    };
    if (const auto* arc = std::get_if<Arc>(&full_turn)) return continued(*arc);
    return continued(std::get<EllipticArc>(full_turn));
}

std::vector<Curve> cut_full_turn(const Curve& curve, std::vector<double> cuts) {
    if (cuts.size() == 1) cuts.push_back(std::fmod(cuts.front() + 0.5, 1.0));  // a chain's pieces have two ends
    std::sort(cuts.begin(), cuts.end());
    std::vector<Curve> pieces;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) pieces.push_back(trimmed(curve, cuts[k], cuts[k + 1]));
    pieces.push_back(over_the_seam(curve, cuts.back(), cuts.front()));
    return pieces;
}

/// The pieces of a line whose coordinates are rounded go through the ends that were rounded beside it.
void pull_onto_ends(std::vector<CutPlace> cuts, std::vector<Curve>& pieces) {
    std::sort(cuts.begin(), cuts.end(), [](const CutPlace& a, const CutPlace& b) { return a.t < b.t; });
    for (std::size_t k = 0; k < cuts.size(); ++k) {
        std::get<Segment>(pieces[k]).to = cuts[k].through;
        std::get<Segment>(pieces[k + 1]).from = cuts[k].through;
    }
}

std::vector<Curve> cut_open(const Curve& curve, std::vector<double> cuts) {
    cuts.push_back(0);
    cuts.push_back(1);
    std::sort(cuts.begin(), cuts.end());
    std::vector<Curve> pieces;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) pieces.push_back(trimmed(curve, cuts[k], cuts[k + 1]));
    return pieces;
}

/// A piece that is cut again is numbered anew: h2F#1 gives h2F#1#0, h2F#1#1.
void add_pieces(std::vector<SketchPiece>& to, const SketchPiece& entity, const std::vector<CutPlace>& places) {
    const bool is_turn = is_full_turn(entity.curve);
    std::vector<double> cuts;
    for (const CutPlace& place : places) cuts.push_back(place.t);
    std::vector<Curve> curves = is_turn ? cut_full_turn(entity.curve, cuts) : cut_open(entity.curve, cuts);
    if (entity.slack > 0) pull_onto_ends(places, curves);
    double begin = entity.source_begin;
    if (is_turn) begin += length(entity.curve, 0, *std::min_element(cuts.begin(), cuts.end()));
    for (std::size_t k = 0; k < curves.size(); ++k) {
        SketchPiece piece = entity;
        piece.curve = curves[k];
        piece.name += "#" + std::to_string(k);
        piece.source_begin = begin;
        begin += length(curves[k]);
        to.push_back(std::move(piece));
    }
}

void cut(std::vector<SketchPiece>& entities, const Cuts& cuts) {
    std::vector<SketchPiece> pieces;
    for (std::size_t i = 0; i < entities.size(); ++i) {
        const auto found = cuts.find(i);
        if (found == cuts.end())
            pieces.push_back(std::move(entities[i]));
        else
            add_pieces(pieces, entities[i], found->second);
    }
    entities = std::move(pieces);
}

/// 0: along x, 1: along y, -1: neither.
int axis_of(const Curve& curve) {
    const auto* line = std::get_if<Segment>(&curve);
    if (!line) return -1;
    return line->from.y() == line->to.y() ? 0 : line->from.x() == line->to.x() ? 1 : -1;
}

/// Visits, of the given entities, each that another one crosses, touches or ends on, away from its own ends.
template <class Visit>
void for_all_crossings(const std::vector<SketchPiece>& entities, const std::vector<int>& among, CrossingLines which,
                       double coincidence, const Visit& visit) {
    std::vector<bool> is_asked(entities.size(), false);
    for (const int e : among) is_asked[at(e)] = which == CrossingLines::all || axis_of(entities[at(e)].curve) >= 0;
    const AskedEntities asked = asked_entities(entities, is_asked);
    for (const std::size_t i : asked.entity)
        for (const int near : asked.tree.near(bounding_box(entities[i].curve), coincidence)) {
            const std::size_t j = asked.entity[at(near)];
            const Curve &a = entities[i].curve, &b = entities[j].curve;
            if (j <= i || (which == CrossingLines::upright && axis_of(a) == axis_of(b)) || !may_meet(a, b, coincidence))
                continue;
            for (const Vec2& p : meeting_points(a, b, coincidence))
                for (const auto& [own, other] : {std::pair(i, j), std::pair(j, i)})
                    if (const std::optional<double> t = place_inside(entities[own], p, coincidence, coincidence))
                        visit(own, other, *t, p);
        }
}

}  // namespace

bool split_at_ends(std::vector<SketchPiece>& entities, const Joints& joints, const std::vector<bool>& troubled,
                   double tolerance, double coincidence, std::vector<Repair>& repairs) {
    if (std::find(troubled.begin(), troubled.end(), true) == troubled.end()) return false;
    const Cuts cuts = find_cuts(entities, joints, troubled, tolerance, coincidence, repairs);
    if (cuts.empty()) return false;
    cut(entities, cuts);
    return true;
}

bool split_at_crossings(std::vector<SketchPiece>& entities, const std::vector<int>& among, CrossingLines which,
                        double coincidence, std::vector<Repair>& repairs) {
    Cuts cuts;
    for_all_crossings(entities, among, which, coincidence, [&](std::size_t own, std::size_t other, double t, const Vec2& p) {
        if (note(cuts, entities[own], own, t, point(entities[own].curve, t), coincidence))
            repairs.push_back({entities[own].name + " cut where " + entities[other].name + " crosses it", p, 0});
    });
    if (cuts.empty()) return false;
    cut(entities, cuts);
    return true;
}

std::optional<CrossingPair> first_crossing(const std::vector<SketchPiece>& entities, const std::vector<int>& among,
                                           double coincidence) {
    std::optional<CrossingPair> first;
    for_all_crossings(entities, among, CrossingLines::all, coincidence,
                      [&](std::size_t own, std::size_t other, double, const Vec2& p) {
                          if (!first) first = {static_cast<int>(own), static_cast<int>(other), p};
                      });
    return first;
}

}  // namespace abut::geometry
