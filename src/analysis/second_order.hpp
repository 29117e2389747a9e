// SPDX-License-Identifier: GPL-3.0-or-later
// The answer once more, with forces balanced where parts have moved and bent to.
#pragma once
#include "src/analysis/outcome.hpp"
#include "src/results/result.hpp"

namespace abut {

/// Warns, with a reason against the answer, where displacements or contact forces change by more than they are to be known to
/// once forces are balanced where the answer has the parts.
void warn_of_second_order(const Scene& scene, const Outcome& out, int threads, Result& result);

}  // namespace abut
