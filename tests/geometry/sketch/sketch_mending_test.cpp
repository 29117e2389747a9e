// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps, ends on other entities, overlaps, clearances, facets: what is mended, and what is not.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/geometry/sketch/drawings.hpp"

namespace abut::geometry::sketch_mending_test {
namespace {

constexpr double pi = std::numbers::pi;

bool has_repair(const SketchParts& sketch, const std::string& piece) {
    return std::any_of(sketch.repairs.begin(), sketch.repairs.end(), [&](const Repair& r) { return says(r.what, piece); });
}

// ---- clearances ----

/// A square hole with a square pin in it, `clearance` all around, each with a gap in one corner, the two next to each other.
Entities pin_and_hole(double clearance, double gap) {
    const double a = 10, b = 10 - clearance;
    return drawn_rectangle({-30, -30}, {30, 30}, "f") +
           Entities{drawn_line({-a, -a}, {a - gap, -a}, "h0"), drawn_line({a, -a}, {a, a}, "h1"),
                    drawn_line({a, a}, {-a, a}, "h2"),         drawn_line({-a, a}, {-a, -a}, "h3"),
                    drawn_line({-b, -b}, {b - gap, -b}, "p0"), drawn_line({b, -b}, {b, b}, "p1"),
                    drawn_line({b, b}, {-b, b}, "p2"),         drawn_line({-b, b}, {-b, -b}, "p3")};
}

TEST(SketchMending, EndsAreNotJoinedAcrossAClearance) {
    // by loop all of it is one group: frame, hole and pin; the tolerance of 0.05 is more than the clearance
    for (const double gap : {0.0, 1e-3, 0.005, 0.012, 0.0149})
        for (const double clearance : {0.04, 0.02, 0.015}) {
            const SketchParts sketch = parts_by(pin_and_hole(clearance, gap), PartsBy::loop, 0.05);
            EXPECT_TRUE(sketch.problems.empty()) << gap << " " << clearance;
            ASSERT_EQ(sketch.parts.size(), 2u) << gap << " " << clearance;
            EXPECT_NEAR(area(sketch.parts[0]), 3600 - 400, 1e-9);
            EXPECT_NEAR(area(sketch.parts[1]), 4 * (10 - clearance) * (10 - clearance), 1e-9);
            EXPECT_EQ(sketch.repairs.size(), gap > 0 ? 2u : 0u);
        }
}

TEST(SketchMending, GapsWiderThanTheClearanceAreReportedOrClosedAsMeant) {
    int n_reported = 0, n_closed = 0;
    for (double clearance = 0.004; clearance < 0.1; clearance *= 1.3)
        for (double gap = clearance; gap < 0.3; gap *= 1.2) {
            const SketchParts sketch = parts_by(pin_and_hole(clearance, gap), PartsBy::loop, 0.05);
            (sketch.problems.empty() ? n_closed : n_reported)++;
            if (!sketch.problems.empty()) continue;
            ASSERT_EQ(sketch.parts.size(), 2u) << gap << " " << clearance;
            EXPECT_NEAR(area(sketch.parts[0]), 3600 - 400, 1e-9) << gap << " " << clearance;
            EXPECT_NEAR(area(sketch.parts[1]), 4 * (10 - clearance) * (10 - clearance), 1e-9) << gap << " " << clearance;
        }
    EXPECT_GT(n_reported, 20);
    EXPECT_GT(n_closed, 5);
}

TEST(SketchMending, ClosesWhatTheToleranceAllows) {
    const double diagonal = 60 * std::sqrt(2.0);
    for (const double gap : {0.5, 0.99, 1.01, 3.0}) {
        const SketchParts sketch = parts_by(pin_and_hole(1, gap * joining_fraction * diagonal), PartsBy::loop);
        EXPECT_EQ(sketch.problems.empty(), gap < 1) << gap;
        EXPECT_EQ(sketch.parts.size(), gap < 1 ? 2u : 1u) << gap;
        EXPECT_NEAR(sketch.tolerance, joining_fraction * diagonal, 1e-15);
    }
}

TEST(SketchMending, CirclesInNarrowClearancesStayApart) {
    for (const double clearance : {1e-2, 1e-3, 5e-4}) {
        const SketchParts sketch =
            parts_by(drawn_rectangle({-30, -30}, {30, 30}, "f") +
                         Entities{drawn_circle({0, 0}, 10, "h"), drawn_circle({0, 0}, 10 - clearance, "p")},
                     PartsBy::loop);
        ASSERT_EQ(sketch.parts.size(), 2u) << clearance;
        EXPECT_EQ(count_holes(sketch.parts[0]), 1);
        EXPECT_NEAR(area(sketch.parts[1]), pi * (10 - clearance) * (10 - clearance), 1e-9);
        EXPECT_TRUE(sketch.repairs.empty());
    }
}

// ---- ends on other entities, overlaps ----

TEST(SketchMending, OverlapsOfSidesAreCutOut) {
    // the bottom side in two pieces that overlap, and the right one of two that overrun the corner
    const Entities drawing{drawn_line({0, 0}, {7, 0}, "a"),    drawn_line({4, 0}, {10, 0}, "b"),
                           drawn_line({10, 0}, {10, 6}, "c"),  drawn_line({10, 10}, {10, 5}, "d"),
                           drawn_line({10, 10}, {0, 10}, "e"), drawn_line({0, 10}, {0, 0}, "f")};
    for (const PartsBy way : {PartsBy::layer, PartsBy::loop}) {
        const SketchParts sketch = parts_by(drawing, way);
        EXPECT_TRUE(sketch.problems.empty());
        ASSERT_EQ(sketch.parts.size(), 1u);
        EXPECT_NEAR(area(sketch.parts[0]), 100, 1e-12);
        EXPECT_NEAR(perimeter(sketch.parts[0]), 40, 1e-12);
        expect_sound(sketch.parts[0]);
        EXPECT_TRUE(has_repair(sketch, "LINE a cut where b ends on it"));
        EXPECT_TRUE(has_repair(sketch, "removed: it lies on"));
    }
}

TEST(SketchMending, PiecesInARowOnASideAreRemoved) {
    Entities drawing = drawn_rectangle({0, 0}, {100, 10}, "a");
    for (int k = 0; k < 40; ++k) drawing.push_back(drawn_line({2.0 * k + 3, 0}, {2.0 * k + 5, 0}, "s" + std::to_string(k)));
    const SketchParts sketch = parts_by(drawing, PartsBy::layer);
    EXPECT_TRUE(sketch.problems.empty());
    ASSERT_EQ(sketch.parts.size(), 1u);
    EXPECT_EQ(sketch.parts[0].edges.size(), 4u);
    EXPECT_EQ(sketch.repairs.size(), 40u);
}

TEST(SketchMending, NothingIsRemovedAcrossParts) {
    const SketchParts sketch =
        parts_by(drawn_rectangle({0, 0}, {10, 10}, "a", "A") + drawn_rectangle({10, 0}, {20, 10}, "b", "B"), PartsBy::layer);
    EXPECT_EQ(sketch.parts.size(), 2u);
    EXPECT_TRUE(sketch.repairs.empty());
    for (const Part& part : sketch.parts) EXPECT_EQ(part.edges.size(), 4u);
}

TEST(SketchMending, OutlinesWithoutAreaAreReported) {
    const SketchParts sketch = parts_by(
        {drawn_line({0, 0}, {7, 1}, "a"), drawn_line({7, 1}, {14, 2}, "b"), drawn_line({14, 2}, {0, 0}, "c")}, PartsBy::loop);
    EXPECT_TRUE(sketch.parts.empty());
    ASSERT_EQ(sketch.problems.size(), 1u);
    EXPECT_EQ(sketch.problems[0].what, "the outline that begins with LINE a on layer 0 encloses no area");
}

TEST(SketchMending, SpursAndCutsOfPolylinesGo) {
    // one polyline around a plate, in to a hole, around it, and back: as cutters and simple exporters write it
    const std::vector<Vec2> corners{{0, 0}, {20, 0}, {20, 20}, {0, 20}, {0, 10}, {5, 10}, {10, 14}, {10, 6}, {5, 10}, {0, 10}};
    Entities drawing;
    for (std::size_t k = 0; k < corners.size(); ++k)
        drawing.push_back(drawn_line(corners[k], corners[(k + 1) % corners.size()], "h1." + std::to_string(k)));
    const SketchParts sketch = parts_by(drawing, PartsBy::layer);
    EXPECT_TRUE(sketch.problems.empty());
    ASSERT_EQ(sketch.parts.size(), 1u);
    EXPECT_EQ(count_holes(sketch.parts[0]), 1);
    EXPECT_NEAR(area(sketch.parts[0]), 400 - 20, 1e-12);
    EXPECT_TRUE(has_repair(sketch, "LINE h1.4 and h1.8 removed: there and back they bound nothing"));
}

TEST(SketchMending, ACircleIsCutWhereLinesEndOnIt) {
    // a disc with a strap: the lines end on the circle, which is drawn all around
    const double y = 3, x = std::sqrt(100 - y * y);
    const Entities drawing{drawn_circle({0, 0}, 10, "c"), drawn_line({x, y}, {30, y}, "a"), drawn_line({30, y}, {30, -y}, "b"),
                           drawn_line({30, -y}, {x, -y}, "d")};
    const SketchParts sketch = parts_by(drawing, PartsBy::loop);
    EXPECT_TRUE(sketch.problems.empty());
    ASSERT_EQ(sketch.parts.size(), 2u);
    EXPECT_NEAR(area(sketch.parts[0]), 100 * pi, 1e-9);
    const double cap = 100 * std::asin(0.3) - x * y;  // of the disc beyond x
    EXPECT_NEAR(area(sketch.parts[1]), 2 * y * (30 - x) - cap, 1e-9);
    double pieces = 0;  // of the circle, counted from angle 0
    for (const Edge& edge : sketch.parts[0].edges) {
        EXPECT_EQ(edge.source, "c");
        pieces += length(edge.curve);
        const double begin = edge.along_source ? 0 : 1;
        const Vec2 p = point(edge.curve, begin);
        EXPECT_NEAR(std::remainder(edge.source_begin - 10 * std::atan2(p.y(), p.x()), 20 * pi), 0, 1e-9) << edge.name;
    }
    EXPECT_NEAR(pieces, 20 * pi, 1e-9);
}

TEST(SketchMending, CirclesOfConstructionAreLeftOut) {
    const Entities plate = drawn_rectangle({-20, -10}, {20, 10}, "a");
    const SketchParts sketch =
        parts_by(plate + Entities{drawn_circle({0, 0}, 5, "b"), drawn_circle({0, 0}, 15, "c")}, PartsBy::layer);
    EXPECT_TRUE(sketch.problems.empty());
    ASSERT_EQ(sketch.parts.size(), 1u);
    EXPECT_NEAR(area(sketch.parts[0]), 800 - 25 * pi, 1e-9);
    ASSERT_EQ(sketch.warnings.size(), 1u);
    EXPECT_EQ(sketch.warnings[0].what,
              "ARC c on layer 0 left out: it crosses the outline of its layer, as circles of construction do");
    // where a layer does not stand for a part, it may be one: a dowel, a roller
    const SketchParts dowel = parts_by(plate + Entities{drawn_circle({0, 10}, 5, "c")}, PartsBy::loop);
    EXPECT_TRUE(dowel.problems.empty());
    EXPECT_EQ(dowel.parts.size(), 2u);
    ASSERT_EQ(dowel.warnings.size(), 1u);
    EXPECT_TRUE(says(dowel.warnings[0].what, "both are taken as parts that overlap")) << dowel.warnings[0].what;
    // two circles that cross are none: which of them is meant cannot be told
    const SketchParts circles = parts_by({drawn_circle({0, 0}, 5, "b"), drawn_circle({6, 0}, 5, "c")}, PartsBy::layer);
    EXPECT_EQ(circles.problems.size(), 1u);
    EXPECT_TRUE(circles.parts.empty());
}

TEST(SketchMending, CrossingsAreFoundWhateverTheDirection) {
    const std::vector<Vec2> plate{{0, 0}, {20, 0}, {20, 10}, {0, 10}}, bar{{17, 3}, {25, 4}, {24, 7}, {16, 6}};
    for (int which = 0; which < 4; ++which) {
        std::vector<Vec2> a = plate, b = bar;
        if (which % 2 == 1) std::reverse(a.begin(), a.end());
        if (which / 2 == 1) std::reverse(b.begin(), b.end());
        for (const Entities& drawing :
             {drawn_polygon(a, "a") + drawn_polygon(b, "b"), drawn_polygon(b, "b") + drawn_polygon(a, "a")}) {
            const SketchParts sketch = parts_by(drawing, PartsBy::loop);
            EXPECT_EQ(sketch.problems.size(), 1u) << which;
            EXPECT_TRUE(sketch.parts.empty()) << which;
        }
    }
}

// ---- facets and splines ----

Entities facetted(const Vec2& center, double radius, double from, double sweep, int n, const std::string& prefix) {
    Entities facets;
    const auto at = [&](int k) -> Vec2 {
        const double angle = from + sweep * k / n;
        return center + radius * Vec2(std::cos(angle), std::sin(angle));
    };
    for (int k = 0; k < n; ++k) facets.push_back(drawn_line(at(k), at(k + 1), prefix + std::to_string(k)));
    return facets;
}

TEST(SketchMending, FacetsBecomeArcs) {
    std::mt19937 random(7);
    for (const int n : {24, 36, 64, 180}) {
        // a slot of two facetted half circles, and a facetted bore; in any order and direction
        Entities drawing = facetted({10, 0}, 5, -pi / 2, pi, n / 2, "r") + facetted({-10, 0}, 5, pi / 2, pi, n / 2, "l") +
                           facetted({10, 0}, 2, 0.1, 2 * pi, n, "b") +
                           Entities{drawn_line({-10, -5}, {10, -5}, "s0"), drawn_line({10, 5}, {-10, 5}, "s1")};
        shuffle_and_turn(drawing, random);
        const SketchParts sketch = parts_by(drawing, PartsBy::layer);
        ASSERT_EQ(sketch.parts.size(), 1u) << n;
        EXPECT_EQ(sketch.parts[0].edges.size(), 5u) << n;
        EXPECT_NEAR(area(sketch.parts[0]), 200 + 25 * pi - 4 * pi, 1e-9) << n;
        EXPECT_EQ(sketch.repairs.size(), 3u) << n;
        EXPECT_TRUE(has_repair(sketch, std::to_string(n) + " lines recognised as a circle of radius 2, b"));
        EXPECT_TRUE(has_repair(sketch, std::to_string(n / 2) + " lines recognised as an arc of radius 5, "));
        for (const Repair& repair : sketch.repairs) EXPECT_LE(repair.size, 1e-12);
        expect_sound(sketch.parts[0]);

        SketchOptions as_drawn;
        as_drawn.recognise_arcs = false;
        const SketchParts facets = parts_of(drawing_of(drawing), as_drawn);
        EXPECT_EQ(facets.parts[0].edges.size(), static_cast<std::size_t>(2 * n + 2));
        EXPECT_TRUE(facets.repairs.empty());
    }
}

TEST(SketchMending, AnArcHasTheNameOfItsFirstFacet) {
    const SketchParts sketch =
        parts_by(facetted({0, 0}, 5, 0, pi, 32, "r") + Entities{drawn_line({-5, 0}, {5, 0}, "s")}, PartsBy::layer);
    ASSERT_EQ(sketch.parts[0].edges.size(), 2u);
    EXPECT_EQ(sketch.parts[0].edges[0].name, "r0");
    EXPECT_TRUE(sketch.parts[0].edges[0].along_source);
    EXPECT_EQ(sketch.repairs[0].what, "32 lines recognised as an arc of radius 5, r0...r31");
    EXPECT_LE((sketch.repairs[0].at - Vec2(0, 5)).norm(), 1e-12);
}

TEST(SketchMending, PolygonsStayPolygons) {
    for (const int n : {3, 4, 6, 8, 12, 20}) {
        const SketchParts sketch = parts_by(facetted({0, 0}, 5, 0.2, 2 * pi, n, "f"), PartsBy::layer);
        ASSERT_EQ(sketch.parts.size(), 1u);
        EXPECT_EQ(sketch.parts[0].edges.size(), static_cast<std::size_t>(n));
        EXPECT_TRUE(sketch.repairs.empty());
    }
}

// ---- independence ----

TEST(SketchMending, FarCoordinatesGiveTheSameParts) {
    const Entities drawing =
        pin_and_hole(0.05, 1e-3) + facetted({50, 0}, 5, 0, 2 * pi, 64, "c") +
        Entities{drawn_line({30, 5}, {40, 5}, "t0"), drawn_line({40, 5}, {40, 15}, "t1"), drawn_line({40, 15}, {30, 15}, "t2")};
    const SketchParts near = parts_by(drawing, PartsBy::loop);
    ASSERT_EQ(near.parts.size(), 4u);
    EXPECT_TRUE(near.problems.empty());
    for (const double far : {1e3, 1e6, 1e8}) {
        Entities moved = drawing;
        for (SketchEntity& entity : moved) entity.curve = transformed(entity.curve, 1, 0, {far, -2 * far});
        const SketchParts sketch = parts_by(moved, PartsBy::loop);
        EXPECT_TRUE(sketch.problems.empty());
        ASSERT_EQ(sketch.parts.size(), near.parts.size()) << far;
        EXPECT_EQ(part_names(sketch), part_names(near));
        EXPECT_EQ(sketch.repairs.size(), near.repairs.size());
        for (std::size_t k = 0; k < near.parts.size(); ++k) {
            // a unit in the last place of the coordinates, times the perimeter
            EXPECT_NEAR(area(sketch.parts[k]), area(near.parts[k]), 400 * far * 4.5e-16 + 1e-9) << far;
            EXPECT_LE((centroid(sketch.parts[k]) - Vec2(far, -2 * far) - centroid(near.parts[k])).norm(), far * 1e-14 + 1e-9);
        }
    }
}

TEST(SketchMending, TheSameInputGivesTheSameBits) {
    const Entities drawing = pin_and_hole(0.05, 1e-3) + facetted({50, 0}, 5, 0, 2 * pi, 64, "c");
    const SketchParts a = parts_by(drawing, PartsBy::loop), b = parts_by(drawing, PartsBy::loop);
    ASSERT_EQ(a.parts.size(), b.parts.size());
    for (std::size_t k = 0; k < a.parts.size(); ++k)
        for (std::size_t e = 0; e < a.parts[k].edges.size(); ++e)
            for (const double t : {0.0, 0.3, 1.0})
                EXPECT_EQ(point(a.parts[k].edges[e].curve, t), point(b.parts[k].edges[e].curve, t));
}

// ---- anything at all ----

/// Lines, arcs and circles between the points of a coarse grid: full of coincidences, crossings, branchings and loose ends.
Entities soup(std::mt19937& random) {
    const auto anywhere = [&] { return Vec2(static_cast<double>(random() % 5), static_cast<double>(random() % 5)); };
    Entities entities;
    const int n = 1 + static_cast<int>(random() % 30);
    for (int k = 0; k < n; ++k) {
        const std::string name = (random() % 3 == 0 ? "h" + std::to_string(k / 4) + "." : "l") + std::to_string(k);
        const Vec2 a = anywhere();
        switch (random() % 6) {
            case 0:
                entities.push_back(drawn_circle(a, 0.5 * static_cast<double>(random() % 4), name));
                break;
            case 1:
                entities.push_back(
                    drawn(Arc{a, 1.0 + static_cast<double>(random() % 2), pi / 2 * static_cast<double>(random() % 4),
                              pi / 2 * static_cast<double>(1 + random() % 4)},
                          name));
                break;
            case 2:
                entities = std::move(entities) + drawn_rectangle(a, a + anywhere() + Vec2(1, 1), name + "s");
                break;
            default:
                entities.push_back(drawn_line(a, anywhere(), name));
        }
    }
    return entities;
}

void check_soups(int n_cases, unsigned seed) {
    std::mt19937 random(seed);
    int n_parts = 0, n_problems = 0;
    for (int trial = 0; trial < n_cases; ++trial) {
        const Entities entities = soup(random);
        for (const PartsBy way : {PartsBy::automatic, PartsBy::loop}) {
            const SketchParts sketch = parts_by(entities, way, random() % 4 == 0 ? 0.3 : 0.0);
            n_parts += static_cast<int>(sketch.parts.size());
            n_problems += static_cast<int>(sketch.problems.size());
            ASSERT_EQ(sketch.layers.size(), sketch.parts.size());
            for (const Part& part : sketch.parts) {
                expect_sound(part, 1e-9);
                EXPECT_GT(area(part), 0);
            }
            ASSERT_FALSE(testing::Test::HasFailure()) << "case " << trial;
        }
    }
    EXPECT_GT(n_parts, n_cases / 2);
    EXPECT_GT(n_problems, n_cases / 2);
}

TEST(SketchMending, PartsAreSoundWhateverIsDrawn) {
    check_soups(500, 1);
}

TEST(LongSketchMending, PartsAreSoundWhateverIsDrawn) {
    check_soups(20000, 2);
}

TEST(SketchMending, ManyEntitiesTakeLittleTime) {
    // 30 000 entities in all: what is quadratic in any step takes minutes
    Entities drawing = facetted({0, 0}, 1000, 0, 2 * pi, 10000, "c");
    for (int k = 0; k < 5000; ++k) {
        const Vec2 corner(3.0 * (k % 100) - 150, 3.0 * (k / 100) - 75);
        drawing = std::move(drawing) +
                  drawn_rectangle(corner, corner + Vec2(2, 2), "r" + std::to_string(k) + "s", "L" + std::to_string(k));
    }
    EXPECT_EQ(parts_by(drawing, PartsBy::loop).parts.size(), 1u);
    EXPECT_EQ(parts_by(drawing, PartsBy::layer).parts.size(), 5001u);
}

}  // namespace
}  // namespace abut::geometry::sketch_mending_test
