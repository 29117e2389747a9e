// SPDX-License-Identifier: GPL-3.0-or-later
// The size of a part that a rotation does not change.
#pragma once
#include "geometry/brep/part.hpp"

namespace abut::geometry {

/// The largest distance between two points of the part's boundary: a rectangle's diagonal, a disc's diameter. Curved edges are
/// sampled, which leaves it short by at most 0.5 %, by the same amount however the part lies.
double extent(const Part& part);

}  // namespace abut::geometry
