// SPDX-License-Identifier: GPL-3.0-or-later
// Closed outlines that cross themselves or another outline of their layer.
#pragma once
#include <vector>

#include "geometry/sketch/sketch_chains.hpp"

namespace abut::geometry {

/// Two closed outlines that cross, by number, and what the user is told.
struct Crossing {
    int chain, other;  ///< the earlier one first; the same where one crosses itself
    SketchProblem problem;
    bool at_corners = false;         ///< do they meet only where the chain has corners?
    bool at_others_corners = false;  ///< ... where the other one has corners?
};
/// So many crossings and no more are looked for: a drawing with more is no assembly to be mended.
inline constexpr std::size_t most_crossings = 20;

/// The outlines that cross: one entry for each pair (or outline that crosses or touches itself), at one of their meetings:
/// which side of them is material cannot be told. Two outlines may touch each other; none may touch itself. At most
/// most_crossings.
std::vector<Crossing> find_crossings(const std::vector<SketchPiece>& entities, const std::vector<EntityChain>& chains,
                                     double tolerance);

/// A quick test that most pairs of lines and circles fail whose boxes overlap; true of other curves.
bool may_meet(const Curve& a, const Curve& b, double tolerance);

}  // namespace abut::geometry
