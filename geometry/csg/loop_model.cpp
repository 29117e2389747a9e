// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/loop_model.hpp"

#include "geometry/brep/edge_tree.hpp"

namespace abut::geometry {

LoopModel loop_model(const Loops& loops) {
    LoopModel model;
    for (std::size_t l = 0; l < loops.loops.size(); ++l) {
        model.first.push_back(static_cast<int>(model.edges.size()));
        for (const LoopEdge& edge : loops.loops[l]) {
            model.edges.push_back(edge);
            model.list.push_back(static_cast<int>(l));
        }
    }
    model.first.push_back(static_cast<int>(model.edges.size()));
    return model;
}

void join_close_ends(LoopModel& model, const std::vector<bool>& is_left_out) {
    const std::size_t n_ends = 2 * model.edges.size();
    std::vector<Box2> dots(n_ends);
    for (std::size_t end = 0; end < n_ends; ++end) dots[end].extend(model.end_point(static_cast<int>(end)));
    const EdgeTree tree(dots);
    model.joined.assign(n_ends, {});
    for (std::size_t end = 0; end < n_ends; ++end) {
        if (is_left_out[end / 2]) continue;
        for (const int other : tree.near(dots[end], model.tolerance)) {
            const auto o = static_cast<std::size_t>(other);
            if (o == end || is_left_out[o / 2] || model.list[o / 2] != model.list[end / 2]) continue;
            if ((dots[o].min - dots[end].min).norm() <= model.tolerance) model.joined[end].push_back(other);
        }
    }
}

}  // namespace abut::geometry
