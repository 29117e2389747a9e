// SPDX-License-Identifier: GPL-3.0-or-later
// Selections by `facing` that take more than was meant, and by `near` that might take another edge.
#pragma once
#include <string>
#include <vector>

#include "src/scene/scene.hpp"

namespace abut {

/// Supports and loads on what faces a way that take whole edges, and besides edges of holes, or pieces of curved ones, that do
/// not adjoin these: the top of a hole faces down as the bottom of its plate does. And those near a place that several edges
/// are as near to: a corner. A sentence for each, which names them.
std::vector<std::string> stray_selections(const Scene& scene);

}  // namespace abut
