// SPDX-License-Identifier: GPL-3.0-or-later
// What the walk over grids ends with.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "solver/recovery/recovery.hpp"
#include "src/analysis/error_estimate.hpp"
#include "src/analysis/largest_stress.hpp"
#include "src/analysis/missed_contacts.hpp"
#include "src/analysis/pass_cost.hpp"
#include "src/contact/candidates.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// Why the walk over grids ended.
enum class PathEnd {
    no_need,        ///< grids are given and no target, or there is no error to bring down: one solution
    fixed_grids,    ///< grids are given, and a target with them
    reached,        ///< the estimated error is below the target
    too_deep,       ///< cells are wanted that are too small for their coordinates
    out_of_cells,   ///< the grids may have no more cells
    out_of_passes,  ///< the errors do not fall: the pressure has no limit somewhere
    out_of_digits,  ///< rounding hides what finer grids would change
    out_of_budget,  ///< the next grids would take more time or memory than the user gives
    finer_failed    ///< the next grids gave no answer, or would go beyond the budget of several cases
};

/// The last solution with its stresses and errors, and the way there.
struct Outcome {
    std::vector<Candidate> candidates;
    SolvedAssembly solved;                    ///< on the last grids
    std::vector<solver::StressField> stress;  ///< smoothed, of its parts; none where it is not solved
    std::vector<LargestStress> largest;       ///< parallel to them
    int factorizations = 0, iterations = 0;
    EffectUses uses;  ///< of all passes and searches
    PathEnd end = PathEnd::no_need;
    std::optional<PassCost> next{};     ///< of the next pass, where the user gives a budget
    std::string why{};                  ///< where that is the end: what asks for too small cells, or failed on finer grids
    double target = 0;                  ///< estimated relative error aimed at
    bool search_too_short = false;      ///< contact reaches the end of what was searched
    std::vector<SeenContact> seen{};    ///< of the last solution, by contact
    std::vector<PassRecord> passes;     ///< all of them
    std::vector<ErrorEstimate> errors;  ///< parallel to passes
};

}  // namespace abut
