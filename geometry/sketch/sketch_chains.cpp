// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_chains.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/sketch/sketch_blocks.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

struct Tracer {
    const std::vector<SketchPiece>& entities;
    const Joints& joints;
    std::vector<int> block_of{};

    const Joint& joint(int index) const { return joints.joints[at(index)]; }
    int joint_of(int entity, bool is_begin) const { return (is_begin ? joints.at_begin : joints.at_end)[at(entity)]; }

    /// The other ends of the block in the joint where this one lies.
    std::vector<EntityEnd> partners(const EntityEnd& end) const {
        const int block = block_of[at(end.entity)];
        std::vector<EntityEnd> found;
        for (const EntityEnd& other : joint(joint_of(end.entity, end.is_begin)).ends) {
            const bool is_same = other.entity == end.entity && other.is_begin == end.is_begin;
            if (!is_same && block_of[at(other.entity)] == block) found.push_back(other);
        }
        return found;
    }

    bool is_cycle(const std::vector<int>& block) const {
        return std::all_of(block.begin(), block.end(), [&](int e) {
            return partners({e, true}).size() == 1 && partners({e, false}).size() == 1;
        });
    }

    EntityChain walk(int first) const {
        EntityChain chain{{first, true}};
        for (EntityEnd next = partners({first, false}).front(); next.entity != first;
             next = partners({next.entity, !next.is_begin}).front())
            chain.push_back({next.entity, next.is_begin});
        return chain;
    }

    /// Does it bound nothing?
    bool is_bridge(const std::vector<int>& block) const {
        return block.size() == 1 && joint_of(block.front(), true) != joint_of(block.front(), false);
    }

    /// Bridges that hang together by joints of theirs.
    std::vector<LooseEntities> loose_entities(const std::vector<int>& bridges) const {
        std::map<int, std::vector<int>> at_joint;
        for (const int e : bridges)
            for (const bool is_begin : {true, false}) at_joint[joint_of(e, is_begin)].push_back(e);
        std::vector<LooseEntities> found;
        std::map<int, bool> is_seen;
        for (const int first : bridges) {
            if (is_seen[first]) continue;
            LooseEntities tree;
            std::vector<int> open{first};
            is_seen[first] = true;
            while (!open.empty()) {
                const int e = open.back();
                open.pop_back();
                tree.entities.push_back(e);
                tree.length += length(entities[at(e)].curve);
                for (const bool is_begin : {true, false}) {
                    const int here = joint_of(e, is_begin);
                    if (joint(here).ends.size() == 1) tree.free_ends.push_back(position(entities, {e, is_begin}));
                    for (const int other : at_joint[here])
                        if (!std::exchange(is_seen[other], true)) open.push_back(other);
                }
            }
            std::sort(tree.entities.begin(), tree.entities.end());
            found.push_back(std::move(tree));
        }
        return found;
    }

    void take(const std::vector<std::vector<int>>& blocks, EntityChains& chains) {
        std::vector<int> bridges;
        for (const auto& block : blocks)
            for (const int e : block) block_of[at(e)] = block.front();
        for (const auto& block : blocks) {
            for (const int e : block) chains.component[at(e)] = blocks.front().front();
            if (is_bridge(block))
                bridges.push_back(block.front());
            else if (is_cycle(block))
                chains.closed.push_back(walk(block.front()));
            else
                chains.divided.push_back(block);
        }
        std::sort(bridges.begin(), bridges.end());
        for (LooseEntities& tree : loose_entities(bridges)) chains.loose.push_back(std::move(tree));
    }

    void trace(EntityChains& chains) {
        std::vector<bool> is_seen(entities.size(), false);
        for (std::size_t i = 0; i < entities.size(); ++i) {
            const int first = static_cast<int>(i);
            if (is_seen[i]) continue;
            if (joints.at_begin[i] < 0) {
                chains.closed.push_back({{first, true}});
                chains.component[i] = first;
            } else {
                take(connected_blocks(joints, first, is_seen), chains);
            }
        }
    }
};

}  // namespace

EntityChains trace_chains(const std::vector<SketchPiece>& entities, const Joints& joints) {
    ENSURE(joints.at_begin.size() == entities.size() && joints.at_end.size() == entities.size(), "every entity has its joints");
    Tracer tracer{entities, joints};
    tracer.block_of.assign(entities.size(), -1);
    EntityChains chains;
    chains.component.assign(entities.size(), -1);
    tracer.trace(chains);
    std::sort(chains.closed.begin(), chains.closed.end(),
              [](const EntityChain& a, const EntityChain& b) { return a.front().entity < b.front().entity; });
    chains.is_loose.assign(entities.size(), true);
    for (const EntityChain& chain : chains.closed)
        for (const ChainLink& link : chain) chains.is_loose[at(link.entity)] = false;
    return chains;
}

}  // namespace abut::geometry
