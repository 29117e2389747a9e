// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/discretization/discretize.hpp"
#include "src/results/result.hpp"

namespace abut {

/// What the grid makes of a part. Cost: the boundary's quadrature points and 15 ns for each point of the cut cells.
CutQuality cut_quality(const PartOnGrid& grid);

}  // namespace abut
