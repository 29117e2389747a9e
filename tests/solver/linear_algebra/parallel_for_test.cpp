// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/parallel_for.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "solver/linear_algebra/blas_threads.hpp"

namespace abut::solver::parallel_for_test {
namespace {

TEST(ParallelFor, MakesEveryCallOnce) {
    for (int threads : {1, 2, 3, 16})
        for (int n : {0, 1, 2, 5, 1000}) {
            std::vector<std::atomic<int>> calls(static_cast<std::size_t>(n));
            parallel_for(n, threads, [&](int i) { ++calls[static_cast<std::size_t>(i)]; });
            for (const std::atomic<int>& c : calls) EXPECT_EQ(c, 1);
        }
}

TEST(ParallelFor, StartsNoThreadForOnePieceOrOneThread) {
    const auto caller = std::this_thread::get_id();
    for (const auto& [n, threads] : {std::pair(1, 8), std::pair(20, 1)})
        parallel_for(n, threads, [&](int) { EXPECT_EQ(std::this_thread::get_id(), caller); });
}

TEST(ParallelFor, UsesSeveralThreadsAtOnce) {
    std::atomic<int> arrived = 0;
    parallel_for(2, 2, [&](int) {
        ++arrived;
        while (arrived < 2) std::this_thread::yield();  // for ever, if one came after the other
    });
    EXPECT_EQ(arrived, 2);
}

TEST(ParallelFor, ThrowsTheExceptionOfTheLowestNumberAfterAllCalls) {
    for (int threads : {1, 4}) {
        std::atomic<int> calls = 0;
        try {
            parallel_for(50, threads, [&](int i) {
                ++calls;
                if (i == 7 || i == 8 || i == 40) throw std::runtime_error(std::to_string(i));
            });
            ADD_FAILURE() << "nothing was thrown";
        } catch (const std::runtime_error& e) { EXPECT_STREQ(e.what(), "7"); }
        EXPECT_EQ(calls, 50);
    }
}

TEST(UsableThreads, AreAsManyAsWantedOrOne) {
    EXPECT_GE(usable_threads(0), 1);
    EXPECT_EQ(usable_threads(1), 1);
    EXPECT_EQ(std::set<int>({1, 3}).count(usable_threads(3)), 1u);
    EXPECT_EQ(usable_threads(3) == 1, usable_threads(5) == 1);
}

}  // namespace
}  // namespace abut::solver::parallel_for_test
