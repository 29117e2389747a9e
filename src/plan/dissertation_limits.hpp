// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene may not have if it asks for the dissertation's method, which has no formulation for it.
#pragma once
#include "src/scene/scene.hpp"

namespace abut {

/// Appends a problem for each support, load, rule and part that the dissertation's method cannot take; nothing for scenes by
/// other methods. Edges that weights cannot hold are told when the part is on its grid.
void append_dissertation_problems(const Scene& scene, std::vector<Problem>& problems);

}  // namespace abut
