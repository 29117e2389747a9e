// SPDX-License-Identifier: GPL-3.0-or-later
// The grids of a pass. Parts that are copies of each other, turned or not, share grid, stiffness and factor where that is
// cheaper than a grid for each: what each wants of its cells the common grid has for all.
#pragma once
#include <map>
#include <vector>

#include "src/discretization/part_grid.hpp"
#include "src/plan/boundary_conditions.hpp"
#include "src/results/result.hpp"

namespace abut {

/// A part that may share the grid of another, which it is a copy of.
struct CopiedPart {
    int model;       ///< scene part
    Frame from, to;  ///< of the model's grid and of its own: the same places of both have the same local coordinates
};

/// The copies among the parts of a scene that are solved, by scene part; a model is none. The same material and thickness, and
/// nothing but loads that leave their stiffness alone: no supports, preload or temperature, no grids of the scene's own.
std::map<int, CopiedPart> copied_parts(const Scene& scene, const ResolvedConditions& conditions,
                                       const std::vector<bool>& parts);

/// The plan's row of grids that copies share: before the run, when copies are known, and after it. model_of: by part on a grid
/// the one whose grid it shares, of these alone.
Effect shared_grids_effect(const Scene& scene, const ResolvedConditions& conditions);
Effect shared_grids_effect(const Scene& scene, const std::map<int, int>& model_of);

/// The grid that a part is put on.
struct DesignedGrid {
    int part;
    int model = -1;  ///< the part whose grid this is, too; -1: it is its own
    Frame frame{};   ///< of parts that have a model
    std::vector<WantedSize> wanted{};
    PartGrid grid{};  ///< for these; none of parts that have a model
};

/// Designs the grids of the parts that are solved, in their order; rigid ones have no cells. wanted: by scene part.
std::vector<DesignedGrid> design_grids(const Scene& scene, const ResolvedConditions& conditions, const std::vector<bool>& parts,
                                       const WantedSizes& wanted, double coarseness, int threads);

}  // namespace abut
