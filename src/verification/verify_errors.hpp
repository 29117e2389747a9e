// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of the fields of an answer against an exact solution, over a part: at all points that are drawn of it, those of its
// boundary included.
#pragma once
#include <functional>

#include "src/results/result.hpp"

namespace abut {

using ExactDisplacement = std::function<Vec2(const Vec2&)>;
using ExactStress = std::function<Stress(const Vec2&)>;  ///< xx, yy, xy; zz is not looked at

/// The largest difference over the points, as a fraction of the largest exact value.
double largest_displacement_error(const Result& result, const ExactDisplacement& exact);
double largest_stress_error(const Result& result, const ExactStress& exact);

/// The largest value over the boundary's points at this distance from the origin.
double largest_on_circle(const Result& result, double radius, const std::function<double(const FieldSample&)>& value);

/// The stress and displacement of a sample in polar axes about the origin.
double radial_stress(const FieldSample& sample);
double hoop_stress(const FieldSample& sample);
double radial_displacement(const FieldSample& sample);

}  // namespace abut
