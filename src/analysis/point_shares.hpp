// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "src/solution/solved_assembly.hpp"

namespace abut {

/// What the forces of contacts change by, relative to each, where cells are half as large at the held points that they share
/// loads with. A point yields without limit as its cells draw together (Flamant's wedge), and bears nothing in the end: such
/// forces are known no better. Empty: no contact shares any; else the contact problem is solved once more for it.
std::vector<double> shares_of_points(const Scene& scene, const SolvedAssembly& solved, int threads);

}  // namespace abut
