// SPDX-License-Identifier: GPL-3.0-or-later
// Preloads across lines that are not square to what is tightened.
#pragma once
#include "src/results/result.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// Warns where the force of a preload, which is that along the normal of its cut, is notably less than what the part presses
/// with along itself: by more than the accuracy asked for. Looked at is the direction of the part's sides where the cut meets
/// them.
void warn_of_slanted_cuts(const Scene& scene, Result& result);

}  // namespace abut
