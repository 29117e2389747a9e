// SPDX-License-Identifier: GPL-3.0-or-later
// The field of a part as cells that fill the part and nothing beyond it, for programs that know meshes alone.
#pragma once
#include <vector>

#include "src/results/result.hpp"

namespace abut::report {

/// Triangles and quadrilaterals, counter-clockwise: three or four points each, triangles first.
struct ClippedCells {
    std::vector<FieldSample> points;
    std::vector<std::vector<int>> cells;
};

/// Patches inside stay as they are; those that the boundary crosses are cut along it into trapezoids between its points, which
/// lie on the exact boundary and have the values there (chords turn by less than 0.06: an arc is left by 5e-4 of its radius at
/// most). Within a patch components vary linearly between corners, so that neighbours agree along their common sides, where
/// points of one may lie between those of the other. part: as the field has it; loops with the part on their left.
ClippedCells clipped_cells(const PartField& field, const geometry::Part& part);

}  // namespace abut::report
