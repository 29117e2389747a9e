// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/base64.hpp"

#include <gtest/gtest.h>

namespace abut::base64_test {
namespace {

std::string of(const std::string& text) {
    return base64(std::vector<std::uint8_t>(text.begin(), text.end()));
}

TEST(Base64, TestVectorsOfItsStandard) {  // RFC 4648, section 10
    EXPECT_EQ(of(""), "");
    EXPECT_EQ(of("f"), "Zg==");
    EXPECT_EQ(of("fo"), "Zm8=");
    EXPECT_EQ(of("foo"), "Zm9v");
    EXPECT_EQ(of("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64({0xfb, 0xff, 0xfe}), "+//+");
}

}  // namespace
}  // namespace abut::base64_test
