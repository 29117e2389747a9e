// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that touch where no faces oppose each other: `contacts` lists them, the analysis has nothing to couple there.
#pragma once
#include "src/results/result.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// Adds one warning with all such places. Corners that meet corners are left out: nothing is pressed there.
void warn_of_unpaired_touches(const Scene& scene, Result& result);

}  // namespace abut
