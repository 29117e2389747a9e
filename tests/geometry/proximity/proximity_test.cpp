// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/proximity/proximity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/curves/elliptic_arc.hpp"
#include "geometry/curves/spline_shape.hpp"

namespace proximity_test {

namespace {

using namespace abut::geometry;
constexpr double pi = std::numbers::pi;

Part part_of(const std::vector<Curve>& curves) {
    Part part;
    part.loops.emplace_back();
    for (const Curve& curve : curves) {
        part.loops[0].edges.push_back(static_cast<int>(part.edges.size()));
        part.edges.push_back({curve, "e" + std::to_string(part.edges.size()), ""});
    }
    return part;
}
Part polygon(const std::vector<Vec2>& points) {
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < points.size(); ++i) curves.push_back(Segment{points[i], points[(i + 1) % points.size()]});
    return part_of(curves);
}
/// Edges 0 bottom, 1 right, 2 top, 3 left.
Part box(double x0, double y0, double x1, double y1) {
    return polygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

/// "edge1-edge2" of each candidate.
std::vector<std::string> pairs(const std::vector<Part>& parts, double distance) {
    std::vector<std::string> found;
    for (const EdgePairCandidate& c : close_edge_pairs(parts, distance))
        found.push_back(std::to_string(c.edge1) + "-" + std::to_string(c.edge2));
    return found;
}
using Pairs = std::vector<std::string>;

class Dice {
public:
    explicit Dice(unsigned seed) : random_(seed) {}
    double between(double a, double b) { return a + (b - a) * (static_cast<double>(random_()) / 4294967296.0); }
    int upto(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n + 1)); }

private:
    std::mt19937 random_;
};

/// A curve of any kind from a to b.
Curve random_curve(Dice& dice, const Vec2& a, const Vec2& b) {
    const Vec2 d = b - a, n = left_of(d);
    switch (dice.upto(6)) {
        case 0:
        case 1:
            return Segment{a, b};
        case 2:
        case 3: {
            const double sweep = dice.between(0.3, 2.5) * (dice.upto(1) ? 1 : -1);
            const Vec2 center = 0.5 * (a + b) + n / (2 * std::tan(sweep / 2));
            return Arc{center, (a - center).norm(), std::atan2(a.y() - center.y(), a.x() - center.x()), sweep};
        }
        case 4:
            return from_conjugate(0.5 * (a + b), -0.5 * d, dice.between(-0.6, 0.6) * n + 1e-3 * n, 0, pi);
        case 5:
            return bezier_curve({a, a + 0.3 * d + dice.between(-0.6, 0.6) * n, a + 0.7 * d + dice.between(-0.6, 0.6) * n, b},
                                {});
        default:
            return bezier_curve({a, 0.5 * (a + b) + dice.between(-0.6, 0.6) * n, b}, {1, dice.between(0.4, 3), 1});
    }
}

/// A star-like outline of mixed edges.
Part random_part(Dice& dice, const Vec2& center, int n) {
    std::vector<Vec2> points;
    for (int k = 0; k < n; ++k) {
        const double angle = 2 * pi * k / n + dice.between(0, 0.5);
        points.push_back(center + dice.between(0.6, 1.2) * Vec2(std::cos(angle), std::sin(angle)));
    }
    std::vector<Curve> curves;
    for (std::size_t k = 0; k < points.size(); ++k)
        curves.push_back(random_curve(dice, points[k], points[(k + 1) % points.size()]));
    return part_of(curves);
}

std::vector<Part> random_scene(unsigned seed) {
    Dice dice(seed);
    std::vector<Part> parts;
    const int n = 2 + (dice.upto(3) == 0);
    for (int p = 0; p < n; ++p)
        parts.push_back(random_part(dice, {1.9 * p + dice.between(-0.3, 0.3), dice.between(-0.8, 0.8)}, 3));
    return parts;
}

std::vector<EdgePairCandidate> by_brute_force(const std::vector<Part>& parts, double distance) {
    std::vector<EdgePairCandidate> found;
    for (std::size_t p1 = 0; p1 < parts.size(); ++p1)
        for (std::size_t p2 = p1 + 1; p2 < parts.size(); ++p2) {
            const EdgeNeighbours n1(parts[p1]), n2(parts[p2]);
            for (std::size_t e1 = 0; e1 < parts[p1].edges.size(); ++e1)
                for (std::size_t e2 = 0; e2 < parts[p2].edges.size(); ++e2) {
                    auto c =
                        close_edge_pair(parts[p1], n1, static_cast<int>(e1), parts[p2], n2, static_cast<int>(e2), distance);
                    if (!c) continue;
                    c->part1 = static_cast<int>(p1);
                    c->part2 = static_cast<int>(p2);
                    found.push_back(*c);
                }
        }
    return found;
}

bool same(const EdgePairCandidate& a, const EdgePairCandidate& b) {
    return a.part1 == b.part1 && a.part2 == b.part2 && a.edge1 == b.edge1 && a.edge2 == b.edge2 && a.t1 == b.t1 &&
           a.t2 == b.t2 && a.x1 == b.x1 && a.x2 == b.x2 && a.distance == b.distance;
}

void expect_same_as_brute_force(unsigned first, unsigned n, int& n_found) {
    for (unsigned seed = first; seed < first + n; ++seed) {
        const std::vector<Part> parts = random_scene(seed);
        const double distance = seed % 3 == 0 ? 0.1 : seed % 3 == 1 ? 0.3 : 1;
        const auto found = close_edge_pairs(parts, distance), expected = by_brute_force(parts, distance);
        ASSERT_TRUE(std::ranges::equal(found, expected, same))
            << "scene " << seed << ": " << found.size() << " of " << expected.size();
        n_found += static_cast<int>(found.size());
    }
}

}  // namespace

TEST(Proximity, SquaresSideBySide) {
    // the facing sides; corner to side and corner to corner, since a corner looks to both of its sides
    EXPECT_EQ(pairs({box(0, 0, 1, 1), box(1.1, 0, 2, 1)}, 0.2), (Pairs{"0-0", "0-3", "1-0", "1-2", "1-3", "2-2", "2-3"}));
    // shifted so far that only parts of the sides face each other
    EXPECT_EQ(pairs({box(0, 0, 1, 1), box(1.1, 0.5, 2, 1.5)}, 0.2), (Pairs{"1-0", "1-3", "2-3"}));
    EXPECT_TRUE(pairs({box(0, 0, 1, 1), box(1.1, 0, 2, 1)}, 0.0999).empty());
    const auto found = close_edge_pairs({box(0, 0, 1, 1), box(1.1, 0.5, 2, 1.5)}, 0.2);
    EXPECT_NEAR(found[1].distance, 0.1, 1e-15);
    EXPECT_EQ(found[1].x1.x(), 1);
    EXPECT_EQ(found[1].x2.x(), 1.1);
}

TEST(Proximity, ACornerThatPointsAtASide) {
    const Part tip = polygon({{0, 0.1}, {1, 1}, {-1, 1}}), floor = box(-5, -1, 5, 0);
    // edge 2 ends and edge 0 begins at the tip
    EXPECT_EQ(pairs({tip, floor}, 0.2), (Pairs{"0-2", "2-2"}));
    // a needle without any angle has the normals of its two sides and everything between: it points down
    const Part needle = polygon({{0, 0.1}, {0, 1}, {0, 0.1}, {0, 1}});
    EXPECT_TRUE(oppose(outward_directions(needle, EdgeNeighbours(needle), 0, 0),
                       outward_directions(floor, EdgeNeighbours(floor), 2, 0.5)));
    // a notch whose inner corner is near a tip: both inner sides, and no direction that the notch does not have
    const Part notched = polygon({{-3, -3}, {3, -3}, {3, 0}, {1, 0}, {0, -1}, {-1, 0}, {-3, 0}});
    const Part in_notch = polygon({{0, -0.9}, {0.5, 1}, {-0.5, 1}});
    EXPECT_EQ(outward_directions(notched, EdgeNeighbours(notched), 3, 1).n_normals, 2);
    EXPECT_EQ(pairs({notched, in_notch}, 0.2), (Pairs{"3-0", "3-2", "4-0", "4-2"}));
}

TEST(Proximity, BackToBackAndPerpendicularDoNotCount) {
    // one box inside the material of the other: the normals look the same way
    EXPECT_TRUE(pairs({box(0, 0, 4, 4), box(0.1, 1, 1, 3)}, 0.2).empty());
    // edges at right angles, far from all corners, under any rotation
    for (double turn = 0; turn < 6; turn += 0.37) {
        const Vec2 u(std::cos(turn), std::sin(turn)), v = left_of(u);
        const Part first = part_of({Segment{-u, u}}), second = part_of({Segment{-v, v}});
        EXPECT_FALSE(close_edge_pair(first, EdgeNeighbours(first), 0, second, EdgeNeighbours(second), 0, 1)) << turn;
    }
}

TEST(Proximity, APinInAHoleAndCrossingOutlines) {
    Part plate = box(-3, -3, 3, 3);
    plate.edges.push_back({Arc{{0, 0}, 1, 0, -2 * pi}, "hole", ""});
    plate.loops.push_back({{4}});
    const auto pin = [](double x, double r) { return part_of({Arc{{x, 0}, r, 0.3, 2 * pi}}); };
    const auto found = close_edge_pairs({plate, pin(0.05, 0.9)}, 0.2);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].edge1, 4);
    EXPECT_NEAR(found[0].distance, 0.05, 1e-15);
    EXPECT_NEAR((found[0].x2 - Vec2(0.95, 0)).norm(), 0, 1e-15);
    EXPECT_TRUE(close_edge_pairs({plate, pin(0, 0.9)}, 0.0999).empty());
    EXPECT_EQ(close_edge_pairs({plate, pin(0, 1)}, 1e-14).size(), 1u);  // an exact fit
    // two discs that cross: at the crossings the normals of the smaller one look along the larger one's or against them
    EXPECT_EQ(close_edge_pairs({pin(0, 1), pin(1.9, 1)}, 0.1).size(), 1u);
    EXPECT_EQ(close_edge_pairs({pin(0, 1), pin(0.2, 1)}, 0.1).size(), 0u);
}

TEST(Proximity, OrderedByPartsThenEdges) {
    const std::vector<Part> parts{box(0, 0, 1, 1), box(1.05, 0, 2, 1), box(0, 1.05, 1, 2), box(1.05, 1.05, 2, 2)};
    const auto found = close_edge_pairs(parts, 0.2);
    const auto key = [](const EdgePairCandidate& c) { return std::vector<int>{c.part1, c.part2, c.edge1, c.edge2}; };
    EXPECT_TRUE(std::ranges::is_sorted(found, {}, key));
    EXPECT_TRUE(std::ranges::any_of(found, [](const auto& c) { return c.part1 == 1 && c.part2 == 2; }));  // diagonally
    EXPECT_TRUE(close_edge_pairs({}, 1).empty());
    EXPECT_TRUE(close_edge_pairs({box(0, 0, 1, 1)}, 10).empty());
}

TEST(Proximity, RandomScenesAreTheSameAsByBruteForce) {
    int n_found = 0;
    expect_same_as_brute_force(1, 300, n_found);
    EXPECT_GT(n_found, 300);
}

TEST(LongProximity, RandomScenesAreTheSameAsByBruteForce) {
    int n_found = 0;
    expect_same_as_brute_force(1000, 10000, n_found);
}

/// The candidates' distances against dense sampling of both curves: none is beaten by more than rounding.
TEST(Proximity, DistancesAreNotBeatenBySampling) {
    constexpr int n = 60;
    for (unsigned seed = 500; seed < 540; ++seed) {
        const std::vector<Part> parts = random_scene(seed);
        for (const EdgePairCandidate& c : close_edge_pairs(parts, 0.5)) {
            const Curve& curve1 = parts[static_cast<std::size_t>(c.part1)].edges[static_cast<std::size_t>(c.edge1)].curve;
            const Curve& curve2 = parts[static_cast<std::size_t>(c.part2)].edges[static_cast<std::size_t>(c.edge2)].curve;
            EXPECT_LE((point(curve1, c.t1) - c.x1).norm(), 1e-15 * 5);
            EXPECT_LE((point(curve2, c.t2) - c.x2).norm(), 1e-15 * 5);
            EXPECT_NEAR((c.x2 - c.x1).norm(), c.distance, 1e-15 * 5);
            double least = std::numeric_limits<double>::infinity();
            for (int i = 0; i <= n; ++i)
                for (int k = 0; k <= n; ++k)
                    least = std::min(least, (point(curve1, i / double{n}) - point(curve2, k / double{n})).norm());
            ASSERT_LE(c.distance, least + 1e-12) << "scene " << seed;
        }
    }
}

/// Brute force over many directions in the cones: three directions of a corner decide.
TEST(Proximity, ThreeDirectionsOfACornerDecide) {
    Dice dice(5);
    int n_opposed = 0;
    for (int run = 0; run < 2000; ++run) {
        const auto corner = [&](double& from, double& to) {
            from = dice.between(0, 2 * pi);
            to = from + dice.between(0.01, pi - 0.01);  // convex: the normal turns left
            const Vec2 u = left_of(Vec2(std::cos(from), std::sin(from))), v = left_of(Vec2(std::cos(to), std::sin(to)));
            return part_of({Segment{-u, {0, 0}}, Segment{{0, 0}, v}, Segment{v, -u}});
        };
        double from1, to1, from2, to2;
        const Part first = corner(from1, to1), second = corner(from2, to2);
        double least = 1;
        constexpr int n = 60;
        for (int i = 0; i <= n; ++i)
            for (int k = 0; k <= n; ++k)
                least = std::min(least, std::cos(from1 + i * (to1 - from1) / n - from2 - k * (to2 - from2) / n));
        if (std::abs(least) < 1e-3) continue;
        const bool opposed = oppose(outward_directions(first, EdgeNeighbours(first), 0, 1),
                                    outward_directions(second, EdgeNeighbours(second), 1, 0));
        ASSERT_EQ(opposed, least < 0) << from1 << " " << to1 << " " << from2 << " " << to2;
        n_opposed += opposed;
    }
    EXPECT_GT(n_opposed, 200);
    EXPECT_LT(n_opposed, 1990);
}

}  // namespace proximity_test
