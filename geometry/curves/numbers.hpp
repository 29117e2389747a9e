// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <limits>
#include <numbers>

namespace abut::geometry {

/// A full turn, radians.
inline constexpr double two_pi = 2 * std::numbers::pi;
/// The step from 1 to the next double.
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace abut::geometry
