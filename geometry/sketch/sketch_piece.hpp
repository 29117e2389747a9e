// SPDX-License-Identifier: GPL-3.0-or-later
// What the steps from a drawing to parts work on: entities, and pieces of entities that others cut in two.
#pragma once
#include <algorithm>
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
    /// How far beside a line that it was meant to be on it may be written: twice the rounding of its coordinates' last digit.
    /// Nothing of lines along an axis, which stay on each other, and of others.
    double slack = 0;
    std::vector<std::string> also_on{};  ///< other layers that it was drawn on, too
};

inline double largest_slack(const std::vector<SketchPiece>& entities) {
    double most = 0;
    for (const SketchPiece& entity : entities) most = std::max(most, entity.slack);
    return most;
}

}  // namespace abut::geometry
