// SPDX-License-Identifier: GPL-3.0-or-later
// Levels of the parts of a drawing, where it shows that they lie above each other.
#pragma once
#include "src/scene/scene.hpp"

namespace abut {

/// Gives levels to parts that overlap in the plan as the plates of a linkage do, each time with a warning in the scene and in
/// the record of its import:
///   1. Plates lie above each other where they overlap deeper than any fit, and some part fits holes of both: a pin joins them.
///      So they do where they have a round hole in common in which nothing is drawn; that no pin is there is told.
///   2. They and what else overlaps them as deep, and so on, get as few levels as a greedy colouring finds (those with most
///      levels beside them first: two where two will do). A pin that something lies over counts for the plates that it joins.
///   3. A pin lies on all levels of what it joins.
/// Parts that no pin joins are left alone, however they overlap. Touching parts that come to lie on different levels are told.
void take_guessed_levels(Scene& scene);

/// Only tells what it would give, as a warning.
void tell_guessed_levels(Scene& scene);

}  // namespace abut
