// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that tip on cells too large to tell where their contact ends.
#pragma once
#include "src/discretization/grid_design.hpp"
#include "src/scene/scene.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// A contact's resultant comes no nearer to an end of its zone than the pressure's last spline has its middle, a part of a cell
/// away; a part that rests nearer to its corner than that tips about a place beside it. Adds smaller cells to `wanted` at such
/// ends of the zones of a solution that is a mechanism; false: it turns about no such place.
bool add_tipping_ends(const Scene& scene, const std::vector<Candidate>& candidates, const SolvedAssembly& now,
                      WantedSizes& wanted);

}  // namespace abut
