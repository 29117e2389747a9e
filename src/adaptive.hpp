// SPDX-License-Identifier: GPL-3.0-or-later
// Solves a scene on grids that follow its contacts.
#pragma once
#include <vector>

#include "src/analysis.hpp"
#include "src/assembly_model.hpp"

namespace abut {

struct Outcome {
    std::vector<Candidate> candidates;
    SolvedAssembly solved;  ///< on the last grids
    int passes = 0, factorizations = 0, iterations = 0;
    bool settled = true;                ///< the contacts moved little from the grids before to the last ones
    bool search_too_short = false;      ///< contact reaches the end of what was searched
    bool have_previous = false;         ///< there were grids before the last ones:
    std::vector<double> previous_peak;  ///< largest pressures on them, by candidate
    double previous_energy = 0;         ///< and their strain energy
};

/// Grids, solution, new grids from the contacts found, until these stay where they are or the accuracy level's number of passes
/// is reached; the search for candidates widens where contact reaches its end, or where the displacements could close more.
Outcome solve_adaptively(const Scene& scene, const ResolvedConditions& conditions, const AnalyzeOptions& options,
                         Stopwatches& seconds);

}  // namespace abut
