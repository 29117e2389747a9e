// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/discretization/discretize.hpp"

namespace abut {

/// Gives the part its axis, and the weights of its cut cells' rules the radius. Throws InputError where the grid reaches over
/// the axis, or is turned against it.
void put_around_axis(const Scene& scene, PartOnGrid& on_grid);

}  // namespace abut
