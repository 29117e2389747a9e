// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/analysis/analyze_options.hpp"
#include "src/results/case_result.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// Analyses a scene. Throws InputError for what only shows here (a selection that matches nothing, drawn overlaps, a grid that
/// misses its part); a numerical outcome (mechanism, no convergence) is a Result with status "failed".
Result analyze(const Scene& scene, const AnalyzeOptions& options);

/// Analyses all load cases of a scene, on common grids and factors, in their order. Throws as analyze() does, which refuses
/// scenes with cases. Times are of all cases together, up to the case they stand in.
std::vector<CaseResult> analyze_cases(const Scene& scene, const AnalyzeOptions& options);

}  // namespace abut
