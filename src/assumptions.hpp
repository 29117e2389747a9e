// SPDX-License-Identifier: GPL-3.0-or-later
// Where the answer does not bear out what was assumed: warnings; and how far it still changes with the grid.
#pragma once
#include "src/adaptive.hpp"
#include "src/result.hpp"

namespace abut {

/// Estimates of the errors from the last two grids, with a warning for pressures that seem to have no limit.
void fill_errors(const Outcome& out, Result& result);

/// Small displacements and strains, rules that were of use, grids as fine as wanted, contacts that stayed where they are.
void check_assumptions(const Scene& scene, const Outcome& out, Result& result);

}  // namespace abut
