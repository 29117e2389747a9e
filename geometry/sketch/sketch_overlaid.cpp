// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_overlaid.hpp"

#include <algorithm>
#include <cmath>

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

    bool is_on_chain(const EntityChain& chain, const Vec2& p) const {
        return std::any_of(chain.begin(), chain.end(), [&](const ChainLink& link) {
            const Curve& curve = entities[at(link.entity)].curve;
            return (point(curve, closest_parameter(curve, p)) - p).norm() <= tolerance;
        });
    }

    /// Parameters where the entity meets the chain; false where one of these places is no corner of the chain.
    bool meets_at_corners(const EntityChain& chain, const Curve& curve, std::vector<double>& cuts) const {
        for (const ChainLink& link : chain) {
            const Curve& side = entities[at(link.entity)].curve;
            if (!may_meet(curve, side, tolerance)) continue;
            for (const Vec2& p : meeting_points(curve, side, tolerance)) {
                if (std::min((point(side, 0) - p).norm(), (point(side, 1) - p).norm()) > 2 * tolerance) return false;
                cuts.push_back(closest_parameter(curve, p));
            }
        }
        return true;
    }

    bool runs_through(const EntityChain& chain, const std::vector<MonotonePiece>& inside, const Curve& curve) const {
        std::vector<double> cuts{0, 1};
        if (!meets_at_corners(chain, curve, cuts) || cuts.size() < 4) return false;
        std::sort(cuts.begin(), cuts.end());
        bool is_in = false, is_out = false;
        for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
            const Vec2 p = point(curve, 0.5 * (cuts[k] + cuts[k + 1]));
            if (!is_on_chain(chain, p)) (contains(inside, p) ? is_in : is_out) = true;
        }
        return is_in && is_out;
    }

    bool operator()(const EntityChain& chain) const {
        if (chain.size() < 3) return false;
        Part outline;
        Box2 box;
        for (const ChainLink& link : chain) {
            const Curve& curve = entities[at(link.entity)].curve;
            outline.edges.push_back({link.along ? curve : reversed(curve), {}, {}, true, 0.0});
            box.extend(bounding_box(curve));
        }
        if (area(outline) < 0) {
            std::reverse(outline.edges.begin(), outline.edges.end());
            for (Edge& edge : outline.edges) edge.curve = reversed(edge.curve);
        }
        const std::vector<MonotonePiece> inside = monotone_pieces(outline);
        for (const int e : tree.near(box, 0)) {
            const bool is_own =
                std::any_of(chain.begin(), chain.end(), [&](const ChainLink& link) { return link.entity == e; });
            if (!is_own && runs_through(chain, inside, entities[at(e)].curve)) return true;
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
    const Overlaid is_overlaid{entities, tree, tolerance};
    std::vector<bool> found;
    for (const EntityChain& chain : chains) found.push_back(is_overlaid(chain));
    return found;
}

}  // namespace abut::geometry
