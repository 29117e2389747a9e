// SPDX-License-Identifier: GPL-3.0-or-later
// How often an outline turns around.
#pragma once
#include <optional>
#include <vector>

#include "geometry/brep/part.hpp"

namespace abut::geometry {

/// The number of full turns of the tangent on the way around a closed chain of curves, head to tail: 1 or -1 where it does not
/// cross itself (Hopf's Umlaufsatz), whatever the crossing is too small to be seen by. Nothing where a cusp leaves the sense of
/// a turn open.
std::optional<int> turning_number(const std::vector<Edge>& chain);

}  // namespace abut::geometry
