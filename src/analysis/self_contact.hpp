// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that close on themselves: contact of a part with itself is not solved, so it has to be told.
#pragma once
#include <optional>

#include "src/results/result.hpp"

namespace abut {

/// A place (undeformed) where the displaced boundary runs through itself, though the drawn one does not there; the first along
/// the boundary. Sees what the sampling of the boundary sees. Cost: of order n log n for n samples, for boundaries that are not
/// all in one place.
std::optional<Vec2> self_overlap(const PartField& field);

/// Adds a warning for every part that overlaps itself.
void warn_of_self_contact(Result& result);

}  // namespace abut
