// SPDX-License-Identifier: GPL-3.0-or-later
// HATCH records: where there is material, and how it looks.
#include <gtest/gtest.h>

#include "tests/geometry/dxf/dxf_text.hpp"

namespace abut::geometry::dxf_hatches_test {
namespace {

/// A hatch over the square from 0 to 10.
std::string dxf_hatch(const std::string& layer, double angle, double scale, const std::string& more = "") {
    return dxf_record("HATCH", "", layer, {{10, 0}, {20, 0}, {30, 0}}) + more + "2\nANSI31\n" +
           dxf_groups({{70, 0}, {71, 0},    {91, 1},     {92, 3},     {72, 0},  {73, 1}, {93, 4},          {10, 0},
                       {20, 0}, {10, 10},   {20, 0},     {10, 10},    {20, 10}, {10, 0}, {20, 10},         {97, 0},
                       {75, 0}, {76, 1},    {52, angle}, {41, scale}, {77, 0},  {78, 1}, {53, angle + 45}, {43, 0},
                       {44, 0}, {45, -2.2}, {46, 2.2},   {79, 0},     {98, 0}});
}

TEST(DxfHatches, HaveTheirLook) {
    const Drawing drawing =
        read_drawing(dxf_file(dxf_hatch("H", 30, 2) + dxf_hatch("H", 30, 2, dxf_groups({{62, 3}})) +
                              dxf_hatch("H", 30, 2, dxf_groups({{420, 255}})) + dxf_line("1", "A", 0, 0, 1, 0)));
    ASSERT_EQ(drawing.hatches.size(), 3u);
    const HatchLook& look = drawing.hatches[0].look;
    EXPECT_EQ(look.pattern, "ANSI31");
    EXPECT_EQ(look.angle, 30);
    EXPECT_EQ(look.scale, 2);
    EXPECT_EQ(look.layer, "H");
    EXPECT_EQ(look.color, 7);
    EXPECT_EQ(drawing.hatches[1].look.color, 3);
    EXPECT_GT(drawing.hatches[2].look.color, 256);
    ASSERT_EQ(drawing.hatches[0].loops.size(), 1u);
    EXPECT_EQ(drawing.hatches[0].loops[0].size(), 4u);
}

TEST(DxfHatches, TurnAndGrowWithTheirBlock) {
    const Drawing drawing = read_drawing(
        dxf_file(dxf_insert("", "C", "B", 0, 0, {{41, 3}, {42, 3}, {50, 20}}) + dxf_insert("", "C", "B", 100, 0, {{41, -1}}),
                 dxf_section("BLOCKS", dxf_block("B", 0, 0, dxf_hatch("0", 30, 2) + dxf_line("1", "0", 0, 0, 1, 0)))));
    ASSERT_EQ(drawing.hatches.size(), 2u);
    EXPECT_NEAR(drawing.hatches[0].look.angle, 50, 1e-9);
    EXPECT_NEAR(drawing.hatches[0].look.scale, 6, 1e-9);
    EXPECT_EQ(drawing.hatches[0].look.layer, "C");
    EXPECT_NEAR(drawing.hatches[1].look.angle, 150, 1e-9);
    EXPECT_NEAR(drawing.hatches[1].look.scale, 2, 1e-9);
}

TEST(DxfHatches, InsertionsAreListedByWhatTheyStandIn) {
    const Drawing drawing = read_drawing(
        dxf_file(dxf_insert("", "C", "OUTER", 0, 0) + dxf_insert("", "C", "INNER", 9, 0) + dxf_line("2", "A", 0, 0, 1, 0),
                 dxf_section("BLOCKS", dxf_block("INNER", 0, 0, dxf_line("1", "0", 0, 0, 1, 0)) +
                                           dxf_block("OUTER", 0, 0, dxf_insert("", "0", "INNER", 1, 1)))));
    ASSERT_EQ(drawing.insertions.size(), 3u);
    EXPECT_EQ(drawing.insertions[1].block, "INNER");
    EXPECT_EQ(drawing.insertions[1].around, 0);
    EXPECT_EQ(drawing.insertions[2].around, -1);
    ASSERT_EQ(drawing.entities.size(), 3u);
    EXPECT_EQ(drawing.entities[0].insertion, 1);
    EXPECT_EQ(drawing.entities[1].insertion, 2);
    EXPECT_EQ(drawing.entities[2].insertion, -1);
}

}  // namespace
}  // namespace abut::geometry::dxf_hatches_test
