// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "tests/hard_cases/part_problem.hpp"

namespace abut::test {

/// Solves the prepared system and fills in the answer's errors: norms by a rule whose points are all inside the part, largest
/// ones at its points and along the boundary.
void add_errors(const PartProblem& problem, const PreparedPart& prepared, PartAnswer& answer);

}  // namespace abut::test
