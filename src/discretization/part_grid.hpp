// SPDX-License-Identifier: GPL-3.0-or-later
// The grid that a part gets: the scene's own where it gives one, else lines designed from the shape and from what contacts ask
// for.
#pragma once
#include <array>

#include "src/discretization/grid_design.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// The grid of a part, and the part in the grid's frame.
struct PartGrid {
    Frame frame;
    geometry::Part local;  ///< the part in that frame
    geometry::Grid grid;
    std::array<int, 2> degree;
    bool given = false;    ///< by the scene, or by the dissertation's search: nothing here may refine it
    bool limited = false;  ///< coarser than wanted, to bound the number of cells
};

/// Designs the grid of a part. wanted: of this part. coarseness: of the accuracy level; refinement: a factor on all sizes,
/// below 1 where a basis needs finer cells. Throws InputError where the scene asks for too many cells.
PartGrid grid_of_part(const Scene& scene, int part, const std::vector<WantedSize>& wanted, double coarseness,
                      double refinement);

}  // namespace abut
