// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that are drawn into each other: what is said of them, and whether the scene allows it.
#pragma once
#include <string>
#include <vector>

#include "src/contact/candidates.hpp"

namespace abut {

/// An overlap in words: "0.2 mm deep, area 0.16, at a/top and b/circle near (0, -0.2)".
std::string overlap_text(const Scene& scene, const Encounter& encounter);
/// What the user can do about an overlap.
std::string overlap_hint(const Scene& scene, const Encounter& encounter);

/// Appends a fault for every overlap but those that "press_fit" or "ignore" can make something of.
void check_overlaps(const Scene& scene, const std::vector<Encounter>& encounters, std::vector<Problem>& problems);

}  // namespace abut
