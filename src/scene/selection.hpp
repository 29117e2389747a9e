// SPDX-License-Identifier: GPL-3.0-or-later
// Turns the scene's selections into portions of edges.
#pragma once
#include <vector>

#include "src/scene/scene.hpp"

namespace abut {

/// The portions selected, by part, edge and parameter, without overlaps. Throws InputError (JSON pointer of the selector) where
/// a selector matches nothing: the message lists the part's edges, or the known parts where the part is unknown.
std::vector<EdgePortion> select(const Scene& scene, const Selection& selection);

/// Fills in what a rule is for in the scene as it is drawn. Throws like select.
void resolve(const Scene& scene, PairRule& rule);

/// The edges of a part nearest to a place, ascending: several where their distances are the same to what the part merges. The
/// first of them is what `near` selects.
struct NearestEdges {
    std::vector<int> edges;
    double distance = 0;
};
NearestEdges nearest_edges(const geometry::Part& part, const Vec2& p);

}  // namespace abut
