// SPDX-License-Identifier: GPL-3.0-or-later
// Motions within clearances: a block that is pressed on a floor between walls that it does not touch may lie anywhere between
// them. Its contacts with the walls resist that motion as soon as they close, so that it is not neutral, but under these loads
// nothing holds it and nothing drives it.
#pragma once
#include "solver/contact/assembly_rows.hpp"

namespace abut::solver {

/// Takes, of all places within their clearances, those of the least displacement, in the mean square over the parts, and names
/// the motions as neutral in the solution. Looked at are parts that something presses: where the others lie is not known
/// anyway. multipliers: by row, of the solution. neutral: motions that are so whatever closes. Where no such place is found,
/// parts stay where they are, which is one too.
void take_least_loose_motion(const AssemblyProblem& problem, const AssemblyRows& all, const Eigen::VectorXd& multipliers,
                             const Eigen::MatrixXd& neutral, int threads, AssemblySolution& solution);

}  // namespace abut::solver
