// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/cells/cut_cells.hpp"

namespace abut::geometry {

/// Contribution of a contour piece to the area of its cell: the integral of (x - x0) dy; x0, x1: the cell's left and right
/// side. Of a closed chain of contours it is the area about which they run counter-clockwise.
double area_share(const Part& part, const ContourPiece& piece, double x0, double x1);

}  // namespace abut::geometry
