// SPDX-License-Identifier: GPL-3.0-or-later
// The grid that a part gets: the scene's own where it gives one, else lines designed from the shape and from what contacts ask
// for.
#pragma once
#include <array>

#include "src/discretization/grid_design.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// Memory of a pass at its peak, for each unknown: factor, space and rules (3.4e3 to 4.4e3 in bearings of 20 000 to 400 000
/// unknowns, 4e3 on a million of equal cells, 6e3 in a plate with 256 holes).
inline constexpr double bytes_per_unknown = 6e3;

/// The grid of a part, and the part in the grid's frame.
struct PartGrid {
    Frame frame;
    geometry::Part local;  ///< the part in that frame
    geometry::Grid grid;
    std::array<int, 2> degree;
    bool given = false;    ///< by the scene, or by the dissertation's search: nothing here may refine it
    bool limited = false;  ///< coarser than wanted, to bound the number of cells
    double too_fine = 0;   ///< size of cells that were wanted and would have taken more halvings than there may be; 0: none
};

/// Designs the grid of a part. wanted: of this part. coarseness: of the accuracy level; refinement: a factor on all sizes,
/// below 1 where a basis needs finer cells. Throws InputError where the scene asks for too many cells.
PartGrid grid_of_part(const Scene& scene, int part, const std::vector<WantedSize>& wanted, double coarseness,
                      double refinement);

/// Cells that hold material.
double n_filled(const geometry::Part& local, const geometry::Grid& grid);

}  // namespace abut
