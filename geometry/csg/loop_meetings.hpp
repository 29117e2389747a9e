// SPDX-License-Identifier: GPL-3.0-or-later
// Where the edges of `loops` meet although they must not: anywhere but at the corners that they share.
#pragma once
#include <vector>

#include "geometry/csg/loop_model.hpp"

namespace abut::geometry {

/// A meeting of two edges of `loops`.
struct EdgeMeeting {
    enum class Kind {
        same,   ///< both run along each other over all their length
        along,  ///< both run along each other over some of their length: from `at` to `to`
        cross,  ///< they go through each other at `at`
        touch   ///< they touch at `at`, or one ends on the other
    };
    Kind kind = Kind::touch;
    int a = -1, b = -1;  ///< a < b
    Vec2 at{0, 0}, to{0, 0};
    double shared = 0;  ///< length of what they share
};

/// All meetings of the edges, one for each pair of edges that meet (stretches before crossings, crossings before touches),
/// ordered by a, then b; `joined` of the model must be known. Arcs that leave a shared corner in the same direction and bend
/// apart do not meet: a cusp is no spike. Cost O(n log n) and what the pairs cost whose boxes overlap.
std::vector<EdgeMeeting> edge_meetings(const LoopModel& model, const std::vector<bool>& is_left_out);

/// Do the edges run back over each other from a corner that only they share?
bool is_spike(const LoopModel& model, const EdgeMeeting& meeting);

/// The problems that tell the user of the meetings: of loops drawn twice one problem for both, of several pairs that touch in
/// one place one.
std::vector<GeometryProblem> meeting_problems(const LoopModel& model, const std::vector<EdgeMeeting>& meetings);

}  // namespace abut::geometry
