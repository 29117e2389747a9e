// SPDX-License-Identifier: GPL-3.0-or-later
// Several views of one part on a sheet, and assemblies that only look like them.
#include "geometry/sketch/sketch_views.hpp"

#include <gtest/gtest.h>

#include "tests/geometry/sketch/drawings.hpp"

namespace abut::geometry::sketch_views_test {
namespace {

std::vector<SketchProblem> told(const Entities& entities) {
    const SketchParts sketch = parts_by(entities, PartsBy::loop);
    EXPECT_TRUE(sketch.problems.empty());
    return views_of_one_part(sketch.parts);
}

/// A step, 100 x 60 x 40, from the front.
const Entities front =
    drawn_polygon({{0, 0}, {100, 0}, {100, 30}, {60, 30}, {60, 60}, {0, 60}}, "f") + Entities{drawn_circle({30, 30}, 8, "h")};
const Entities top = drawn_rectangle({0, 90}, {100, 130}, "t"), side = drawn_rectangle({130, 0}, {170, 60}, "s");
/// Something else on the sheet.
const Entities other = drawn_polygon({{200, 100}, {260, 110}, {230, 160}}, "o");

}  // namespace

TEST(SketchViews, FrontTopAndSide) {
    const std::vector<SketchProblem> warnings = told(front + top + side);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].what,
              "0#0 at (50, 30), 0#1 at (50, 110), 0#2 at (150, 30) look like views of one part side by side: their widths and "
              "heights agree as in "
              "a projection; each is taken as a part by itself");
    EXPECT_TRUE(says(warnings[0].hint, R"("parts": {"0#1": "ignore", "0#2": "ignore"})")) << warnings[0].hint;
    // beside other figures, too
    EXPECT_EQ(told(front + other + top + side).size(), 1u);
}

TEST(SketchViews, EdgesThatAreSeenDivideAView) {
    const Entities seen{drawn_line({60, 90}, {60, 130}, "t4"), drawn_line({130, 30}, {170, 30}, "s4")};
    const std::vector<SketchProblem> warnings = told(front + top + side + seen);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_TRUE(says(warnings[0].what, "(2 parts) at (50, 110)")) << warnings[0].what;
}

TEST(SketchViews, TwoViewsAreToldWhereThereIsNothingElse) {
    EXPECT_EQ(told(front + top).size(), 1u);
    EXPECT_EQ(told(front + side).size(), 1u);
    EXPECT_EQ(told(front + top + other).size(), 0u);
}

TEST(SketchViews, LengthsThatDoNotAgreeAreNoViews) {
    EXPECT_EQ(told(front + drawn_rectangle({0, 90}, {100.1, 130}, "t")).size(), 0u);
    EXPECT_EQ(told(front + drawn_rectangle({1, 90}, {101, 130}, "t")).size(), 0u);
    EXPECT_EQ(told(front + other).size(), 0u);
    EXPECT_EQ(told(front).size(), 0u);
    // the top view says 40 deep, the side view 45
    EXPECT_EQ(told(front + top + drawn_rectangle({130, 0}, {175, 60}, "s")).size(), 0u);
    EXPECT_EQ(told(front + drawn_rectangle({0, 90}, {100.001, 130}, "t")).size(), 1u);  // rounding
}

TEST(SketchViews, TheSameOutlineTwice) {
    const Entities plate = drawn_polygon({{0, 0}, {50, 0}, {60, 20}, {0, 30}}, "a"),
                   again = drawn_polygon({{95, 47}, {145, 47}, {155, 67}, {95, 77}}, "b");
    const std::vector<SketchProblem> warnings = told(plate + again);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_TRUE(says(warnings[0].what, "look like one part drawn several times")) << warnings[0].what;
    EXPECT_EQ(told(plate + again + other).size(), 0u);  // cut out of one sheet
    const Entities holed = again + Entities{drawn_circle({110, 60}, 4, "h")};
    EXPECT_EQ(told(plate + holed).size(), 0u);
}

TEST(SketchViews, PartsThatTouchOrComeNearAreAnAssembly) {
    EXPECT_EQ(told(front + drawn_rectangle({0, 60}, {100, 100}, "t")).size(), 0u);
    EXPECT_EQ(told(front + drawn_rectangle({0, 63}, {100, 103}, "t")).size(), 0u);
    EXPECT_EQ(told(drawn_rectangle({0, 0}, {100, 60}, "a") + drawn_rectangle({20, 20}, {80, 40}, "h") +
                   drawn_rectangle({20, 20.5}, {80, 39.5}, "b"))
                  .size(),
              0u);
    // a roller on each end of a beam: one figure
    EXPECT_EQ(
        told(drawn_rectangle({0, 0}, {100, 10}, "a") + Entities{drawn_circle({10, -5}, 5, "r"), drawn_circle({90, -5}, 5, "s")})
            .size(),
        0u);
}

TEST(SketchViews, NestsOfManyPartsAreNone) {
    Entities nest;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 5; ++column)
            nest = nest + drawn_rectangle({40.0 * column, 30.0 * row}, {40.0 * column + 25, 30.0 * row + 15},
                                          "n" + std::to_string(5 * row + column) + "_");
    EXPECT_EQ(told(nest).size(), 0u);
}

}  // namespace abut::geometry::sketch_views_test
