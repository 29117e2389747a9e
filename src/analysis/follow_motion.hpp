// SPDX-License-Identifier: GPL-3.0-or-later
// The analysis where parts come to rest.
#pragma once
#include <optional>

#include "src/analysis/adaptive.hpp"
#include "src/motion/settle.hpp"

namespace abut {

/// The place of rest that parts settle at as rigid bodies, if that is far from where they are drawn.
std::optional<Rest> rest_of(const Scene& drawn, const ResolvedConditions& conditions, const Settling& settling);

/// Friction may hold parts where they are drawn. Where it does not, there is no answer, or one in which parts roll on, turn far
/// or are led far, and they go to where it holds them; where no way there is found, to where the loads take them without it.
/// Where the answer only slides them, they go to where they rest without friction, if it has them there. The scene with its
/// parts there, or nothing where they stay.
std::optional<Rest> let_go(const Scene& drawn, const ResolvedConditions& conditions, const Outcome& out);

/// Where nothing holds a part as drawn that rests a little beside, or pairs of where parts are drawn are why the target is
/// missed, solves where they rest as rigid bodies. Where the solution goes far from the place that it was paired at (`rest`, or
/// as drawn), solves again from there, a few times at most.
void follow_motion(const Scene& drawn, const ResolvedConditions& conditions, const Settling& settling,
                   const AnalyzeOptions& options, Stopwatches& seconds, Outcome& out, std::optional<Rest>& rest);

/// Says who was moved how far, and what is in doubt about it: an answer where the parts are drawn, which nothing holds there,
/// is none.
void tell_motion(const Scene& drawn, const ResolvedConditions& conditions, const std::optional<Rest>& rest,
                 const Settling& settling, Outcome& out, Result& result);

}  // namespace abut
