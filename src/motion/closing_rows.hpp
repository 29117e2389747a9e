// SPDX-License-Identifier: GPL-3.0-or-later
// Where parts that move as rigid bodies may meet: gaps at points of their facing edges.
#pragma once
#include <vector>

#include "src/contact/candidates.hpp"

namespace abut {

/// A gap that must not close: of two points on one line along the normal, which runs from the first part to the second.
struct ClosingRow {
    int first, second;  ///< parts
    Vec2 x1, x2, normal;
    double gap;  ///< negative: they overlap
    /// What a force along the normal acts in, however the parts turn: the centres of a round part and of the hollow about it,
    /// else the points themselves.
    Vec2 pivot1, pivot2;
    double friction = 0;     ///< coefficient; infinite: rough
    bool is_beside = false;  ///< of where a round face is closest to a flat or round one: it opens as much by its curvature as
                             ///< it closes by rolling
};

/// The gaps between parts where they are, and the deepest overlap, over the extent of the smaller part.
struct Closing {
    std::vector<ClosingRow> rows;
    double deepest = 0;
    bool overlaps = false;  ///< by more than counts as touching
};

/// Finds the gaps that parts can close by moving as far as `may_move` says, by part (0: it does not). bodies: by part; those of
/// one body do not meet. Along curved faces the
/// points lie closer and closer to where the gap is least, so that forces there find their direction. rules: of the drawn
/// scene.
Closing closing_rows(const Scene& scene, const PairRules& rules, const std::vector<int>& bodies,
                     const std::vector<double>& may_move);

}  // namespace abut
