// SPDX-License-Identifier: GPL-3.0-or-later
// The dissertation's mesh-free contact search [Grishin10, section 4.5.1]: one grid over both parts, and which cells of the two
// come together.
#pragma once
#include "geometry/part.hpp"

namespace abut::geometry {

/// Cell size as a fraction of the smaller part's diagonal.
inline constexpr double case_cell_fraction = 1.0 / 20;

/// The first that applies of
///   'a' the parts share boundary cells,
///   'b' a boundary cell of one shares a side with a boundary cell of the other,
///   'c' a boundary cell of one shares a side with, or is, an inner cell of the other,
///   'd' an inner cell of one shares a side with, or is, an inner cell of the other,
///   'e' nothing of the kind.
/// A boundary cell is one whose interior the boundary passes through, an inner cell is any other one with its centre inside.
/// The grid starts at the lower left corner of the box around both parts. Only the cells around the common part of both boxes
/// are looked at: the others cannot take part.
char cell_case(const Part& part1, const Part& part2, double cell_size);

}  // namespace abut::geometry
