// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/motion/led_parts.hpp"

#include <gtest/gtest.h>

namespace abut::led_parts_test {
namespace {

Lead along_x(double way) {
    Lead lead;
    lead.is_given[0] = true;
    lead.to[0] = way;
    lead.way = 0;
    return lead;
}

/// A small part goes no faster beside a large one than this, and is there with it.
TEST(LedParts, GoSideBySide) {
    const LedParts led({along_x(40), along_x(-10)}, {{0, 0}, {5, 5}}, {100, 2}, {0, 1});
    std::vector<Placement> placements(2);
    int steps = 0;
    while (!led.are_there(placements)) {
        const std::vector<Lead> step = led.of_step(placements, 1, 1);
        EXPECT_LE(std::abs(step[0].to[0]), step_fraction * 100);
        EXPECT_LE(std::abs(step[1].to[0]), step_fraction * 2);
        EXPECT_NEAR(step[0].to[0], -4 * step[1].to[0], 1e-9);
        for (std::size_t i = 0; i < 2; ++i) placements[i].shift.x() += step[i].to[0];
        ASSERT_LE(++steps, 60);
    }
    EXPECT_NEAR(placements[0].shift.x(), 40, 1e-2);
}

}  // namespace
}  // namespace abut::led_parts_test
