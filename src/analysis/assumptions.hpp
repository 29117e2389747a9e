// SPDX-License-Identifier: GPL-3.0-or-later
// Where the answer does not bear out what was assumed: warnings.
#pragma once
#include "src/analysis/outcome.hpp"
#include "src/results/result.hpp"

namespace abut {

/// Small displacements and strains, rules that were of use, grids as fine as wanted.
void check_assumptions(const Scene& scene, const Outcome& out, Result& result);

}  // namespace abut
