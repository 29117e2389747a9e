// SPDX-License-Identifier: GPL-3.0-or-later
// Depth-first search without recursion: chains of 1e5 entities are as deep as they are long.
#include "geometry/sketch/sketch_blocks.hpp"

#include <algorithm>
#include <unordered_map>

namespace abut::geometry {

namespace {

/// A joint on the way down, and the entity by which it was reached.
struct Step {
    int joint;
    int by_entity;
    std::size_t next_end = 0;
};

struct BlockSearch {
    const Joints& joints;
    std::vector<bool>& is_seen;
    std::unordered_map<int, int> order{}, low{};  ///< by joint: when it was reached; the earliest joint reached from below it
    std::vector<Step> path{};
    std::vector<int> open{};  ///< entities not yet in a block
    std::vector<std::vector<int>> blocks{};

    int far_joint(const EntityEnd& end) const {
        return (end.is_begin ? joints.at_end : joints.at_begin)[static_cast<std::size_t>(end.entity)];
    }

    void enter(int joint, int by_entity) {
        const int n = static_cast<int>(order.size());
        order[joint] = low[joint] = n;
        path.push_back({joint, by_entity});
    }

    /// All entities opened since `entity` are one block.
    void close_block(int entity) {
        std::vector<int> block;
        do {
            block.push_back(open.back());
            open.pop_back();
        } while (block.back() != entity);
        std::sort(block.begin(), block.end());
        blocks.push_back(std::move(block));
    }

    void follow(const EntityEnd& end, int from) {
        const auto e = static_cast<std::size_t>(end.entity);
        if (is_seen[e]) return;
        is_seen[e] = true;
        const int to = far_joint(end);
        if (to == from) {
            blocks.push_back({end.entity});  // it closes on itself
            return;
        }
        open.push_back(end.entity);
        if (!order.contains(to))
            enter(to, end.entity);
        else
            low[from] = std::min(low[from], order[to]);
    }

    void leave() {
        const Step done = path.back();
        path.pop_back();
        if (path.empty()) return;
        const int above = path.back().joint;
        low[above] = std::min(low[above], low[done.joint]);
        if (low[done.joint] >= order[above]) close_block(done.by_entity);
    }

    void run(int first) {
        enter(joints.at_begin[static_cast<std::size_t>(first)], -1);
        while (!path.empty()) {
            Step& here = path.back();
            const auto& ends = joints.joints[static_cast<std::size_t>(here.joint)].ends;
            if (here.next_end == ends.size()) {
                leave();
                continue;
            }
            const EntityEnd end = ends[here.next_end++];
            follow(end, here.joint);
        }
    }
};

}  // namespace

std::vector<std::vector<int>> connected_blocks(const Joints& joints, int first, std::vector<bool>& is_seen) {
    BlockSearch search{joints, is_seen};
    search.run(first);
    std::sort(search.blocks.begin(), search.blocks.end());
    return std::move(search.blocks);
}

}  // namespace abut::geometry
