// SPDX-License-Identifier: GPL-3.0-or-later
// One step of a scene's steps on one set of grids, in increments.
#pragma once
#include "src/analysis/adaptive.hpp"
#include "src/analysis/grid_walk.hpp"

namespace abut {

/// A step on prepared grids. Refers to all that it is given.
struct StepOnGrids {
    const Scene& scene;  ///< with all steps
    std::size_t step;
    const CaseProblem& problem;  ///< the step's own scene, its loads in full
    const GridWalk& walk;
    const SolvedAssembly& prepared;
    Stopwatches& seconds;
    int threads;
};

/// Solves a step from the end of the one before (nullptr: it is the first). Its loads grow evenly from those of the step
/// before; the increment is halved, up to four times, where more than a quarter of what is closed comes to slip otherwise than
/// before, or where the contact iterations do not converge. Where the step before has no answer neither has this one.
SolvedAssembly solve_step(const StepOnGrids& step, const SolvedAssembly* before);

}  // namespace abut
