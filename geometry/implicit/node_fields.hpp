// SPDX-License-Identifier: GPL-3.0-or-later
// The R-functions of a geometry tree node by node, and those of them that vanish on chosen edges of the part alone.
#pragma once
#include <vector>

#include "geometry/implicit/implicit.hpp"

namespace abut::geometry {

/// A node with its R-function. Places have none of their own: they move their child.
struct NodeField {
    ImplicitField field;         ///< legend of implicit.hpp
    std::vector<Curve> curves;   ///< of a leaf, where it is placed; of a half plane none
    std::vector<NodeField> of;   ///< of an operation
    bool is_taken_away = false;  ///< by the difference above it
};

/// The fields of all nodes; implicit_of() is the root's. Errors and cost as there.
NodeField node_fields(const CsgNode& tree, double alpha = 0);

/// Fields that vanish on edges of a part, and the edges that none of them holds.
struct HeldNodes {
    std::vector<ImplicitField> fields;  ///< positive in the part
    std::vector<int> rest;
};

/// The largest nodes of the tree that bound the part by some of these edges and by nothing else, and that vanish nowhere in it
/// (bodies that abut do): a window as a whole is held by the R-function of its rectangle, while the lines of its sides go on
/// through the part. `part` is what the tree evaluates to, at the same place. Looked at: `held_samples` points of every edge.
/// Cost O(nodes edges) at worst.
HeldNodes held_nodes(const CsgNode& tree, const Part& part, const std::vector<int>& edges);
inline constexpr int held_samples = 32;  ///< of circles against splines; one would do between lines

}  // namespace abut::geometry
