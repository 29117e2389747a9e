// SPDX-License-Identifier: GPL-3.0-or-later
// What the exact lines and arcs of a Boolean (exact_regions.hpp) are of the curves that they come from.
#pragma once
#include <vector>

#include "geometry/csg/boolean.hpp"
#include "geometry/csg/carriers.hpp"
#include "geometry/csg/merge_pieces.hpp"

namespace abut::geometry {

/// What one exact line or arc is of its source: all of it, or the portion of an ellipse or spline that one arc follows.
struct SourcePortion {
    int source = -1;
    double t0 = 0, t1 = 1;
    int turn = 0;    ///< in the source's own direction: 0 line, +1 or -1 arc
    Vec2 way{0, 0};  ///< lines: the source's own direction
};

/// All portions, numbered source by source, along each: first[s] is the first one of source s. The turns of a carrier's arcs
/// are not known here: 0.
struct SourcePortions {
    std::vector<SourcePortion> portions;
    std::vector<int> first;
};
/// Numbers the portions of all sources.
SourcePortions number_portions(const std::vector<PlacedSource>& sources, const Carriers& carriers);

/// The piece of a Boolean's boundary that lies on the portion of this number (or on bridge_source, or far_source). turn: 0
/// line, +1 or -1 arc, from `from` to `to`.
RawPiece raw_piece(const std::vector<SourcePortion>& portions, int number, const Vec2& from, const Vec2& to, int turn);

}  // namespace abut::geometry
