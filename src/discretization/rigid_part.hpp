// SPDX-License-Identifier: GPL-3.0-or-later
// A rigid part as what the solver takes: a body of three motions, and cells that loads are integrated on.
#pragma once
#include "solver/parts/rigid_body.hpp"
#include "src/discretization/load_vector.hpp"

namespace abut {

/// Puts a rigid part into few large cells of bilinear functions, which are there to integrate loads and to hold its motions.
PartOnGrid put_rigid_part(const Scene& scene, int part);

/// Makes a rigid part's system, its supports as conditions on its motion. Throws InputError for displacements that no motion
/// meets.
solver::PartSystem rigid_system(const Scene& scene, const ResolvedConditions& conditions, const PartOnGrid& on_grid,
                                const PartLoad& load);

}  // namespace abut
