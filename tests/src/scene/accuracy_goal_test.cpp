// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/accuracy_goal.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace abut::accuracy_goal_test {
namespace {

Accuracy of_level(const std::string& level) {
    Accuracy accuracy;
    accuracy.level = level;
    return accuracy;
}

}  // namespace

TEST(AccuracyGoal, LevelsAreErrors) {
    EXPECT_EQ(target_of(of_level("draft")), 0.05);
    EXPECT_EQ(target_of(of_level("standard")), 0.01);
    EXPECT_EQ(target_of(of_level("fine")), 0.002);
    EXPECT_EQ(target_of({}), 0.01);
}

TEST(AccuracyGoal, ATargetStandsForTheLevel) {
    Accuracy accuracy = of_level("fine");
    accuracy.target = 0.03;
    EXPECT_EQ(target_of(accuracy), 0.03);
}

TEST(AccuracyGoal, WhatCanBeAimedAt) {
    for (double error : {1e-5, 1e-3, 0.5}) EXPECT_TRUE(is_target(error)) << error;
    for (double error : {0.0, -0.01, 9e-6, 0.51, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_FALSE(is_target(error)) << error;
}

TEST(AccuracyGoal, CellsFollowTheTargetAndAreOneAtStandard) {
    for (bool has_contact : {true, false}) {
        EXPECT_DOUBLE_EQ(coarseness_of(of_level("standard"), has_contact), 1);
        double before = 0;
        for (double target : {1e-5, 1e-4, 1e-3, 0.01, 0.1, 0.5}) {
            Accuracy accuracy;
            accuracy.target = target;
            EXPECT_GT(coarseness_of(accuracy, has_contact), before) << target;
            before = coarseness_of(accuracy, has_contact);
        }
    }
    // grids that contacts refine begin nearer to the standard's
    EXPECT_LT(coarseness_of(of_level("draft"), true), coarseness_of(of_level("draft"), false));
    EXPECT_GT(coarseness_of(of_level("fine"), true), coarseness_of(of_level("fine"), false));
}

}  // namespace abut::accuracy_goal_test
