// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that no interface joins are solved apart, and nothing of the problem is lost on the way.
#include "solver/contact/independent_groups.hpp"

#include <gtest/gtest.h>

namespace abut::solver::independent_groups_test {
namespace {

AssemblyProblem of_parts(int n, const std::vector<std::array<int, 2>>& joined) {
    AssemblyProblem problem;
    problem.parts.resize(static_cast<std::size_t>(n));
    for (const auto& pair : joined) {
        problem.interfaces.emplace_back();
        problem.interfaces.back().part = pair;
    }
    return problem;
}

using Groups = std::vector<std::vector<int>>;

TEST(IndependentGroups, FollowTheInterfaces) {
    EXPECT_EQ(independent_groups(of_parts(0, {})), Groups{});
    EXPECT_EQ(independent_groups(of_parts(3, {})), (Groups{{0}, {1}, {2}}));
    EXPECT_EQ(independent_groups(of_parts(4, {{0, 3}, {1, 2}})), (Groups{{0, 3}, {1, 2}}));
    EXPECT_EQ(independent_groups(of_parts(5, {{3, 4}, {2, 3}, {0, 4}})), (Groups{{0, 2, 3, 4}, {1}}));
    EXPECT_EQ(independent_groups(of_parts(3, {{1, 2}, {1, 2}, {0, 1}})), (Groups{{0, 1, 2}}));
}

}  // namespace
}  // namespace abut::solver::independent_groups_test
