// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plan/support_wrenches.hpp"

#include <gtest/gtest.h>

#include "tests/verification/scene_answers.hpp"

namespace abut::support_wrenches_test {
namespace {

/// Two blocks so far apart that are one part, turned by 17 degrees, pulled at the second.
Result pulled(double apart, const std::string& more_supports) {
    return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "pair", "material": "m", "geometry": {"place": {"rotate": 17, "of": {"union": [
            {"rectangle": {"min": [0, 0], "max": [10, 10]}, "name": "a"},
            {"rectangle": {"min": [)" +
                        test::number(10 + apart) + R"(, 0], "max": [30, 10]}, "name": "b"}]}}}}],
        "supports": [{"on": "pair/a/left", "fix": ["x", "y"]})" +
                        more_supports + R"(], "loads": [{"on": "pair/b/right", "force": [100, 0]}]})");
}

}  // namespace

TEST(PieceNotHeld, IsAnErrorHoweverNearTheOtherPieceIs) {
    for (const double apart : {5.0, 0.1, 1e-3}) {
        SCOPED_TRACE(apart);
        const Result loose = pulled(apart, "");
        EXPECT_NE(loose.status, "ok");
        EXPECT_NE(loose.message.find("part pair consists of 2 separate pieces, and supports of its own edges do not hold each"),
                  std::string::npos)
            << loose.message;
        EXPECT_NE(pulled(apart, R"(, {"on": "pair/b/bottom", "fix": ["x"]})").status, "ok");
        const Result held = pulled(apart, R"(, {"on": "pair/b/bottom", "fix": ["x", "y"]})");
        EXPECT_EQ(held.status, "ok") << held.message;
    }
}

TEST(PieceNotHeld, HolesBelongToTheirPiece) {
    const Result r = test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "pair", "material": "m", "geometry": {"difference": [{"union": [
            {"rectangle": {"min": [0, 0], "max": [10, 10]}, "name": "a"},
            {"rectangle": {"min": [20, 0], "max": [30, 10]}, "name": "b"}]},
            {"circle": {"center": [5, 5], "radius": 2}, "name": "h"}, {"circle": {"center": [25, 5], "radius": 2}, "name": "k"}]}}],
        "supports": [{"on": "pair/h/circle", "fix": ["x", "y"]}, {"on": "pair/k/circle", "fix": ["x", "y"]}],
        "loads": [{"on": "pair/b/right", "force": [100, 0]}]})");
    EXPECT_EQ(r.status, "ok") << r.message;
}

}  // namespace abut::support_wrenches_test
