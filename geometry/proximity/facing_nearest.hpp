// SPDX-License-Identifier: GPL-3.0-or-later
// Where a point has several partners, the nearest one counts.
#pragma once
#include <vector>

#include "geometry/proximity/facing_stretch.hpp"

namespace abut::geometry {

/// The parts of the stretches where neither point of a pair has a nearer partner (smaller |gap|) on another stretch. Both parts
/// are treated alike: exchanging them gives the same pairs.
std::vector<FacingStretch> nearest_only(const FacingModel& model, const std::vector<FacingStretch>& stretches);

}  // namespace abut::geometry
