// SPDX-License-Identifier: GPL-3.0-or-later
// A mirror symmetric assembly solved on the half: see fold.hpp.
#pragma once
#include <string>

#include "solver/assembly_solve.hpp"

namespace abut::solver {

struct MirroredSolution {
    AssemblySolution solution;  ///< of the whole
    std::string failure;  ///< not empty: the problem is not symmetric to `asymmetry`, and where; nothing else is filled in
    int part = -1;        ///< that the failure is about
    int other_part = -1;  ///< the other one of a contact; negative: the failure is about the part alone
    double seconds = 0;   ///< of looking for symmetry and folding
};

/// Every part has a mirror. The problem's parts are changed meanwhile, and given back as they were. Motions across the mirror
/// line are not solved for, since symmetric loads do no work in them; those that nothing resists are named like the others.
/// Springs too soft for the whole may do for the half: what they alone hold across the line is not asked for.
MirroredSolution solve_mirrored(AssemblyProblem& problem, int threads = 1);

}  // namespace abut::solver
