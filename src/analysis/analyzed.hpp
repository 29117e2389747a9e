// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>

#include "src/analysis/analyze_options.hpp"
#include "src/analysis/outcome.hpp"
#include "src/motion/placement.hpp"
#include "src/results/result.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// An analysis with what its answer was computed from.
struct Analyzed {
    Result result;
    Outcome outcome;           ///< refers to the scene that was analysed, or to that of `rest`
    std::optional<Rest> rest;  ///< where parts came to rest far from where they were drawn
};

/// Analyses a scene as analyze() does, and keeps the last grids and factors.
Analyzed analyze_and_keep(const Scene& scene, const AnalyzeOptions& options);

}  // namespace abut
