// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that sum up a solution.
#pragma once
#include "src/assembly_model.hpp"

namespace abut {

/// Largest pressure of a contact, 0 where it is open.
double peak_of(const SolvedAssembly& solved, std::size_t contact);

/// Of all parts.
double energy_of(const SolvedAssembly& solved);

bool any_run(const SolvedAssembly& solved);

}  // namespace abut
