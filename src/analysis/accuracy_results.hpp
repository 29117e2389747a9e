// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of the answer's accuracy: estimated errors, whether the target was reached, what the next level would cost.
#pragma once
#include "src/analysis/outcome.hpp"
#include "src/results/result.hpp"

namespace abut {

/// What no grid shows of each contact: what small displacements leave out, since parts move from where they are drawn, and what
/// held points leave open. Each may be empty.
struct ModelErrors {
    std::vector<double> of_pairs;     ///< of the largest pressure (moved_pair_errors)
    std::vector<double> of_turns;     ///< of forces (turned_shares)
    std::vector<double> of_points{};  ///< of forces (shares_of_points)
    std::vector<char> at_ends{};      ///< of bonds: their largest pressures have no limit (peaks_at_bond_ends)
};

/// Fills in the estimated errors of the contacts (parallel to the candidates) and of the whole, and the passes; warns where the
/// target was missed or a pressure may have no limit.
void fill_errors(const Outcome& out, const ModelErrors& of_model, Result& result);

/// Warns of contacts that the last grids did not resolve: the accuracy is not reached. Call after fill_errors.
void fill_missed(const Outcome& out, Result& result);

/// Fills in the estimated errors of the largest displacements. Forces given, the energy is half of what they work, and
/// displacements err like it: those of parts with supports of their own like the part's energy, or the forces on it; of others
/// by as much in absolute terms as the largest of all. What friction keeps of steps before errs as its tractions. Warns where
/// contact pressures reached a target that the energy did not. Call with the parts and the contacts' errors filled in.
void fill_displacement_errors(const Outcome& out, Result& result);

/// Adds to the errors of largest stresses where contact presses: what they differ by from the pressure on the face there, and
/// what that errs by itself. A face's stresses all fall short of the pressure alike, so that they say nothing of it among
/// themselves. Call with the parts and the contacts' errors filled in.
void fill_stress_errors(const Outcome& out, Result& result);

/// Warns where the largest of the parts' largest stresses has no limit, or is not known well. Call with the parts filled in.
void warn_of_largest_stress(const Outcome& out, Result& result);

/// Fills in the next finer level (or a fifth of the target) and its time, from the growth of unknowns with falling errors over
/// the passes and from the seconds they took; nothing where there is no estimate to go by, or where this level was missed. Call
/// with the timing filled in, and again when more of the total is known.
void predict_next_level(Result& result);

}  // namespace abut
