// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that are taken as rigid: bodies of three motions, without grid, stiffness or unknowns.
#pragma once
#include <string>

#include "solver/parts/rigid_body.hpp"
#include "src/analysis/adaptive.hpp"
#include "src/discretization/load_vector.hpp"
#include "src/plan/boundary_conditions.hpp"

namespace abut {

/// A part whose modulus is more than this times that of every part it can touch is taken as rigid: it would change answers by
/// about the inverse.
inline constexpr double rigid_stiffness_ratio = 1e6;

/// Why a part is rigid; empty: it is not, as by its modulus none that its own loads, supports or temperature deform. "It can
/// touch": their boxes come within the first search distance.
std::string why_rigid(const Scene& scene, int part);

/// The part in few large cells of bilinear functions, which are there to integrate loads and to hold its motions.
PartOnGrid put_rigid_part(const Scene& scene, int part);

/// Its supports as conditions on its motion. Throws InputError for springs, and for displacements that no motion meets.
solver::PartSystem rigid_system(const Scene& scene, const ResolvedConditions& conditions, const PartOnGrid& on_grid,
                                const PartLoad& load);

/// Rigid parts cannot be pressed against each other: no pressure follows. A pair whose faces overlap after the solution, in
/// words; empty: none. Cost: that of some hundred pairs of points for each candidate between rigid parts.
std::string rigid_pair_failure(const Scene& scene, const Outcome& out);

}  // namespace abut
