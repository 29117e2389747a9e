// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that an answer's motions bring together, or away from what they press.
#pragma once
#include "src/results/result.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// Warns, with a reason against the answer, where parts as its motions move them overlap without pressing each other, or where
/// they are apart though they do: contact is looked for where parts are drawn. Nothing is looked at where none moves by more
/// than a little of its size.
void warn_of_moved_parts(const Scene& scene, const SolvedAssembly& solved, Result& result);

}  // namespace abut
