// SPDX-License-Identifier: GPL-3.0-or-later
// Cell sizes that contacts ask for: before a solution from the drawn gaps, after one from the contacts found.
#pragma once
#include <vector>

#include "src/discretization/grid_design.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// The sizes wanted before anything is known: cells along the closest portions of the candidates.
WantedSizes first_sizes(const Scene& scene, const std::vector<Candidate>& candidates, double coarseness);

/// How finely the next grids resolve a contact.
struct ContactResolution {
    double cells;            ///< along each stretch of contact, at least
    double end_fraction;     ///< cells at its free ends, of its length
    double corner_fraction;  ///< cells at corners, and where a straight edge meets an arc, of its length
};

/// The sizes wanted from a solution: cells within every contact, finer towards its ends. stretches: as they were found, or
/// where they are expected; resolution: by contact.
WantedSizes sizes_from(const Scene& scene, const SolvedAssembly& solved, const PressedStretches& stretches,
                       const std::vector<ContactResolution>& resolution);

}  // namespace abut
