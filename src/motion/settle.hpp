// SPDX-License-Identifier: GPL-3.0-or-later
// Where the loads take the parts of an assembly before anything deforms: its parts as rigid bodies without friction, by finite
// motions.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "src/motion/placement.hpp"
#include "src/results/result.hpp"

namespace abut {

/// What the loads do to parts as they are drawn.
struct Settling {
    enum class End {
        not_asked,  ///< parts are not followed in this scene
        stays,      ///< no part goes farther than the pairing of drawn edges is good for
        rests,      ///< parts go to `placements`, and rest there
        never,      ///< nothing stops a part, or it balances where the least push ends that
        lost        ///< no place of rest was found
    };
    End end = End::not_asked;
    std::string why{};                    ///< in words; of `rests`: who goes how far
    std::vector<Placement> placements{};  ///< by part, from where they are drawn; of `rests`, and of `stays` if they move
    std::vector<std::string> parts{};     ///< those that go far, or that nothing stops
    std::string unstable{};               ///< not empty: the balance is held only as long as nothing pushes it, in words
};

/// Follows the loads. Every step is one convex problem: the loads' work, stiff springs along the gaps at the present place, and
/// a drag that keeps motions within what was searched; pairs are found anew after each. Ends where loads and pressures balance
/// without the drag. Cost: a search for pairs and some dense steps in three unknowns a part, for each of some tens of steps;
/// one of each where nothing goes far. from: where parts are before these loads act; empty: where they are drawn.
/// to_the_end: also where no part goes far.
Settling settle(const Scene& drawn, const ResolvedConditions& conditions, const std::vector<Placement>& from = {},
                bool to_the_end = false);

/// Follows the loads of a scene with friction: parts fall until they touch, roll, slide and tip about that, and rest where
/// friction holds them all; from there parts go on that supports lead. Not asked where none is led far and, unless
/// `also_pressed`, all loaded parts are pressed on others as drawn.
Settling settle_until_held(const Scene& drawn, const ResolvedConditions& conditions, bool also_pressed);
/// The plan's row of it.
Effect large_motion_effect(const Settling& settling);

}  // namespace abut
