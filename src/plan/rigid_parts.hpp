// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that are taken as rigid: bodies of three motions, without grid, stiffness or unknowns.
#pragma once
#include <string>

#include "src/scene/scene.hpp"

namespace abut {

/// A part whose modulus is more than this times that of every part it can touch is taken as rigid: it would change answers by
/// about the inverse.
inline constexpr double rigid_stiffness_ratio = 1e6;

/// Why a part is rigid; empty: it is not, as by its modulus none that its own loads, supports or temperature deform. "It can
/// touch": their boxes come within the first search distance.
std::string why_rigid(const Scene& scene, int part);

}  // namespace abut
