// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings whose coordinates are written with a few digits: what that puts beside each other is one.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/geometry/sketch/drawings.hpp"

namespace abut::geometry::sketch_rounded_test {
namespace {

double written(double x, int decimals) {
    const double digits = std::pow(10.0, decimals);
    return std::round(x * digits) / digits;
}

/// Turned about the origin, and written with so many decimals.
Vec2 placed(const Vec2& p, double degrees, int decimals) {
    const double a = degrees * std::numbers::pi / 180;
    return {written(std::cos(a) * p.x() - std::sin(a) * p.y(), decimals),
            written(std::sin(a) * p.x() + std::cos(a) * p.y(), decimals)};
}

/// A line in as many pieces.
void add_line(Entities& to, const Vec2& from, const Vec2& end, int pieces, double degrees, int decimals) {
    for (int k = 0; k < pieces; ++k)
        to.push_back(drawn_line(placed(from + (end - from) * k / pieces, degrees, decimals),
                                placed(from + (end - from) * (k + 1) / pieces, degrees, decimals),
                                "e" + std::to_string(to.size())));
}

/// Parts side by side, each drawn whole, some of their edges in pieces.
TEST(SketchRounded, PartsSideBySideShareWhatTheirDigitsPutBesideEachOther) {
    std::mt19937 random(7);
    for (const double degrees : {0.0, 13.0, 30.0, 45.0, 77.0})
        for (const int decimals : {2, 3, 4, 8})
            for (int seed = 0; seed < 5; ++seed) {
                Entities lines;
                const std::vector<Box2> boxes{
                    {{0, 0}, {37, 60}}, {{37, 0}, {100, 22}}, {{37, 22}, {71, 60}}, {{71, 22}, {100, 60}}};
                for (const Box2& b : boxes) {
                    const std::array<Vec2, 5> corner{b.min, {b.max.x(), b.min.y()}, b.max, {b.min.x(), b.max.y()}, b.min};
                    for (std::size_t k = 0; k < 4; ++k)
                        add_line(lines, corner[k], corner[k + 1], 1 + static_cast<int>(random() % 3), degrees, decimals);
                }
                const SketchParts sketch = parts_by(lines, PartsBy::loop);
                EXPECT_TRUE(sketch.problems.empty()) << degrees << " " << decimals;
                ASSERT_EQ(sketch.parts.size(), boxes.size()) << degrees << " " << decimals;
                EXPECT_NEAR(total_area(sketch), 6000, 2) << degrees << " " << decimals;
            }
}

TEST(SketchRounded, FacetsOfACircleAreTheCircle) {
    for (const int facets : {24, 36, 48, 60, 90, 120, 180, 360, 720})
        for (const int decimals : {3, 4, 5, 9}) {
            std::vector<Vec2> corners;
            for (int k = 0; k < facets; ++k) {
                const double a = 0.1 + 2 * std::numbers::pi * k / facets;
                corners.push_back(placed(9.98 * Vec2(std::cos(a), std::sin(a)), 0, decimals));
            }
            const SketchParts sketch = parts_by(drawn_polygon(corners, "f"), PartsBy::loop);
            ASSERT_EQ(sketch.parts.size(), 1u);
            ASSERT_EQ(sketch.parts[0].edges.size(), 1u) << facets << " " << decimals;
            EXPECT_NEAR(std::get<Arc>(sketch.parts[0].edges[0].curve).radius, 9.98, 1e-8) << facets << " " << decimals;
        }
}

/// Along an axis rounding puts nothing beside each other: what is drawn apart by one digit is a clearance.
TEST(SketchRounded, AClearanceOfOneDigitStays) {
    const Entities lines =
        drawn_rectangle({-30.125, -30}, {30, 30}, "f") + drawn_rectangle({-10, -10}, {10, 10}, "h") +
        Entities{drawn_line({-9.999, -9.999}, {9.999, -9.999}, "p0"), drawn_line({9.999, -9.999}, {9.999, 9.999}, "p1"),
                 drawn_line({9.999, 9.999}, {-9.999, 9.999}, "p2"), drawn_line({-9.999, 9.999}, {-9.999, -9.999}, "p3")};
    const SketchParts sketch = parts_by(lines, PartsBy::loop);
    ASSERT_EQ(sketch.parts.size(), 2u);
    EXPECT_NEAR(area(sketch.parts[1]), std::pow(2 * 9.999, 2), 1e-9);
}

/// Ends a little off each other at random, within the joining tolerance: lines that cross no longer do when these are one,
/// which is said.
TEST(SketchRounded, LinesThatCrossForAHairAreOneAndThatIsSaid) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> off(-2e-4, 2e-4);
    int n_said = 0, n_read = 0;
    for (int seed = 0; seed < 20; ++seed) {
        const auto near = [&](double x, double y) { return Vec2(x + off(random), y + off(random)); };
        Entities lines;
        for (const auto& corners : {std::vector<Vec2>{{0, 0}, {37, 0}, {37, 60}, {0, 60}},
                                    std::vector<Vec2>{{37, 0}, {100, 0}, {100, 22}, {71, 22}, {37, 22}},
                                    std::vector<Vec2>{{37, 22}, {71, 22}, {71, 60}, {37, 60}, {37, 40}},
                                    std::vector<Vec2>{{71, 22}, {100, 22}, {100, 60}, {71, 60}}}) {
            std::vector<Vec2> drawn;
            for (const Vec2& c : corners) drawn.push_back(near(c.x(), c.y()));
            lines = lines + drawn_polygon(drawn, "p" + std::to_string(lines.size()));
        }
        const SketchParts sketch = parts_by(lines, PartsBy::loop);
        if (!sketch.problems.empty()) continue;
        ++n_read;
        EXPECT_EQ(sketch.parts.size(), 4u) << seed;
        EXPECT_NEAR(total_area(sketch), 6000, 0.1) << seed;
        n_said += std::any_of(sketch.warnings.begin(), sketch.warnings.end(),
                              [](const SketchProblem& w) { return says(w.what, "apart are taken as one"); });
    }
    EXPECT_GT(n_said, 0);
    EXPECT_GT(n_read, 15);
}

}  // namespace
}  // namespace abut::geometry::sketch_rounded_test
