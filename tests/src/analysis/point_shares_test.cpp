// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/point_shares.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/scene_answers.hpp"

namespace abut::point_shares_test {
namespace {

/// A block on a base, pressed by 3000; the block is held by points besides, as these are given.
Result on_base(const std::string& points, const std::string& accuracy) {
    return test::answer(R"({"abut": 1, "analysis": "plane_stress", "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "base", "material": "m", "geometry": {"rectangle": {"min": [-20, -20], "max": [80, 0]}}},
        {"name": "block", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [40, 20]}}}],
        "supports": [{"on": "base/bottom", "fix": ["x", "y"]}, {"part": "block", )" +
                        points + R"(}],
        "loads": [{"on": "block/top", "force": [500, -3000]}], "thickness": 10, "accuracy": {"level": ")" +
                        accuracy + R"("}})");
}

double force_error(const Result& r) {
    return r.contacts.at(0).errors.value().force;
}

}  // namespace

TEST(PointShares, AForceBesideAPointThatBearsSomeOfItIsKnownAsWellAsItsCellsAllow) {
    const std::string in_face = R"("at": [20, 0], "fix": ["x", "y"])";
    const Result coarse = on_base(in_face, "standard"), fine = on_base(in_face, "fine");
    ASSERT_EQ(fine.status, "ok") << fine.message;
    const double change = std::abs(fine.contacts.at(0).force.y() / coarse.contacts.at(0).force.y() - 1);
    EXPECT_GT(change, 0.05);  // cells there are a third as large
    EXPECT_GT(force_error(coarse), 0.4 * change);
    EXPECT_FALSE(coarse.accuracy.reached);
    EXPECT_NE(coarse.accuracy.why.find("contact 1 shares its load with points that are held"), std::string::npos)
        << coarse.accuracy.why;
}

TEST(PointShares, NoForceThatStaticsGivesDependsOnPoints) {
    const Result r = on_base(R"("at": [20, 20], "fix": ["x"])", "standard");
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_NEAR(r.contacts.at(0).force.y(), -3000, 1e-6);
    EXPECT_LT(force_error(r), 2e-3);
}

}  // namespace abut::point_shares_test
