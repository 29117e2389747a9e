// SPDX-License-Identifier: GPL-3.0-or-later
// The condition number of a solution by penalty as the dissertation's table 5.2 has it: of the one matrix over all parts.
#pragma once
#include <optional>

#include "src/solution/solved_assembly.hpp"

namespace abut {

/// The 1-norm condition number of K + k^c [Grishin10, eqs 4.36-4.37], k^c of the points under pressure, as it is: without any
/// scaling. Nothing where that matrix cannot be factorised, nor for mortar, which has no such matrix. Costs a factorisation of
/// all parts together.
std::optional<double> assembled_condition(const SolvedAssembly& solved);

}  // namespace abut
