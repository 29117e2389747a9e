// SPDX-License-Identifier: GPL-3.0-or-later
// Cells that are wanted below what coordinates can tell apart.
#pragma once
#include <string>

#include "src/solution/solved_assembly.hpp"

namespace abut {

/// Does any part want such cells?
bool is_too_deep(const SolvedAssembly& solved);

/// Which parts do, how small, and what to do about it.
std::string text_of_too_deep(const Scene& scene, const SolvedAssembly& solved);

}  // namespace abut
