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

/// What the entities of a group are joined to.
struct EntityChains {
    std::vector<EntityChain> closed;        ///< in order of their first entities
    std::vector<std::vector<int>> divided;  ///< entities of outlines that share edges: they bound several areas (sketch_faces)
    std::vector<bool> is_loose;             ///< by entity: in none of `closed`
    std::vector<SketchProblem> problems;    ///< open ends and branchings, at most max_open_ends of the former
};
inline constexpr int max_open_ends = 20;  ///< problems listed per layer; a last one tells how many more there are

/// Chains the entities, from joint to joint. What is connected falls apart at joints where outlines only touch (the graph's
/// biconnected blocks); a block is a closed chain, or a divided outline. Of what is connected with an open end, or joined by an
/// entity that bounds nothing, none is taken: problems name the entities, the place, the gap to the nearest other open end, and
/// the file's line. Cost O(n).
EntityChains trace_chains(const std::vector<SketchPiece>& entities, const Joints& joints, double tolerance);

}  // namespace abut::geometry
