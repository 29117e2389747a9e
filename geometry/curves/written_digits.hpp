// SPDX-License-Identifier: GPL-3.0-or-later
// How well numbers are known that are written with few decimals.
#pragma once
#include <vector>

#include "geometry/curves/vec2.hpp"

namespace abut::geometry {

/// The unit of the last decimal that some numbers, but for one in ten, are written with: 0.001 of 2.5 and 3.125. 0: there are
/// none, or they have more decimals than six.
double last_digit(const std::vector<double>& numbers);

/// How far rounding to the last decimal that they are written with has moved points, or changed lengths, at most. 0: they
/// are written with all their digits, or with as few as sizes are given with, which says nothing of their rounding (a digit of
/// more than 1e-4 of `size`, that of all there is).
double written_rounding(const std::vector<Vec2>& points, double size);
double written_rounding(const std::vector<double>& lengths, double size);

}  // namespace abut::geometry
