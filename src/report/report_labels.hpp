// SPDX-License-Identifier: GPL-3.0-or-later
// Finds places for the labels of a picture where they cover neither each other nor the marks.
#pragma once
#include <vector>

#include "geometry/curves/vec2.hpp"

namespace abut::report {

using geometry::Box2;
using geometry::Vec2;

/// The places of a picture that are taken.
class LabelPlaces {
public:
    /// frame: labels stay inside it (picture coordinates).
    explicit LabelPlaces(const Box2& frame) : frame_(frame) {}
    /// Blocks a box, or the surroundings of a point, for labels.
    void block(const Box2& box) { taken_.push_back(box); }
    void block(const Vec2& point, double radius);
    /// Takes the middle of a free place of the given size near the anchor, on the preferred side where there is one. Where
    /// nothing is free: the place with the least overlap.
    Vec2 place(const Vec2& anchor, const Vec2& size, const Vec2& preferred);
    /// Takes the place right at the anchor if it is free.
    bool take(const Vec2& middle, const Vec2& size);

private:
    double overlap(const Box2& box) const;
    Box2 frame_;
    std::vector<Box2> taken_;
};

}  // namespace abut::report
