// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/cells/cut_cells.hpp"

namespace abut::geometry {

/// What a contour piece contributes to the area of its cell: the integral of (x - x0) dy; x0, x1: the cell's left and right
/// side. The sum over a closed chain of contours is the area about which they run counter-clockwise.
double area_share(const Part& part, const ContourPiece& piece, double x0, double x1);

}  // namespace abut::geometry
