// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines that are drawn over others: a screw through the lines of two plates.
#pragma once
#include <vector>

#include "geometry/sketch/sketch_chains.hpp"

namespace abut::geometry {

/// Tells of each closed chain of uncut entities whether others run through it from corner to corner: some other entity lies in
/// such a chain with a piece of it, and outside with another, and meets it only where the chain has corners. So it was drawn to
/// fit what it lies on, which was drawn without it.
std::vector<bool> overlaid_chains(const std::vector<SketchPiece>& entities, const std::vector<EntityChain>& chains,
                                  double tolerance);

}  // namespace abut::geometry
