// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch/batch_shard.hpp"

#include <gtest/gtest.h>

#include <map>

#include "geometry/brep/input_error.hpp"

namespace abut::batch_shard_test {
namespace {

std::optional<Shard> of_array(int id, int least, int most, int step, int count) {
    const std::map<std::string, std::string> variables{{"SLURM_ARRAY_TASK_ID", std::to_string(id)},
                                                       {"SLURM_ARRAY_TASK_MIN", std::to_string(least)},
                                                       {"SLURM_ARRAY_TASK_MAX", std::to_string(most)},
                                                       {"SLURM_ARRAY_TASK_STEP", std::to_string(step)},
                                                       {"SLURM_ARRAY_TASK_COUNT", std::to_string(count)}};
    return slurm_shard([&](const char* name) { return variables.at(name); });
}

TEST(BatchShard, ReadsTheOption) {
    EXPECT_EQ(parse_shard("3/8").index, 3U);
    EXPECT_EQ(parse_shard("3/8").count, 8U);
    for (const char* wrong : {"", "3", "0/8", "9/8", "3/", "/8", "a/8", "-1/8", "1/8/2", "1.5/8"})
        EXPECT_THROW(parse_shard(wrong), InputError) << wrong;
}

TEST(BatchShard, FollowsSlurmArraysWhereverTheyBegin) {
    for (const int least : {0, 1, 7})
        for (const int step : {1, 3})
            for (int k = 0; k < 5; ++k) {
                const auto shard = of_array(least + k * step, least, least + 4 * step, step, 5);
                ASSERT_TRUE(shard);
                EXPECT_EQ(shard->index, static_cast<std::size_t>(k + 1));
                EXPECT_EQ(shard->count, 5U);
            }
    EXPECT_FALSE(slurm_shard([](const char*) { return std::string(); }));
    EXPECT_THROW(of_array(3, 1, 7, 1, 3), InputError);  // --array=1,3,7
}

}  // namespace
}  // namespace abut::batch_shard_test
