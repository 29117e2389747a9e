// SPDX-License-Identifier: GPL-3.0-or-later
// Where connected entities fall apart.
#pragma once
#include <vector>

#include "geometry/sketch/sketch_joints.hpp"

namespace abut::geometry {

/// The biconnected blocks of the graph of joints and entities that hangs together with the entity `first` [Tarjan 1972]: each
/// entity lies in one block, blocks have no more than one joint in common. A block of one entity with two joints is a bridge.
/// Entities ascend in each block. `is_seen` (by entity) is set for all of them. Cost linear; entities without ends are not to
/// be asked for.
std::vector<std::vector<int>> connected_blocks(const Joints& joints, int first, std::vector<bool>& is_seen);

}  // namespace abut::geometry
