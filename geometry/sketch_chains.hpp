// SPDX-License-Identifier: GPL-3.0-or-later
// Joined entities as closed chains, and what keeps the others from closing.
#pragma once
#include <vector>

#include "geometry/sketch_joints.hpp"

namespace abut::geometry {

struct ChainLink {
    int entity;
    bool along;  ///< in the entity's own direction?
};

struct Chains {
    std::vector<std::vector<ChainLink>> closed;  ///< head to tail, in order of their first entities, which they begin with
    std::vector<bool> is_loose;                  ///< by entity: in none of them
    std::vector<SketchProblem> problems;         ///< open ends and branchings, at most max_open_ends of the former
};
inline constexpr int max_open_ends = 20;  ///< problems listed per layer; a last one tells how many more there are

/// Walks from joint to joint. A group of connected entities gives a chain if exactly two ends meet at each of its joints.
/// Problems name the entities, the place, the gap to the nearest other open end, and the file's line.
Chains trace_chains(const std::vector<SketchEntity>& entities, const Joints& joints, double tolerance);

}  // namespace abut::geometry
