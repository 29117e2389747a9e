// SPDX-License-Identifier: GPL-3.0-or-later
// Is a scene mirror symmetric: in its parts, supports and loads?
#pragma once
#include <string>

#include "src/plan/boundary_conditions.hpp"

namespace abut {

struct MirrorSymmetry {
    bool found = false;
    MirrorLine line;
    std::string why_not;  ///< what of the scene has no mirror image
};

/// The line x = const through the parts' common centroid is tried (not around an axis), then y = const. Shapes, materials and
/// thicknesses are compared part by part, supports, loads, temperatures and rules for pairs at points along their edges. Cost:
/// of order (edges of a part)^2 closest points where all parts have images, else almost none.
MirrorSymmetry find_mirror_symmetry(const Scene& scene, const ResolvedConditions& conditions);

/// In one line, for the plan; folded: half of the scene is to be solved.
std::string symmetry_text(const MirrorSymmetry& symmetry, bool folded);

/// Looks for the symmetry, and says in the plan what was found, and whether half of the scene is to be solved.
MirrorSymmetry plan_symmetry(const Scene& scene, const ResolvedConditions& conditions, std::vector<Effect>& plan);
/// The plan's effect "symmetry".
void set_symmetry(bool on, const std::string& why, std::vector<Effect>& plan);

}  // namespace abut
