// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>

#include "geometry/brep/part.hpp"

namespace abut::geometry {

/// The rotation and shift that take one part to another which is a copy of it: the same edges in the same order, to rounding of
/// their coordinates. None: it is no such copy. Mirror images are none, nor outlines that begin at another edge. Cost: of order
/// the number of edges.
std::optional<Similarity> congruence(const Part& from, const Part& to);

}  // namespace abut::geometry
