// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/analysis/analyze_options.hpp"
#include "src/results/result.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// Analyses a scene. Throws InputError for what only shows here (a selection that matches nothing, drawn overlaps, a grid that
/// misses its part); a numerical outcome (mechanism, no convergence) is a Result with status "failed".
Result analyze(const Scene& scene, const AnalyzeOptions& options);

}  // namespace abut
