// SPDX-License-Identifier: GPL-3.0-or-later
// Joined entities as closed chains, and what keeps the others from closing.
#pragma once
#include <vector>

#include "geometry/sketch/sketch_joints.hpp"

namespace abut::geometry {

/// An entity as a chain runs through it.
struct ChainLink {
    int entity;
    bool along;  ///< in the entity's own direction?
};
/// A closed chain of entities, head to tail, begun with the first of them in the file.
using EntityChain = std::vector<ChainLink>;

/// Entities that bound nothing and hang together.
struct LooseEntities {
    std::vector<int> entities;
    std::vector<Vec2> free_ends;  ///< where nothing continues them
    double length = 0;
};

/// What the entities of a group are joined to.
struct EntityChains {
    std::vector<EntityChain> closed;        ///< in order of their first entities
    std::vector<std::vector<int>> divided;  ///< entities of outlines that share edges: they bound several areas (sketch_faces)
    std::vector<bool> is_loose;             ///< by entity: in none of `closed`
    std::vector<LooseEntities> loose;       ///< in none of `closed` and `divided`, in order of their first entities
    std::vector<int> component;             ///< by entity: one number for all that hangs together
};

/// Chains the entities, from joint to joint. What is connected falls apart at joints where outlines only touch (the graph's
/// biconnected blocks); a block is a closed chain, a divided outline, or a single entity that bounds nothing. Cost O(n).
EntityChains trace_chains(const std::vector<SketchPiece>& entities, const Joints& joints);

}  // namespace abut::geometry
