// SPDX-License-Identifier: GPL-3.0-or-later
// Is a scene mirror symmetric: in its parts, supports and loads?
#pragma once
#include <string>

#include "src/boundary_conditions.hpp"

namespace abut {

struct MirrorSymmetry {
    bool found = false;
    Vec2 point{0, 0}, along{0, 1};  ///< the mirror line; along: unit
    std::vector<int> image;         ///< by part: its mirror image, maybe itself
    std::string why_not;            ///< what of the scene has no mirror image
};

/// The line x = const through the parts' common centroid is tried, then y = const. Shapes, materials and thicknesses are
/// compared part by part, supports and loads at points along their edges; scenes with rules for pairs of edges count as not
/// symmetric. Cost: of order (edges of a part)^2 closest points where all parts have images, else almost none.
MirrorSymmetry find_mirror_symmetry(const Scene& scene, const ResolvedConditions& conditions);

/// In one line, for the plan.
std::string symmetry_text(const MirrorSymmetry& symmetry);

}  // namespace abut
