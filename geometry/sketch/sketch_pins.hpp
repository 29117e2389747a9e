// SPDX-License-Identifier: GPL-3.0-or-later
// Pins through plates that lie above each other, of which the plates do not draw the holes.
#pragma once
#include <string>
#include <vector>

#include "geometry/sketch/sketch.hpp"

namespace abut::geometry {

/// Cuts pins out of plates. A part is a pin where it lies in the outlines of two parts of other groups (layers, blocks) that
/// cross each other: these cannot be one plate with a part on it, and what goes through one goes through both. A plate in whose
/// material all of the pin lies was drawn without its hole: it gets the pin's outline as one, with the edges' names, and a
/// warning. Where two plates that cross have the hole as drawn, those that have none lie over the pin. `group`: of each part.
void cut_pins(std::vector<Part>& parts, const std::vector<std::string>& group, std::vector<SketchProblem>& warnings);

}  // namespace abut::geometry
