// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_overlaid.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "geometry/brep/edge_tree.hpp"
#include "geometry/brep/monotone.hpp"
#include "geometry/curves/curve_meetings.hpp"
#include "geometry/sketch/sketch_crossings.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

struct Overlaid {
    const std::vector<SketchPiece>& entities;
    const EdgeTree& tree;
    double tolerance;
    std::vector<char> is_own = std::vector<char>(entities.size());  ///< of the chain that is looked at

    bool is_on_chain(const Vec2& p) const {
        Box2 here;
        here.extend(p);
        const std::vector<int> near = tree.near(here, tolerance);
        return std::any_of(near.begin(), near.end(), [&](int e) {
            const Curve& curve = entities[at(e)].curve;
            return is_own[at(e)] && (point(curve, closest_parameter(curve, p)) - p).norm() <= tolerance;
        });
    }

    /// Others that come near the chain's sides, with these.
    std::map<int, std::vector<int>> near_others(const std::set<int>& own) const {
        std::map<int, std::vector<int>> found;
        if (own.size() == entities.size()) return found;
        for (const int side : own)
            for (const int e : tree.near(bounding_box(entities[at(side)].curve), tolerance))
                if (!is_own[at(e)] && may_meet(entities[at(e)].curve, entities[at(side)].curve, tolerance))
                    found[e].push_back(side);
        return found;
    }

    /// Parameters where the curve meets the sides, in order; none where one of these places is no corner.
    std::vector<double> cuts_at_corners(const Curve& curve, const std::vector<int>& sides) const {
        std::vector<double> cuts;
        for (const int e : sides) {
            const Curve& side = entities[at(e)].curve;
            for (const Vec2& p : meeting_points(curve, side, tolerance)) {
                if (std::min((point(side, 0) - p).norm(), (point(side, 1) - p).norm()) > 2 * tolerance) return {};
                cuts.push_back(closest_parameter(curve, p));
            }
        }
        std::sort(cuts.begin(), cuts.end());
        return cuts;
    }

    bool runs_through(const std::vector<MonotonePiece>& inside, const Curve& curve, std::vector<double> cuts) const {
        cuts.insert(cuts.begin(), 0);
        cuts.push_back(1);
        bool is_in = false, is_out = false;
        for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
            const Vec2 p = point(curve, 0.5 * (cuts[k] + cuts[k + 1]));
            if (!is_on_chain(p)) (contains(inside, p) ? is_in : is_out) = true;
        }
        return is_in && is_out;
    }

    std::vector<MonotonePiece> inside_of(const EntityChain& chain) const {
        Part outline;
        for (const ChainLink& link : chain) {
            const Curve& curve = entities[at(link.entity)].curve;
            outline.edges.push_back({link.along ? curve : reversed(curve), {}, {}, true, 0.0});
        }
        if (area(outline) < 0) {
            std::reverse(outline.edges.begin(), outline.edges.end());
            for (Edge& edge : outline.edges) edge.curve = reversed(edge.curve);
        }
        return monotone_pieces(outline);
    }

    bool operator()(const EntityChain& chain) {
        if (chain.size() < 3) return false;
        std::set<int> own;
        for (const ChainLink& link : chain) own.insert(link.entity);
        for (const int e : own) is_own[at(e)] = true;
        const bool found = is_overlaid(chain, own);
        for (const int e : own) is_own[at(e)] = false;
        return found;
    }

    bool is_overlaid(const EntityChain& chain, const std::set<int>& own) const {
        std::vector<MonotonePiece> inside;
        for (const auto& [e, sides] : near_others(own)) {
            std::vector<double> cuts = cuts_at_corners(entities[at(e)].curve, sides);
            if (cuts.size() < 2) continue;
            if (inside.empty()) inside = inside_of(chain);
            if (runs_through(inside, entities[at(e)].curve, std::move(cuts))) return true;
        }
        return false;
    }
};

}  // namespace

std::vector<bool> overlaid_chains(const std::vector<SketchPiece>& entities, const std::vector<EntityChain>& chains,
                                  double tolerance) {
    std::vector<Box2> boxes;
    for (const SketchPiece& entity : entities) boxes.push_back(bounding_box(entity.curve));
    const EdgeTree tree(boxes);
    Overlaid is_overlaid{entities, tree, tolerance};
    std::vector<bool> found;
    for (const EntityChain& chain : chains) found.push_back(is_overlaid(chain));
    return found;
}

}  // namespace abut::geometry
