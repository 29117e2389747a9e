// SPDX-License-Identifier: GPL-3.0-or-later
// A mirror symmetric assembly solved on the half: see fold.hpp.
#pragma once
#include <string>

#include "solver/contact/assembly_solve.hpp"

namespace abut::solver {

/// What of a problem is not symmetric to `asymmetry` (fold.hpp).
struct MirrorFailure {
    std::string what{};   ///< empty: nothing
    int part = -1;        ///< that it is about
    int other_part = -1;  ///< the other one of a contact; negative: it is about the part alone
};
/// Of the parts' systems: one product with the stiffness of each.
MirrorFailure asymmetry_of_parts(const AssemblyProblem& problem);

struct MirroredSolution {
    AssemblySolution solution;  ///< of the whole
    MirrorFailure failure;      ///< of the rows; where there is one, nothing else is filled in
    double seconds = 0;         ///< of looking for symmetry of the rows, and folding
};

/// Every part has a mirror, and asymmetry_of_parts found none. The problem's parts are changed meanwhile, and given back as
/// they were. Motions across the mirror line are not solved for, since symmetric loads do no work in them; those that nothing
/// resists are named like the others. Springs too soft for the whole may do for the half: what they alone hold across the line
/// is not asked for.
MirroredSolution solve_mirrored(AssemblyProblem& problem, int threads = 1);

}  // namespace abut::solver
