// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch_crossings.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/curve_meetings.hpp"
#include "geometry/edge_tree.hpp"
#include "geometry/monotone.hpp"

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
};

Layout lay_out(const std::vector<SketchEntity>& entities, const std::vector<std::vector<ChainLink>>& chains) {
    Layout layout;
    for (std::size_t c = 0; c < chains.size(); ++c) {
        layout.first.push_back(static_cast<int>(layout.all.edges.size()));
        for (const ChainLink& link : chains[c]) {
            const SketchEntity& entity = entities[static_cast<std::size_t>(link.entity)];
            layout.all.edges.push_back(
                {link.along ? entity.curve : reversed(entity.curve), entity.name, entity.name, link.along, 0.0});
            layout.chain.push_back(static_cast<int>(c));
            layout.entity.push_back(link.entity);
        }
    }
    layout.first.push_back(static_cast<int>(layout.all.edges.size()));
    return layout;
}

/// What the chain bounds, run counter-clockwise; the edges' order does not matter here.
Part region_of(const Layout& layout, int chain) {
    const auto c = static_cast<std::size_t>(chain);
    Part region;
    region.edges.assign(layout.all.edges.begin() + layout.first[c], layout.all.edges.begin() + layout.first[c + 1]);
    if (area(region) < 0)
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
    const Part region = region_of(layout, other);
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

/// By pair of chains, the earlier one first; of a chain with itself where its edges meet elsewhere than at their joints.
std::map<std::pair<int, int>, std::vector<Meeting>> find_meetings(const Layout& layout, double tolerance) {
    const EdgeTree tree(layout.all);
    std::map<std::pair<int, int>, std::vector<Meeting>> found;
    for (std::size_t i = 0; i < layout.all.edges.size(); ++i) {
        const Curve& a = layout.all.edges[i].curve;
        for (int k : tree.near(bounding_box(a), tolerance)) {
            if (k <= static_cast<int>(i)) continue;
            const Curve& b = layout.all.edges[static_cast<std::size_t>(k)].curve;
            const int chain = layout.chain[i], other = layout.chain[static_cast<std::size_t>(k)];
            for (const Vec2& p : meeting_points(a, b, tolerance))
                if (chain != other || !is_joint(a, b, p, tolerance))
                    found[{chain, other}].push_back({static_cast<int>(i), k, p});
        }
    }
    return found;
}

SketchProblem crossing(const SketchEntity& a, const SketchEntity& b, const Vec2& at, bool is_same_chain) {
    const std::string names = a.name + ", " + b.name;
    const std::string what = is_same_chain ? "an outline on layer " + a.layer + " crosses or touches itself: "
                                           : "two outlines on layer " + a.layer + " cross: ";
    return {what + names, at, names, std::min(a.line, b.line),
            is_same_chain ? "mend it in CAD" : "put each part on a layer of its own, or mend it in CAD"};
}

}  // namespace

std::vector<SketchProblem> remove_crossing(const std::vector<SketchEntity>& entities,
                                           std::vector<std::vector<ChainLink>>& chains, double tolerance) {
    const Layout layout = lay_out(entities, chains);
    const auto entity_of = [&](int edge) -> const SketchEntity& {
        return entities[static_cast<std::size_t>(layout.entity[static_cast<std::size_t>(edge)])];
    };
    std::vector<SketchProblem> problems;
    std::vector<bool> is_bad(chains.size(), false);
    for (const auto& [pair, meetings] : find_meetings(layout, tolerance)) {
        const auto [chain, other] = pair;
        if (chain != other && !do_cross(layout, chain, other, meetings, tolerance)) continue;
        is_bad[static_cast<std::size_t>(chain)] = is_bad[static_cast<std::size_t>(other)] = true;
        const Meeting& first = meetings.front();
        problems.push_back(crossing(entity_of(first.edge), entity_of(first.other_edge), first.at, chain == other));
    }
    std::size_t c = 0;
    std::erase_if(chains, [&](const auto&) { return is_bad[c++]; });
    return problems;
}

}  // namespace abut::geometry
