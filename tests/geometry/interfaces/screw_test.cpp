// SPDX-License-Identifier: GPL-3.0-or-later
// A table of mechanisms and what they leave, and the same under motion of the whole figure.
#include "geometry/interfaces/screw.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

namespace abut::geometry::screw_test {
namespace {

constexpr double degree = std::numbers::pi / 180;
const Vec2 x{1, 0}, y{0, 1};

struct Case {
    const char* name;
    std::vector<Screw> wrenches;
    int freedom, gruebler, redundant;
    std::vector<Screw> twists;
};

std::vector<Screw> pin(const Vec2& p) {
    return {force_through(p, x), force_through(p, y)};
}

std::vector<Screw> together(std::initializer_list<std::vector<Screw>> lists) {
    std::vector<Screw> all;
    for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
    return all;
}

Screw radial(double angle) {  // from a disc's rim towards its centre
    const Vec2 n(std::cos(angle * degree), std::sin(angle * degree));
    return force_through(n, -n);
}

const std::vector<Case>& cases() {
    static const std::vector<Case> list{
        {"pin at (1, 2)", pin({1, 2}), 1, 1, 0, {{2, -1, 1}}},
        {"slider along x", {force_through({0, 0}, y), {0, 0, 1}}, 1, 1, 0, {{1, 0, 0}}},
        {"block on floor and wall",
         {force_through({0, 0}, y), force_through({2, 0}, y), force_through({0, 1}, x)},
         0,
         0,
         0,
         {}},
        {"pin and slot along x", together({pin({0, 0}), {force_through({1, 0}, y)}}), 0, 0, 0, {}},
        {"pin and useless slot", together({pin({0, 0}), {force_through({1, 0}, x)}}), 1, 0, 1, {{0, 0, 1}}},
        {"two pins", together({pin({0, 0}), pin({1, 0})}), 0, -1, 1, {}},
        {"four pins", together({pin({5, 5}), pin({14, 5}), pin({5, 14}), pin({14, 14})}), 0, -5, 5, {}},
        {"disc in a V and on top", {radial(90), radial(210), radial(330)}, 1, 0, 1, {{0, 0, 1}}},
        {"nothing", {}, 3, 3, 0, {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}},
        {"floor", {force_through({0, 0}, y), force_through({2, 0}, y)}, 1, 1, 0, {{1, 0, 0}}},
        {"one point of a floor", {force_through({3, 0}, y)}, 2, 2, 0, {{0, -3, 1}, {1, 0, 0}}}};
    return list;
}

void expect_equal(const std::vector<Screw>& found, const std::vector<Screw>& expected, const char* name) {
    ASSERT_EQ(found.size(), expected.size()) << name;
    for (std::size_t k = 0; k < found.size(); ++k)
        EXPECT_LT((found[k] - expected[k]).norm(), 1e-12) << name << ": " << found[k].transpose();
}

std::vector<Connection> to_ground(const std::vector<Screw>& wrenches) {
    std::vector<Connection> list;
    for (const Screw& w : wrenches) list.push_back({0, -1, w});
    return list;
}

Vec2 turned(const Vec2& v, double angle) {
    return {std::cos(angle) * v.x() - std::sin(angle) * v.y(), std::sin(angle) * v.x() + std::cos(angle) * v.y()};
}

/// The same wrench on the figure turned about the origin, made larger and then moved.
Screw moved(const Screw& w, double angle, double factor, const Vec2& shift) {
    const Vec2 f = turned({w[0], w[1]}, angle);
    return {f.x(), f.y(), factor * w[2] + cross(shift, f)};
}

}  // namespace

TEST(Screw, MobilityOfTheTable) {
    for (const Case& c : cases()) {
        const Mobility found = mobility(1, to_ground(c.wrenches), {{0.3, 0.2}, 2});
        EXPECT_EQ(found.degrees_of_freedom, c.freedom) << c.name;
        EXPECT_EQ(found.gruebler, c.gruebler) << c.name;
        EXPECT_EQ(found.redundant, c.redundant) << c.name;
        expect_equal(found.free[0], c.twists, c.name);
        expect_equal(twist_space(c.wrenches, {{0.3, 0.2}, 2}), c.twists, c.name);
    }
}

TEST(Screw, CountsStayUnderMotionAndChangeOfUnit) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const Case& c : cases())
        for (const double factor : {1e-3, 1.0, 25.4, 1e6})
            for (int k = 0; k < 20; ++k) {
                const double angle = 3 * unit(random);
                const Vec2 shift = 100 * factor * Vec2(unit(random), unit(random));
                std::vector<Screw> wrenches;
                for (const Screw& w : c.wrenches) wrenches.push_back(moved(w, angle, factor, shift));
                const Vec2 center = shift + turned(factor * Vec2(0.3, 0.2), angle);
                const Mobility found = mobility(1, to_ground(wrenches), {center, 2 * factor});
                EXPECT_EQ(found.degrees_of_freedom, c.freedom) << c.name << " " << factor;
                EXPECT_EQ(found.redundant, c.redundant) << c.name << " " << factor;
            }
}

TEST(Screw, ACoupleCountsWhateverTheUnitOfLength) {
    for (const double size : {1e-9, 1.0, 1e9}) {
        SCOPED_TRACE(size);
        const ScrewScale scale{{0, 0}, size};
        const std::vector<Screw> held = together({pin({0, 0}), {{0, 0, 1}}});
        EXPECT_TRUE(twist_space(held, scale).empty());
        EXPECT_EQ(wrench_space(held, scale).size(), 3U);
        EXPECT_EQ(span_of_twists({{1, 0, 0}, {0, 0, 1}}, scale).size(), 2U);
        EXPECT_EQ(mobility(1, to_ground(held), scale).degrees_of_freedom, 0);
    }
}

TEST(Screw, TwistsAndWrenchesAreReciprocal) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(-1, 1);
    const ScrewScale scale{{10, -4}, 3};
    for (int n = 0; n <= 4; ++n)
        for (int k = 0; k < 50; ++k) {
            std::vector<Screw> wrenches;
            for (int i = 0; i < n; ++i)
                wrenches.push_back(force_through(scale.center + 3 * Vec2(unit(random), unit(random)),
                                                 Vec2(unit(random), unit(random)).normalized()));
            const std::vector<Screw> twists = twist_space(wrenches, scale), span = wrench_space(wrenches, scale);
            EXPECT_EQ(twists.size() + span.size(), 3U);
            for (const Screw& t : twists) {
                for (const Screw& w : wrenches) EXPECT_LT(std::abs(w.dot(t)), 1e-9 * t.norm());
                for (const Screw& w : span) EXPECT_LT(std::abs(w.dot(t)), 1e-9 * t.norm() * w.norm());
            }
        }
}

TEST(Screw, WrenchSpacesReadWell) {
    const ScrewScale scale{{1, 1}, 5};
    const auto space = [&](const std::vector<Screw>& w) { return wrench_space(w, scale); };
    expect_equal(space({}), {}, "nothing");
    expect_equal(space({force_through({3, 1}, -y), force_through({3, 7}, y)}), {force_through({3, 0}, y)}, "one line");
    expect_equal(space({force_through({0, 0}, y), force_through({2, 0}, y)}), {{0, 1, 0}, {0, 0, 1}}, "floor");
    const Vec2 p(4, -2);
    expect_equal(space({force_through(p, Vec2(1, 1).normalized()), force_through(p, Vec2(0.3, -1).normalized())}), pin(p),
                 "pin");
    expect_equal(space(together({pin({0, 0}), pin({1, 0})})), {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, "all");
}

TEST(Screw, AChainOfBodiesMovesTogether) {
    // a bar pinned to the ground at the origin, a second bar pinned to its end: two rotations
    std::vector<Connection> connections = to_ground(pin({0, 0}));
    for (const Screw& w : pin({4, 0})) connections.push_back({1, 0, w});
    const Mobility chain = mobility(2, connections, {{4, 0}, 8});
    EXPECT_EQ(chain.degrees_of_freedom, 2);
    EXPECT_EQ(chain.redundant, 0);
    expect_equal(chain.free[0], {{0, 0, 1}}, "first bar");
    expect_equal(chain.free[1], {{0, 0, 1}, {0, 1, 0}}, "second bar");
    // its other end on rollers along x: a slider crank stretched out has lost nothing but one freedom
    connections.push_back({1, -1, force_through({8, 0}, y)});
    const Mobility crank = mobility(2, connections, {{4, 0}, 8});
    EXPECT_EQ(crank.degrees_of_freedom, 1);
    EXPECT_EQ(crank.redundant, 0);
}

TEST(Mobility, RefusesBodiesThatAreNone) {
    EXPECT_THROW(mobility(2, {{0, 2, force_through({0, 0}, x)}}, {}), std::logic_error);
    EXPECT_THROW(wrench_space({}, {{0, 0}, 0}), std::logic_error);
}

}  // namespace abut::geometry::screw_test
