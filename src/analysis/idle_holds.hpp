// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/results/result.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// Notes the motions of parts that carry load in which nothing holds them but contacts that carry nothing: a key between the
/// sides of its groove stands wherever it met no resistance. Needs `under_load` and the contacts; says nothing under friction,
/// which may hold them, nor of the solution's neutral motions, which are told elsewhere.
void note_idle_holds(const Scene& scene, const SolvedAssembly& solved, Result& result);

}  // namespace abut
