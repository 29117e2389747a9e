// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "geometry/brep/edge_tree.hpp"
#include "geometry/brep/monotone.hpp"
#include "geometry/brep/oriented_tree.hpp"
#include "geometry/curves/curve_meetings.hpp"
#include "geometry/sketch/sketch_names.hpp"
#include "geometry/sketch/sketch_winding.hpp"

namespace abut::geometry {

namespace {

double distance(const Curve& curve, const Vec2& p) {
    return (point(curve, closest_parameter(curve, p)) - p).norm();
}

/// All chains as one part: its edges in the chains' order, each chain a range of them.
struct Layout {
    Part all;
    std::vector<int> chain, entity;  ///< by edge
    std::vector<int> first;          ///< edge by chain, and the number of edges at last
    std::vector<double> size;        ///< diagonal by chain
};

Layout lay_out(const std::vector<SketchPiece>& entities, const std::vector<EntityChain>& chains) {
    Layout layout;
    for (std::size_t c = 0; c < chains.size(); ++c) {
        layout.first.push_back(static_cast<int>(layout.all.edges.size()));
        Box2 box;
        for (const ChainLink& link : chains[c]) {
            const SketchPiece& entity = entities[static_cast<std::size_t>(link.entity)];
            layout.all.edges.push_back(
                {link.along ? entity.curve : reversed(entity.curve), entity.name, entity.name, link.along, 0.0});
            layout.chain.push_back(static_cast<int>(c));
            layout.entity.push_back(link.entity);
            box.extend(bounding_box(entity.curve));
        }
        layout.size.push_back(box.diagonal());
    }
    layout.first.push_back(static_cast<int>(layout.all.edges.size()));
    return layout;
}

/// Of the smaller of two outlines they may overlap by this fraction at most and only touch: the tolerance of what is joined
/// nearby, some large thing of other blocks perhaps, says little about small ones.
constexpr double overlap_fraction = 0.01;

double tolerance_between(const Layout& layout, int chain, int other, double tolerance) {
    const auto c = static_cast<std::size_t>(chain), o = static_cast<std::size_t>(other);
    return std::min(tolerance, overlap_fraction * std::min(layout.size[c], layout.size[o]));
}

/// What the chain bounds, run counter-clockwise.
Part part_inside(const Layout& layout, int chain) {
    const auto c = static_cast<std::size_t>(chain);
    Part region;
    region.edges.assign(layout.all.edges.begin() + layout.first[c], layout.all.edges.begin() + layout.first[c + 1]);
    if (area(region) > 0) return region;
    std::reverse(region.edges.begin(), region.edges.end());
    for (Edge& edge : region.edges) edge.curve = reversed(edge.curve);
    return region;
}

/// Is p where the two curves are joined, or do they run together from a joint of theirs to p (the tip of a narrow wedge)?
bool is_joint(const Curve& a, const Curve& b, const Vec2& p, double tolerance) {
    for (double end : {0.0, 1.0}) {
        const Vec2 joint = point(a, end);
        if ((joint - point(b, 0)).norm() > tolerance && (joint - point(b, 1)).norm() > tolerance) continue;
        const double halfway = 0.5 * (closest_parameter(a, p) + end);
        if ((joint - p).norm() <= 2 * tolerance || distance(b, point(a, halfway)) <= tolerance) return true;
    }
    return false;
}

struct Meeting {
    int edge, other_edge;
    Vec2 at;
};

/// Where a chain meets another, its pieces between the meetings lie on one side each: they cross if both sides occur.
bool do_cross(const Layout& layout, int chain, int other, const std::vector<Meeting>& meetings, double tolerance) {
    const Part region = part_inside(layout, other);
    const std::vector<MonotonePiece> pieces = monotone_pieces(region);
    bool is_in = false, is_out = false;
    for (int e = layout.first[static_cast<std::size_t>(chain)]; e < layout.first[static_cast<std::size_t>(chain) + 1]; ++e) {
        const Curve& curve = layout.all.edges[static_cast<std::size_t>(e)].curve;
        std::vector<double> cuts{0, 1};
        for (const Meeting& meeting : meetings)
            if (meeting.edge == e) cuts.push_back(closest_parameter(curve, meeting.at));
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            const Vec2 p = point(curve, 0.5 * (cuts[i] + cuts[i + 1]));
            const bool is_clear = std::none_of(region.edges.begin(), region.edges.end(),
                                               [&](const Edge& edge) { return distance(edge.curve, p) <= tolerance; });
            if (is_clear) (contains(pieces, p) ? is_in : is_out) = true;
        }
    }
    return is_in && is_out;
}

/// Distances from a point to a segment or an arc's whole circle: the nearest and the farthest.
struct Range {
    double nearest, farthest;
};

Range distances(const Segment& segment, const Vec2& p) {
    return {distance(segment, p), std::max((segment.from - p).norm(), (segment.to - p).norm())};
}

bool is_on_one_side(const Segment& line, const Segment& other, double tolerance) {
    const Vec2 n = left_of(line.to - line.from).normalized();
    const double a = (other.from - line.from).dot(n), b = (other.to - line.from).dot(n);
    return (a > tolerance && b > tolerance) || (a < -tolerance && b < -tolerance);
}

using ChainPair = std::pair<int, int>;  ///< the earlier one first
using EdgePairs = std::map<ChainPair, std::vector<std::pair<int, int>>>;

/// Edges that may meet, by their chains.
EdgePairs near_edges(const Layout& layout, double tolerance) {
    const OrientedTree tree(layout.all);
    EdgePairs found;
    for (std::size_t i = 0; i < layout.all.edges.size(); ++i) {
        const Curve& a = layout.all.edges[i].curve;
        for (const int k : tree.near_after(i, tolerance)) {
            const int chain = layout.chain[i], other = layout.chain[static_cast<std::size_t>(k)];
            if (may_meet(a, layout.all.edges[static_cast<std::size_t>(k)].curve,
                         tolerance_between(layout, chain, other, tolerance)))
                found[{chain, other}].emplace_back(static_cast<int>(i), k);
        }
    }
    return found;
}

/// Of a chain with itself where its edges meet elsewhere than at their joints.
std::vector<Meeting> find_meetings(const Layout& layout, const ChainPair& chains, const std::vector<std::pair<int, int>>& edges,
                                   double within) {
    std::vector<Meeting> found;
    for (const auto& [i, k] : edges) {
        const Curve &a = layout.all.edges[static_cast<std::size_t>(i)].curve,
                    &b = layout.all.edges[static_cast<std::size_t>(k)].curve;
        for (const Vec2& p : meeting_points(a, b, within))
            if (chains.first != chains.second || !is_joint(a, b, p, within)) found.push_back({i, k, p});
    }
    return found;
}

/// Has the chain a corner wherever it meets the other? A chain of one closed curve has none.
bool are_corners(const Layout& layout, int chain, const std::vector<Meeting>& meetings, double tolerance) {
    const int first = layout.first[static_cast<std::size_t>(chain)], last = layout.first[static_cast<std::size_t>(chain) + 1];
    return last - first > 1 && std::all_of(meetings.begin(), meetings.end(), [&](const Meeting& meeting) {
               for (int e = first; e < last; ++e)
                   if ((point(layout.all.edges[static_cast<std::size_t>(e)].curve, 0) - meeting.at).norm() <= tolerance)
                       return true;
               return false;
           });
}

/// Edges of the chain that begin in its two joints that lie closest together.
std::pair<int, int> nearest_joints(const Layout& layout, int chain, double tolerance) {
    const int first = layout.first[static_cast<std::size_t>(chain)], last = layout.first[static_cast<std::size_t>(chain) + 1];
    std::vector<Box2> joints;
    for (int e = first; e < last; ++e) {
        joints.emplace_back();
        joints.back().extend(point(layout.all.edges[static_cast<std::size_t>(e)].curve, 0));
    }
    const EdgeTree tree(joints);
    std::pair<int, int> best{first, first};
    for (double reach = tolerance, smallest = std::numeric_limits<double>::infinity(); joints.size() > 1 && smallest > reach;
         reach *= 2)
        for (std::size_t i = 0; i < joints.size(); ++i)
            for (const int k : tree.near(joints[i], reach)) {
                const double distance = (joints[static_cast<std::size_t>(k)].min - joints[i].min).norm();
                if (k <= static_cast<int>(i) || distance >= smallest) continue;
                smallest = distance;
                best = {first + static_cast<int>(i), first + k};
            }
    return best;
}

SketchProblem crossing(const SketchPiece& a, const SketchPiece& b, const Vec2& at, bool is_same_chain) {
    const std::string names = a.name + ", " + b.name;
    const std::string where = a.layer == b.layer ? " on layer " + a.layer : " on layers " + a.layer + " and " + b.layer;
    const std::string what =
        is_same_chain ? "an outline" + where + " crosses or touches itself: " : "two outlines" + where + " cross: ";
    return {what + names, at, names, std::min(a.line, b.line),
            (is_same_chain ? "mend it in CAD"
                           : "put each part on a layer of its own (parts above each other get a \"level\" each in the scene), "
                             "or mend it in CAD") +
                block_hint(a.insertion >= 0 ? a : b)};
}

}  // namespace

bool may_meet(const Curve& a, const Curve& b, double tolerance) {
    const auto *line_a = std::get_if<Segment>(&a), *line_b = std::get_if<Segment>(&b);
    const auto *arc_a = std::get_if<Arc>(&a), *arc_b = std::get_if<Arc>(&b);
    if (line_a && line_b) return !is_on_one_side(*line_a, *line_b, tolerance) && !is_on_one_side(*line_b, *line_a, tolerance);
    if (arc_a && arc_b) {
        const double d = (arc_a->center - arc_b->center).norm();
        return d <= arc_a->radius + arc_b->radius + tolerance && d >= std::abs(arc_a->radius - arc_b->radius) - tolerance;
    }
    if ((!line_a && !line_b) || (!arc_a && !arc_b)) return true;
    const Arc& arc = arc_a ? *arc_a : *arc_b;
    const Range range = distances(line_a ? *line_a : *line_b, arc.center);
    return range.nearest <= arc.radius + tolerance && range.farthest >= arc.radius - tolerance;
}

std::vector<Crossing> find_crossings(const std::vector<SketchPiece>& entities, const std::vector<EntityChain>& chains,
                                     double tolerance) {
    const Layout layout = lay_out(entities, chains);
    const auto entity_of = [&](int edge) -> const SketchPiece& {
        return entities[static_cast<std::size_t>(layout.entity[static_cast<std::size_t>(edge)])];
    };
    std::vector<Crossing> crossings;
    std::vector<bool> is_crossing_itself(chains.size(), false);
    for (const auto& [pair, edges] : near_edges(layout, tolerance)) {
        if (crossings.size() == most_crossings) return crossings;
        const auto [chain, other] = pair;
        const double within = tolerance_between(layout, chain, other, tolerance);
        const std::vector<Meeting> meetings = find_meetings(layout, pair, edges, within);
        if (meetings.empty() || (chain != other && !do_cross(layout, chain, other, meetings, within))) continue;
        const Meeting& first = meetings.front();
        crossings.push_back(
            {chain, other, crossing(entity_of(first.edge), entity_of(first.other_edge), first.at, chain == other),
             are_corners(layout, chain, meetings, 2 * within), are_corners(layout, other, meetings, 2 * within)});
        if (chain == other) is_crossing_itself[static_cast<std::size_t>(chain)] = true;
    }
    for (std::size_t c = 0; c < chains.size(); ++c) {
        const auto first = layout.all.edges.begin() + layout.first[c], last = layout.all.edges.begin() + layout.first[c + 1];
        const std::optional<int> turns = turning_number({first, last});
        if (is_crossing_itself[c] || !turns || std::abs(*turns) == 1) continue;
        const auto [a, b] = nearest_joints(layout, static_cast<int>(c), tolerance);
        const int chain = static_cast<int>(c);
        crossings.push_back(
            {chain, chain,
             crossing(entity_of(a), entity_of(b), point(layout.all.edges[static_cast<std::size_t>(a)].curve, 0), true)});
    }
    return crossings;
}

}  // namespace abut::geometry
