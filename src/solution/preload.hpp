// SPDX-License-Identifier: GPL-3.0-or-later
// Tightening: how far parts have to be shortened across their cuts for the forces there to be those asked for.
#pragma once
#include <vector>

#include "src/solution/solved_assembly.hpp"

namespace abut {

/// Shortens the parts of an assembly until the force across every cut is the one that its preload asks for while no other load
/// acts: supports rest where they were drawn, nothing is warm, interferences press. Writes the shortenings into the parts'
/// systems and inputs, by which they load the parts from then on, and solved.preloads. What cannot be tightened is told in
/// `failure`. Nothing is done, and nothing costs anything, without preloads. Cost: some three to ten contact solutions.
void tighten(const Scene& scene, SolvedAssembly& solved, int threads);

/// Fills in the forces across the cuts in the solution.
void fill_preload_forces(SolvedAssembly& solved);

}  // namespace abut
