// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/base/ensure.hpp"

#include <gtest/gtest.h>

namespace abut::ensure_test {
namespace {

TEST(Ensure, SaysWhatDoesNotHoldAndWhere) {
    const int sides = 2;
    try {
        ENSURE(sides == 3, "a triangle has three sides");
        FAIL();
    } catch (const std::logic_error& error) {
        const std::string place = std::string("tests/src/base/ensure_test.cpp:") + std::to_string(__LINE__ - 3) + ")";
        const std::string text = error.what(), beginning = "a triangle has three sides (sides == 3, ";
        EXPECT_EQ(text, beginning + place);
    }
}

TEST(Ensure, AsksOnceAndMakesNoSentenceWhereAllIsWell) {
    int asked = 0, made = 0;
    const auto sentence = [&] { return ++made, std::string("never"); };
    ENSURE(++asked == 1, sentence());
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(made, 0);
}

}  // namespace
}  // namespace abut::ensure_test
