// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/outline.hpp"

#include <gtest/gtest.h>

#include "tests/geometry/sketch/drawings.hpp"

namespace abut::geometry::outline_test {
namespace {

Part part_of(const Entities& entities) {
    const SketchParts sketch = parts_by(entities, PartsBy::layer);
    EXPECT_EQ(sketch.parts.size(), 1u);
    return sketch.parts.at(0);
}

const Part plate = part_of(drawn_rectangle({0, 0}, {10, 8}, "a") + Entities{drawn_circle({5, 4}, 2, "hole")});
const Part pin = part_of({drawn_circle({5, 4}, 2, "pin")});

}  // namespace

TEST(Outline, TheOuterOneHasNoHoles) {
    EXPECT_DOUBLE_EQ(area(outer_outline(plate)), 80);
    EXPECT_EQ(outer_outline(plate).edges.size(), 4u);
}

TEST(Outline, HolesAreNoPieces) {
    EXPECT_EQ(count_pieces(plate), 1);
    Part two = plate;
    const auto first = static_cast<int>(two.edges.size());
    for (const Edge& edge : pin.edges) two.edges.push_back(edge);
    two.loops.push_back({{}});
    for (std::size_t e = 0; e < pin.edges.size(); ++e) two.loops.back().edges.push_back(first + static_cast<int>(e));
    EXPECT_EQ(count_pieces(two), 2);
}

TEST(Outline, WhatLiesInHolesOrMaterialLiesInTheOutline) {
    EXPECT_TRUE(lies_in_outline(pin, plate));
    EXPECT_FALSE(lies_in_outline(plate, pin));
    EXPECT_TRUE(lies_in_outline(part_of({drawn_circle({1.5, 4}, 1, "c")}), plate));
    EXPECT_FALSE(lies_in_outline(part_of({drawn_circle({0.5, 4}, 1, "c")}), plate));
    EXPECT_FALSE(lies_in_outline(part_of({drawn_circle({15, 4}, 1, "c")}), plate));
    // the box alone would not tell: a corner of the L's box is outside of the L
    const Part angle = part_of(drawn_polygon({{0, 0}, {10, 0}, {10, 2}, {2, 2}, {2, 10}, {0, 10}}, "l"));
    EXPECT_FALSE(lies_in_outline(part_of({drawn_circle({8, 8}, 1, "c")}), angle));
}

}  // namespace abut::geometry::outline_test
