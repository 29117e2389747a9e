// SPDX-License-Identifier: GPL-3.0-or-later
// Lever arms of contacts' forces that change as parts move.
#pragma once
#include <vector>

#include "src/solution/solved_assembly.hpp"

namespace abut {

/// A change of the moment of contacts' forces about a part; 0: no more than how well their places are known.
struct LeverChange {
    double share = 0;
    bool of_moment = false;  ///< of that moment; else of the forces at the part's size
};

/// Finds the changes by part that is solved (SolvedAssembly::grids), of those that their supports keep from turning, and which
/// bear that moment: shares of it where supports lead parts as a whole, and of the forces at the part's size where loads move
/// them. Moments that are next to nothing count on parts that supports lead only. What supports hold stays where it was: how it
/// gives way is small, as all that is strain.
std::vector<LeverChange> lever_changes(const Scene& scene, const SolvedAssembly& solved);

}  // namespace abut
