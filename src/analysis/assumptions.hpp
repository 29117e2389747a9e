// SPDX-License-Identifier: GPL-3.0-or-later
// Where the answer does not bear out what was assumed: warnings.
#pragma once
#include "src/analysis/outcome.hpp"
#include "src/results/result.hpp"

namespace abut {

/// Warns where the answer does not bear out small displacements and strains, elasticity, bonds, rules that were to be of use,
/// grids as fine as wanted, the balance of forces, or the theory of nearly incompressible and of rigid parts.
void check_assumptions(const Scene& scene, const ResolvedConditions& conditions, const Outcome& out, Result& result);

/// Warns of rules for pairs that no candidate falls under; of an analysis that failed, too: they may be why.
void warn_of_unused_rules(const Scene& scene, const Outcome& out, Result& result);

}  // namespace abut
