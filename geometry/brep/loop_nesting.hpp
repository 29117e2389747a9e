// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "geometry/brep/part.hpp"

namespace abut::geometry {

/// The smallest loop around each loop of the part, if its inside is material (the loop is that one's hole), or -1 where the
/// loop lies inside an even number of others. All loops must run counter-clockwise, and none may cross or touch another. Cost
/// O(n log n) for loops that are spread out.
std::vector<int> hole_of(const Part& part);

}  // namespace abut::geometry
