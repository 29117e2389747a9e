// SPDX-License-Identifier: GPL-3.0-or-later
// Slender parts under pressure: what answers of the undeformed shape leave out.
#pragma once
#include "src/analysis/outcome.hpp"
#include "src/results/result.hpp"

namespace abut {

/// Warns of parts whose mean stress along their length is beyond Euler's for a column of that length and thickness that is held
/// at one end only; where it is beyond that of one clamped at both ends, with a reason against the answer. What is bonded to
/// others along half of its length is no column. Likewise of thin rings whose mean stress around them is beyond that under
/// which a free ring buckles, and that nothing holds round.
void warn_of_buckling(const Scene& scene, const Outcome& out, Result& result);

}  // namespace abut
