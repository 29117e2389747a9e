// SPDX-License-Identifier: GPL-3.0-or-later
// The areas of outlines that share edges.
#pragma once
#include <vector>

#include "geometry/sketch/sketch_chains.hpp"

namespace abut::geometry {

/// One area of a divided outline.
struct Face {
    EntityChain boundary;   ///< counter-clockwise
    bool is_filled = true;  ///< where nothing is around the divided outline; see walk_faces
};

/// An outline whose areas share edges.
struct DividedOutline {
    EntityChain contour;  ///< around all of it, counter-clockwise
    std::vector<Face> faces;
    bool is_even_odd = false;
};

/// The smallest areas that the entities of one block bound: half edges are sorted about each joint, and each is followed by the
/// one next to it. Every entity bounds two areas, or one area and the outside. Which of the areas are filled:
///   - Where every outline was drawn by itself, an even number of ends (entities drawn twice counted twice) meets in each
///   joint:
///     each line that is crossed on the way in from outside changes from empty to filled and back, as many times as it was
///     drawn. Two plates drawn side by side are both filled, and so is each bar of a frame, but not the opening inside; a
///     rectangle along a side of a larger one is a notch in it, as it would be a hole were it clear of the side. A block all of
///     whose entities were drawn an even number of times counts them half as often.
///   - Otherwise a line was drawn once for two areas: all are filled.
/// The curves must meet in their joints (close_joints) and nowhere else. Cost O(n log n).
DividedOutline walk_faces(const std::vector<SketchPiece>& entities, const Joints& joints, const std::vector<int>& block);

}  // namespace abut::geometry
