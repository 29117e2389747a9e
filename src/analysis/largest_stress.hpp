// SPDX-License-Identifier: GPL-3.0-or-later
// The largest von Mises stress of every part, and its own estimated error. The energy's says nothing of it: a notch that is
// small beside the part has no energy.
//
// Smoothed stresses, which are those shown, and stresses of the displacement differ where the grid is too coarse for either;
// with two grids, the peak's change is compared with that. At re-entrant corners, at the ends of supports, under held points
// and where contact ends at a corner the stress has no limit, and no error. Nor has it one in a part whose largest stress on
// these grids is elsewhere, but whose stress at a re-entrant corner or a support's end would be above it on cells ten times
// smaller.
#pragma once
#include <optional>
#include <vector>

#include "solver/recovery/recovery.hpp"
#include "src/plan/boundary_conditions.hpp"
#include "src/results/result.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// A largest stress that is known no better than to this share of it is doubtful: that is told, and contact problems, which aim
/// at pressures, go on for it.
inline constexpr double doubtful = 0.1;

/// The largest stress of one part, and its largest displacement.
struct LargestStress {
    ValueAt displacement;           ///< the largest, too: both are found in one go
    double displacement_error = 0;  ///< absolute: of the strains in the cell there, of which energies know little
    ValueAt von_mises;              ///< assembly coordinates
    Stress stress{};                ///< there
    double cell = 0;                ///< size of the cell there
    double smoothing = 0;           ///< von Mises stress of what smoothed stresses and the others differ by in that cell
    bool at_corner = false;         ///< there is no limit there
    std::optional<ValueAt> corner;  ///< stress at a corner without a limit, which finer grids take above the largest one
    bool corner_is_held = false;    ///< it is the end of a support
    double on_smaller_cells = 0;    ///< stress at that corner on cells ten times smaller
    std::optional<double> error;    ///< of the stress, relative; unset at corners, and where nothing is strained
};

/// The largest stress of each part of solved.grids. stress: of fits that have not failed; before: the largest stresses on the
/// grids before, or empty.
std::vector<LargestStress> largest_stresses(const Scene& scene, const ResolvedConditions& conditions,
                                            const SolvedAssembly& solved, const std::vector<solver::StressField>& stress,
                                            const std::vector<LargestStress>& before, int threads);

/// The largest stress of all; nullptr where there is none.
const LargestStress* strongest(const std::vector<LargestStress>& all);

/// The elements of solved.grids[k] whose stress is as large as the largest of their part, within its error and 10 % of it at
/// most, and that are not fine enough for it; none beside corners. Cost: an evaluation of both stresses at every quadrature
/// point.
std::vector<int> elements_as_large(const Scene& scene, const ResolvedConditions& conditions, const SolvedAssembly& solved,
                                   std::size_t k, const solver::StressField& stress, const LargestStress& largest);

}  // namespace abut
