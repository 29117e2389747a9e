// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes around an axis: x is the radius, y runs along the axis x = 0. What they may hold, and what the solver is told of it.
#pragma once
#include <vector>

#include "src/discretization/discretize.hpp"
#include "src/plan/boundary_conditions.hpp"

namespace abut {

/// Forces are totals over the full circle: 2 pi is the thickness.
inline constexpr double full_circle = 6.283185307179586;

/// Does an edge of the part lie on the axis?
bool touches_axis(const geometry::Part& part);
/// Does this portion of an edge?
bool is_on_axis(const Scene& scene, const EdgePortion& portion);

/// Every way in which an axisymmetric scene can be wrong that others cannot: parts across the axis, loads without a meaning or
/// an area there, motions that hoops do not have.
void append_axisymmetric_problems(const Scene& scene, const ResolvedConditions& conditions, std::vector<Problem>& problems);

/// The part's axis, and the radius in the weights of its cut cells' rules. Throws InputError where the grid reaches over the
/// axis, or is turned against it.
void put_around_axis(const Scene& scene, PartOnGrid& on_grid);

}  // namespace abut
