// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that sum up a contact's pressure, and whether two solutions show the same contacts.
#pragma once
#include "src/assembly_model.hpp"

namespace abut {

/// Contacts whose ends move by less than this fraction of their length from one grid to the next are found.
inline constexpr double settled_fraction = 0.015;
/// The same of the root mean square of its pressure, and of its peak unless that stands at an edge, where it may have no limit.
inline constexpr double settled_pressure = 0.05;

/// Largest pressure of a contact, 0 where it is open.
double peak_of(const SolvedAssembly& solved, std::size_t contact);

/// Of all parts.
double energy_of(const SolvedAssembly& solved);

bool any_run(const SolvedAssembly& solved);

/// Same contacts as on the grid before, with ends and pressures that moved little?
bool same_contacts(const SolvedAssembly& now, const SolvedAssembly& before);

}  // namespace abut
