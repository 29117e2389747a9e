// SPDX-License-Identifier: GPL-3.0-or-later
// Where a contact ends whose grid is too coarse to tell.
//
// Its force is right on the coarsest grid, by statics. Bodies that are large beside the contact answer a pressure like half
// planes; with the drawn gap f(x) around the middle the half width a follows from the force per thickness
//   P = E* int_0^(pi/2) a sin(t) f'(a sin(t)) dt,   1/E* = 1/E1' + 1/E2'
// (Galin's integral for a symmetric profile; f = x^2 / (2 R) gives Hertz' P = pi E* a^2 / (4 R)). Only a place to put cells:
// the next solution finds the end itself.
#pragma once
#include "src/assembly_model.hpp"

namespace abut {

/// By contact: runs of few knot intervals with their free ends put there, about the pressure's middle, or about the interface's
/// end where a run begins or ends with it (a line of symmetry); ends of longer runs near a fillet's joint put beyond it; others
/// as they were found.
std::vector<std::vector<ContactRun>> runs_by_theory(const Scene& scene, const SolvedAssembly& solved);

}  // namespace abut
