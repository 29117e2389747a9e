// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts of preloads that are not square to the shank.
#pragma once
#include <string>
#include <vector>

#include "src/scene/scene.hpp"

namespace abut {

/// A sentence for every preload whose cut goes through parallel edges at more than a slip's angle: its force is that across the
/// cut, and along the shank it is another.
std::vector<std::string> inclined_cuts(const Scene& scene);

}  // namespace abut
