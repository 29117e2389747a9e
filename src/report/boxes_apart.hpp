// SPDX-License-Identifier: GPL-3.0-or-later
// How to draw boxes apart from each other.
#pragma once
#include <vector>

#include "geometry/curves/vec2.hpp"

namespace abut {

/// The shifts after which no two boxes come closer than half the gap. The largest boxes stay; each smaller one goes the
/// shortest way along an axis to a place with a gap to those before it. Empty boxes stay. Cost O(n^2), O(n^3) where all lie in
/// one place.
std::vector<geometry::Vec2> shifts_apart(const std::vector<geometry::Box2>& boxes, double gap);

}  // namespace abut
