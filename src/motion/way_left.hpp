// SPDX-License-Identifier: GPL-3.0-or-later
// With friction, parts that slide to where they rest do the last of their way in the solution, where friction comes to its
// limit.
#pragma once
#include <vector>

#include "src/motion/placement.hpp"

namespace abut {

/// The scene with the friction of all its contacts taken out.
Scene without_friction(Scene scene);

/// With friction, placements are the same but for parts that slide: those that supports lead, and others that `slide` says, by
/// part. They are short of the end by a thousandth of their size, or all of a shorter way, and go that last bit in the
/// solution, as far as it takes friction to come to its limit beside bodies that are stiff; what was gone before it does not
/// remember.
std::vector<Placement> with_way_left(const Scene& drawn, const ResolvedConditions& conditions,
                                     std::vector<Placement> placements, const std::vector<char>& slide = {});

/// Placements at rest, with friction short of the end likewise: what led parts push and carry is where it is then. Where that
/// is known without friction only, what they carry is at its end. Cost: where parts are led, one more way to rest.
std::vector<Placement> short_of_rest(const Scene& drawn, const ResolvedConditions& conditions,
                                     const std::vector<Placement>& rest);

}  // namespace abut
