// SPDX-License-Identifier: GPL-3.0-or-later
// What the steps from a drawing to parts work on: entities, and pieces of entities that others cut in two.
#pragma once
#include <string>
#include <vector>

#include "geometry/sketch/sketch.hpp"

namespace abut::geometry {

/// An entity, or a piece of one that was cut.
struct SketchPiece : SketchEntity {
    std::string source;       ///< the entity's name; `name` is "h2F#1" where it was cut
    double source_begin = 0;  ///< arc length on the entity where the piece begins
    int times_drawn = 1;      ///< how often the drawing holds it
    std::vector<int> of{};    ///< the entities that it is (a piece of), by their place among those given
    double whole_length = 0;  ///< of the longest of these entities, uncut
    /// How far beside it an end may be written that was meant to be on it: twice the rounding of the coordinates' last digit.
    /// Nothing of lines along an axis, which keep them, and of others. (Ends that were meant to be one are written alike.)
    double slack = 0;
    std::vector<std::string> also_on{};  ///< other layers that it was drawn on, too
};

double largest_slack(const std::vector<SketchPiece>& entities);

/// How near an end of `piece`, or all of it, is to be to a line to be on it, at least `coincidence`. What runs beside the line
/// at an even distance, to a fraction of a digit, does so by a clearance: rounding moves each of its ends another way.
double reach_of_line(const SketchPiece& line, const SketchPiece& piece, double coincidence);

}  // namespace abut::geometry
