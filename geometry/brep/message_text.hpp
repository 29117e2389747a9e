// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and places as problems and repairs write them.
#pragma once
#include <string>

#include "geometry/curves/vec2.hpp"

namespace abut::geometry {

/// A number with six significant digits.
std::string number_text(double value);
/// A point as "(x, y)", each coordinate as number_text() writes it.
std::string place_text(const Vec2& p);

}  // namespace abut::geometry
