// SPDX-License-Identifier: GPL-3.0-or-later
// What a part's free strain (PartInput::free_strain: thermal expansion, the same in all directions) does to it. None of this is
// entered for parts without.
#pragma once
#include "solver/assembly/assembly.hpp"

namespace abut::solver {

/// The load vector (2n) of the stresses that a restrained free strain would leave: int expansion e div v, of the local
/// elasticity; with a projected dilatation the rest is part of the projection (prescribed volume strain 3 e).
Eigen::VectorXd free_strain_load(const PartInput& input);

/// The largest stress that a wholly restrained free strain would leave anywhere in the part: the scale of rounding. Not a
/// number where the strain is none somewhere.
double largest_restrained_stress(const PartInput& input);

/// The elastic energy: stress times elastic strain (that of the displacement less the free one), halved, over the part; a
/// restrained part has some without any displacement, one that expands freely has none. Of the local elasticity (see
/// volume_energy).
double elastic_energy(const PartInput& input, const Eigen::VectorXd& displacement);

}  // namespace abut::solver
