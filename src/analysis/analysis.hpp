// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <string>

#include "src/results/result.hpp"
#include "src/scene/scene.hpp"

namespace abut {

struct AnalyzeOptions {
    std::function<void(const std::string&)> progress{};  ///< told what is being done; may be empty
    /// At most so many; 0: one for each processor. The answer is the same for any number.
    int threads = 0;
};

/// Scene to answer. Throws InputError for what only shows here (a selection that matches nothing, drawn overlaps, a grid that
/// misses its part); a numerical outcome (mechanism, no convergence) is a Result with status "failed".
Result analyze(const Scene& scene, const AnalyzeOptions& options);

}  // namespace abut
