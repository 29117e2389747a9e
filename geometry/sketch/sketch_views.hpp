// SPDX-License-Identifier: GPL-3.0-or-later
// Views of one part that a drawing shows side by side: each of them looks like a part.
#pragma once
#include <vector>

#include "geometry/sketch/sketch.hpp"

namespace abut::geometry {

/// Warns where the parts of a drawing look like views of one part, or of one assembly. What lies in each other or comes as near
/// as parts of a pair is one figure; views are up to six figures apart from each other
///   - in the places of a projection: others above or below one that are as wide and flush with it, or beside it, as high and
///     flush; the former are as high as the latter are wide. Without some of both no other figure may be there, since parts may
///     be as wide by chance;
///   - or all of the same size, area and perimeter.
/// Lengths agree within the joining tolerance of the whole drawing. At most one warning.
std::vector<SketchProblem> views_of_one_part(const std::vector<Part>& parts);

}  // namespace abut::geometry
