// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/dissection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <vector>

namespace abut::solver::dissection_test {
namespace {

/// A grid of nx x ny nodes whose neighbours lie within `reach` lines in both directions; those with hole(x, y) are left out.
struct GridGraph {
    Neighbours graph{{0}, {}};
    std::vector<GridPlace> place;
};
template <class Hole>
GridGraph grid_graph(int nx, int ny, int reach, Hole hole) {
    GridGraph g;
    std::vector<int> number(static_cast<std::size_t>(nx * ny), -1);
    const auto at = [&](int x, int y) -> int& { return number[static_cast<std::size_t>(x + nx * y)]; };
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x) {
            if (hole(x, y)) continue;
            at(x, y) = static_cast<int>(g.place.size());
            g.place.push_back({x, y});
        }
    for (const auto& [x, y] : g.place) {
        for (int j = std::max(0, y - reach); j <= std::min(ny - 1, y + reach); ++j)
            for (int i = std::max(0, x - reach); i <= std::min(nx - 1, x + reach); ++i)
                if (at(i, j) >= 0 && at(i, j) != at(x, y)) g.graph.node.push_back(at(i, j));
        g.graph.first.push_back(static_cast<int>(g.graph.node.size()));
    }
    return g;
}
GridGraph grid_graph(int nx, int ny, int reach) {
    return grid_graph(nx, ny, reach, [](int, int) { return false; });
}

/// Nodes in each connected piece of those whose level is at most `highest`.
std::vector<std::size_t> pieces(const GridGraph& g, const std::vector<int>& level, int highest) {
    std::vector<char> seen(level.size(), 0);
    std::vector<std::size_t> sizes;
    for (std::size_t start = 0; start < level.size(); ++start) {
        if (seen[start] || level[start] > highest) continue;
        std::vector<std::size_t> found{start};
        seen[start] = 1;
        for (std::size_t k = 0; k < found.size(); ++k)
            for (int e = g.graph.first[found[k]]; e < g.graph.first[found[k] + 1]; ++e) {
                const auto other = static_cast<std::size_t>(g.graph.node[static_cast<std::size_t>(e)]);
                if (seen[other] || level[other] > highest) continue;
                seen[other] = 1;
                found.push_back(other);
            }
        sizes.push_back(found.size());
    }
    return sizes;
}

TEST(Dissection, CutsIntoPiecesThatNothingJoins) {
    for (int reach : {1, 2, 4})
        for (const auto& [nx, ny] : {std::pair(40, 40), std::pair(120, 12), std::pair(9, 200)}) {
            const GridGraph g = grid_graph(nx, ny, reach);
            const int least = 60;
            const std::vector<int> level = dissect(g.graph, g.place, least);
            const std::vector<std::size_t> left = pieces(g, level, 0);
            EXPECT_LT(*std::max_element(left.begin(), left.end()), static_cast<std::size_t>(least));
            // without the first separator, which comes last: halves
            const int top = *std::max_element(level.begin(), level.end());
            const std::vector<std::size_t> halves = pieces(g, level, top - 1);
            ASSERT_EQ(halves.size(), 2u) << nx << " " << ny << " " << reach;
            EXPECT_LE(std::max(halves[0], halves[1]), g.place.size() / 2 + static_cast<std::size_t>(std::min(nx, ny)));
            EXPECT_EQ(std::count(level.begin(), level.end(), top), std::min(nx, ny) * reach);  // across the shorter way
        }
}

TEST(Dissection, FollowsEdgesHoweverFarTheyGo) {
    GridGraph g = grid_graph(30, 6, 1);
    // node 0 is joined to the last one: whichever line is cut, one of them has to go
    const auto join = [&](std::size_t a, int b) {
        g.graph.node.insert(g.graph.node.begin() + g.graph.first[a + 1], b);
        for (std::size_t k = a + 1; k < g.graph.first.size(); ++k) ++g.graph.first[k];
    };
    join(0, 179);
    join(179, 0);
    const std::vector<int> level = dissect(g.graph, g.place, 100);
    EXPECT_EQ(pieces(g, level, *std::max_element(level.begin(), level.end()) - 1).size(), 2u);
    EXPECT_GT(level[179], 0);
}

TEST(Dissection, GoesAroundHoles) {
    const GridGraph g = grid_graph(60, 60, 2, [](int x, int y) { return std::hypot(x - 30, y - 28) < 18; });
    const std::vector<int> level = dissect(g.graph, g.place, 200);
    const std::vector<std::size_t> left = pieces(g, level, 0);
    EXPECT_LT(*std::max_element(left.begin(), left.end()), 200u);
}

TEST(Dissection, LeavesWhatIsSmallOrOnOneLine) {
    const GridGraph small = grid_graph(5, 5, 1);
    EXPECT_EQ(dissect(small.graph, small.place, 26), std::vector<int>(25, 0));
    GridGraph one_place = grid_graph(5, 5, 1);
    std::fill(one_place.place.begin(), one_place.place.end(), GridPlace{3, 3});
    EXPECT_EQ(dissect(one_place.graph, one_place.place, 4), std::vector<int>(25, 0));
    EXPECT_TRUE(dissect({{0}, {}}, {}, 10).empty());
}

}  // namespace
}  // namespace abut::solver::dissection_test
