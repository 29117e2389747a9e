// SPDX-License-Identifier: GPL-3.0-or-later
// Mirror images of parts on grids that are each other's mirror image: where functions and coefficients go. Legend: axis, the
// direction of the parts' own frames that the mirror reverses (0: x, 1: y); a part's image may be the part itself.
#pragma once
#include <string>
#include <vector>

#include "solver/assembly/assembly.hpp"

namespace abut::solver {

/// Where the mirror takes a place of a part's frame, in the frame of the image: shift + the place with axis reversed.
struct PlaceImage {
    int axis;
    Vec2 shift;

    double along(int direction, double v) const { return shift[direction] + (direction == axis ? -v : v); }
    PlaceImage inverse() const {
        Vec2 back = -shift;
        back[axis] = shift[axis];
        return {axis, back};
    }
    Vec2 operator()(const Vec2& x) const { return {along(0, x.x()), along(1, x.y())}; }
};

/// Numbers in the image of a part's elements, branches and functions.
struct SpaceImage {
    std::vector<int> element, branch, function;  ///< -1: none
    std::string failure;                         ///< not empty: the grids are no mirror images, and how they differ
};
/// Components of split cells are told apart by where their points are. Cells that hold next to nothing need no image.
SpaceImage space_image(const PartInput& part, const PartInput& image, const PlaceImage& place);

/// Filled fractions that rounding may leave on one side only, where an edge touches a grid line.
inline constexpr double mirrored_sliver = 1e-9;
/// Places that count as mirrored: in units of the part's size.
inline constexpr double mirrored_place = 1e-9;

}  // namespace abut::solver
