// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes around an axis: x is the radius, y runs along the axis x = 0. What they may hold.
#pragma once
#include <vector>

#include "src/plan/boundary_conditions.hpp"

namespace abut {

/// Does an edge of the part lie on the axis?
bool touches_axis(const geometry::Part& part);
/// Does this portion of an edge lie on the axis?
bool is_on_axis(const Scene& scene, const EdgePortion& portion);

/// Appends every way in which an axisymmetric scene can be wrong that others cannot: parts across the axis, loads without a
/// meaning or an area there, motions that hoops do not have.
void append_axisymmetric_problems(const Scene& scene, const ResolvedConditions& conditions, std::vector<Problem>& problems);

}  // namespace abut
