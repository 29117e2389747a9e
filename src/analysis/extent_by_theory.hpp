// SPDX-License-Identifier: GPL-3.0-or-later
// Where a contact ends whose grid is too coarse to tell.
//
// Its force is right on the coarsest grid, by statics. Bodies that are large beside the contact answer a pressure like half
// planes; with the drawn gap f(x) around the middle the half width a follows from the force per thickness [Galin1953]
//   P = E* int_0^(pi/2) a sin(t) f'(a sin(t)) dt,   1/E* = 1/E1' + 1/E2'
// for a symmetric profile; f = x^2 / (2 R) gives Hertz' P = pi E* a^2 / (4 R). A flat of half width b with fillets of radius R
// touches a little beyond them, for a - b << b (the limit of [Ciavarella1998]) by
//   a - b = (3 P R / (4 E* sqrt(b / 2)))^(2/3)
// and nearly all of the pressure's steep ends lies there. Only a place to put cells: the next solution finds the end itself.
// Parts that move far before they press (a pin drawn concentric with its hole) have another gap then: nothing is said of them.
#pragma once
#include <optional>
#include <vector>

#include "src/analysis/plane_pressure.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// The contacts of a solution as half planes have them.
struct TheoryOfContacts {
    PressedStretches stretches;
    /// The pressure by theory, by contact; where all of its stretches are small beside their parts and of half planes.
    std::vector<std::optional<PlanePressure>> pressure;
    bool is_close = false;  ///< every contact has one
};

/// Applies the theory to a solution. Stretches of few knots get their free ends from it, about where the drawn gap is lowest,
/// or about the interface's end where a stretch begins or ends with it (a line of symmetry); ends of longer stretches near a
/// fillet's joint are put beyond it; others are as they were found. Where the first kind is all there is of a contact, its
/// pressure is given, too.
TheoryOfContacts contacts_by_theory(const Scene& scene, const SolvedAssembly& solved);

/// The pressures by theory of a later solution: of its forces, and of the contacts that it closed.
void renew_pressures(const Scene& scene, const SolvedAssembly& solved, TheoryOfContacts& theory);

}  // namespace abut
