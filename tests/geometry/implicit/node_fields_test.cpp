// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/implicit/node_fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/geometry/csg/csg_nodes.hpp"

namespace abut::geometry::node_fields_test {

namespace {

using namespace csg_nodes;

std::vector<int> edges_from(const Part& part, const std::string& prefix) {
    std::vector<int> edges;
    for (std::size_t e = 0; e < part.edges.size(); ++e)
        if (part.edges[e].name.rfind(prefix, 0) == 0) edges.push_back(static_cast<int>(e));
    return edges;
}

CsgNode named(CsgNode node, const std::string& name) {
    node.name = name;
    return node;
}

/// A plate with a window and a hole, its foot joined to it (and overlapping).
CsgNode plate() {
    return less({join({named(rectangle(0, 0, 10, 6), "plate"), named(rectangle(3, -2, 7, 1), "foot")}),
                 named(rectangle(1, 2, 4, 4), "window"), named(circle(7, 3, 1), "hole")});
}

HeldNodes nodes_of_window(const CsgNode& tree, const Part& part) {
    return held_nodes(tree, part, edges_from(part, "window"));
}

TEST(NodeFields, AWindowIsHeldAsAWhole) {
    const HeldNodes held = nodes_of_window(plate(), evaluate(plate()).part);
    ASSERT_EQ(held.fields.size(), 1U);
    EXPECT_TRUE(held.rest.empty());
    // normalised on the window's sides, positive on their lines beyond
    EXPECT_NEAR(value(held.fields[0], {2.5, 2}), 0, 1e-14);
    EXPECT_NEAR(evaluate(held.fields[0], {2.5, 2}).gradient.y(), -1, 1e-12);
    EXPECT_GT(value(held.fields[0], {6, 2}), 0.5);
    EXPECT_LT(value(held.fields[0], {2, 3}), 0);
}

TEST(NodeFields, SidesAloneAreLeftToTheirLines) {
    const CsgNode tree = plate();
    const Part part = evaluate(tree).part;
    std::vector<int> edges = edges_from(part, "window/left");
    for (int e : edges_from(part, "hole")) edges.push_back(e);
    const HeldNodes held = held_nodes(tree, part, edges);
    ASSERT_EQ(held.fields.size(), 1U);
    EXPECT_NEAR(value(held.fields[0], {7, 4}), 0, 1e-14);
    EXPECT_EQ(held.rest, edges_from(part, "window/left"));
}

/// All that is left of the foot is held; but the foot ends inside the plate.
TEST(NodeFields, ANodeThatGoesOnInsideIsNone) {
    const CsgNode tree = plate();
    const Part part = evaluate(tree).part;
    const std::vector<int> foot = edges_from(part, "foot");
    ASSERT_EQ(foot.size(), 3U);
    const HeldNodes held = held_nodes(tree, part, foot);
    EXPECT_TRUE(held.fields.empty());
    EXPECT_EQ(held.rest, foot);
}

TEST(NodeFields, TheLargestNodeIsTaken) {
    const CsgNode tree = plate();
    const Part part = evaluate(tree).part;
    const HeldNodes all = held_nodes(tree, part, edges_from(part, ""));
    EXPECT_EQ(all.fields.size(), 1U);
    EXPECT_TRUE(all.rest.empty());
    EXPECT_EQ(value(all.fields[0], {0.5, 5.2}), value(implicit_of(tree), {0.5, 5.2}));
    std::vector<int> outer = edges_from(part, "plate");
    for (int e : edges_from(part, "foot")) outer.push_back(e);
    const HeldNodes outside = held_nodes(tree, part, outer);
    ASSERT_EQ(outside.fields.size(), 1U);
    EXPECT_TRUE(outside.rest.empty());
    EXPECT_GT(value(outside.fields[0], {7, 4}), 0.5);
}

/// The R-function of a union vanishes where its bodies abut.
TEST(NodeFields, BodiesThatAbutAreNoNode) {
    const CsgNode tree = join({rectangle(0, 0, 2, 1), rectangle(2, 0, 5, 1)});
    const Part part = evaluate(tree).part;
    std::vector<int> all = edges_from(part, "");
    const HeldNodes held = held_nodes(tree, part, all);
    EXPECT_TRUE(held.fields.empty());
    EXPECT_EQ(held.rest, all);
}

TEST(NodeFields, MoveWithTheirTree) {
    const double c = std::cos(0.3), s = std::sin(0.3);
    const CsgNode tree = plate(), there = transformed(tree, c, s, {2, -1});
    const Part part = transformed(evaluate(tree).part, c, s, {2, -1});
    const HeldNodes held = nodes_of_window(there, part);
    ASSERT_EQ(held.fields.size(), 1U);
    const Vec2 p(6, 2), q(c * p.x() - s * p.y() + 2, s * p.x() + c * p.y() - 1);
    EXPECT_NEAR(value(held.fields[0], q), value(nodes_of_window(tree, evaluate(tree).part).fields[0], p), 1e-13);
}

}  // namespace
}  // namespace abut::geometry::node_fields_test
