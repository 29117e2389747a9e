// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and places as problems and repairs write them.
#pragma once
#include <string>

#include "geometry/curves/vec2.hpp"

namespace abut::geometry {

/// Six significant digits.
std::string number_text(double value);
/// "(x, y)"
std::string place_text(const Vec2& p);

}  // namespace abut::geometry
