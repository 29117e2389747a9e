// SPDX-License-Identifier: GPL-3.0-or-later
// The scene's supports as what the solver takes, in the frame of a part's grid.
#pragma once
#include <vector>

#include "solver/contact/assembly_solve.hpp"
#include "src/discretization/discretize.hpp"
#include "src/plan/boundary_conditions.hpp"

namespace abut {

/// The supports of one part along its boundary. SupportSet::tag is the index of the scene's support. What a
/// part's structure holds (on_grid.input.structure, solution_structure.hpp) comes as sets that say so.
std::vector<solver::SupportSet> support_sets(const Scene& scene, const ResolvedConditions& conditions,
                                             const PartOnGrid& on_grid);

/// The elastic foundations of one part. SpringSet::tag is the index of the scene's support.
std::vector<solver::SpringSet> spring_sets(const Scene& scene, const ResolvedConditions& conditions, const PartOnGrid& on_grid);

/// The mean constraints of one part ("rigid" supports); `part` is the index among the solver's parts.
std::vector<solver::MeanConstraint> mean_constraints(const Scene& scene, const PartOnGrid& on_grid, int part);

/// The held points of one part, as constraints on its displacement there; none where its structure holds them. A component that
/// an edge through the point holds already, or a support before, is left to that.
std::vector<solver::MeanConstraint> point_constraints(const Scene& scene, const ResolvedConditions& conditions,
                                                      const PartOnGrid& on_grid, int part);

}  // namespace abut
