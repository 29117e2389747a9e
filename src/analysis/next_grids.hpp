// SPDX-License-Identifier: GPL-3.0-or-later
// Cells that the next grids are to have, from what a solution shows of the contacts and of its errors.
#pragma once
#include <vector>

#include "src/analysis/error_estimate.hpp"
#include "src/analysis/grading.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// Factors on the cells that the shape asks for: on the first grids, and from one to the next. First and second grids only
/// locate the contacts, and show what the shape's cells do.
inline constexpr double first_coarsening = 2, coarsening_step = 1.4;

/// What the next grids are to have; kept and changed from pass to pass.
struct NextGrids {
    double target;                                ///< estimated relative error aimed at
    double coarseness;                            ///< of the shape's cells, at the target
    double coarsening;                            ///< of these, on the next grids
    std::vector<double> goal{};                   ///< by contact: fraction of its length that reaches the target at its ends
    std::vector<ContactResolution> resolution{};  ///< by contact, on the next grids

    double next_coarseness() const;
    bool on_final_cells() const { return coarsening <= coarseness; }
};

/// Takes the shape's cells towards the final ones by one step; the last step is no smaller than the others, or there would be
/// nothing to see in it.
void coarsen_less(NextGrids& next);

/// Sets what the contacts that were just found aim at; stretches: as they were found, or where they are expected.
void set_first_goals(const SolvedAssembly& solved, const PressedStretches& stretches, NextGrids& next);

/// Sets the next grids to the goals: they are the last ones, if all goes well.
void aim_at_goals(NextGrids& next);

/// Have the contacts the cells that they aimed at, and is there one whose error counts away from its ends all the same? It may
/// be the shape's cells that it lacks: the error of the energy tells.
bool may_lack_shape(const ErrorEstimate& error, const NextGrids& next);

/// Gives contacts whose error still counts finer cells; where they had what they aimed at, they aim at less.
void refine(const ErrorEstimate& error, NextGrids& next);
/// Makes all cells finer where a solution has no answer, which nothing can be estimated of: on the same cells there would be
/// none again.
void refine_all(NextGrids& next);

/// The sizes that bonded parts want, which are one body: those at a place of one of them are wanted around it in all.
WantedSizes with_bonded(const WantedSizes& wanted, const std::vector<Candidate>& candidates);

}  // namespace abut
