// SPDX-License-Identifier: GPL-3.0-or-later
// The plan after the run: what each effect took, and the parts and contacts that it was about.
#pragma once
#include "src/analysis/outcome.hpp"
#include "src/results/result.hpp"

namespace abut {

/// Fills in what each effect took and what it was about, and which parts shared grids. Reads result.contacts and result.parts;
/// seconds: of the whole run.
void fill_effects(const Scene& scene, const Outcome& out, double seconds, Result& result);

}  // namespace abut
