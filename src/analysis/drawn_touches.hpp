// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that touch as drawn in a way that the analysis does not take literally.
#pragma once
#include <string>

#include "src/results/result.hpp"
#include "src/scene/scene.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// The places where parts touch and no faces oppose each other, in words; empty: there are none.
std::string unpaired_touches(const Scene& scene);

/// Adds one warning with all places where parts touch and no faces oppose each other, since there is nothing to couple
/// (`contacts` lists them; corners that meet corners are left out: nothing is pressed there), and one with all overlaps that
/// count as touching. Where the answer has such parts go into each other that speaks against it.
void warn_of_drawn_touches(const Scene& scene, const SolvedAssembly& solved, Result& result);

}  // namespace abut
