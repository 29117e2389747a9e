// SPDX-License-Identifier: GPL-3.0-or-later
// Recovered curves lie beside their facets. Where another boundary runs between the two, the outline was no curve: a roller of
// 24 flat sides that stands on one of them.
#pragma once
#include <vector>

#include "geometry/mesh/section_outline.hpp"

namespace abut::geometry {

/// All outlines of one body's section, material on the left of their points.
struct BodyOutlines {
    std::vector<RecoveredOutline> outlines;
    double tolerance = 0;  ///< of its arcs
};

/// A recovered piece of an outline that another boundary rules out.
struct BulgeConflict {
    int body = 0, outline = 0, piece = 0;  ///< whose curve is none
    int other = 0;                         ///< the body whose boundary is in the way
    Vec2 at{0, 0};
    double depth = 0;  ///< how far that reaches in: more than the tolerance
};

/// The recovered pieces between whose curves and facets a boundary runs, of the same body or (where the curve lies outside of
/// its facets, so that bodies overlap) of another. Left out are pieces where the facets themselves overlap, as those of a press
/// fit, or of a pin in a hole of nearly its size: there the curves are nearer the truth. One conflict for each piece, in order.
/// Cost O(n log n + found), n: facets.
std::vector<BulgeConflict> conflicts_of_bulges(const std::vector<BodyOutlines>& bodies);

}  // namespace abut::geometry
