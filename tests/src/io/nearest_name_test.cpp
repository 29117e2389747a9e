// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/nearest_name.hpp"

#include <gtest/gtest.h>

namespace abut::nearest_name_test {
namespace {

TEST(NearestName, CountsSwappedNeighboursOnceAndCapitalsHalf) {
    EXPECT_EQ(edit_distance("radius", "radius"), 0);
    EXPECT_EQ(edit_distance("raduis", "radius"), 1);
    EXPECT_EQ(edit_distance("Radius", "radius"), 0.5);
    EXPECT_EQ(edit_distance("", "abc"), 3);
}

TEST(NearestName, IsTheOneThatHasTheWordElseTheOneSpeltMuchLikeIt) {
    EXPECT_EQ(nearest_name_hint("S1", {"SUP#0:S1", "S2", "PIN"}), "did you mean 'SUP#0:S1'? known here: SUP#0:S1, S2, PIN");
    EXPECT_EQ(nearest_name_hint("S1", {"A:S1", "B:S1", "S2"}), "did you mean 'S2'? known here: A:S1, B:S1, S2");
    EXPECT_EQ(nearest_name_hint("e", {"plate", "pin"}), "known here: plate, pin");
    EXPECT_EQ(nearest_name_hint("pinn", {"plate", "pin"}), "did you mean 'pin'? known here: plate, pin");
    EXPECT_EQ(nearest_name_hint("something", {"pin"}), "known here: pin");
    EXPECT_EQ(nearest_name_hint("pin", {}), "");
}

}  // namespace
}  // namespace abut::nearest_name_test
