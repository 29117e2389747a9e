// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that sum up a solution.
#pragma once
#include "src/assembly_model.hpp"

namespace abut {

/// Largest pressure of a contact, 0 where it is open.
double peak_of(const SolvedAssembly& solved, std::size_t contact);

/// Of all parts.
double energy_of(const SolvedAssembly& solved);

/// Resultant on the contact's first part, shear of bonds included, and its moment about the origin; from the same quadrature
/// that the solution used.
struct ContactForce {
    Vec2 force{0, 0};
    double moment = 0;
};
ContactForce contact_force(const SolvedAssembly& solved, std::size_t contact);

bool any_run(const SolvedAssembly& solved);

}  // namespace abut
