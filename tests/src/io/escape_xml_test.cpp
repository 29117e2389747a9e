// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/escape_xml.hpp"

#include <gtest/gtest.h>

namespace abut::escape_xml_test {
namespace {

TEST(EscapeXml, EscapesWhatXmlReserves) {
    EXPECT_EQ(escape_xml("a<b> & \"c\" 'd'"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
    EXPECT_EQ(escape_xml(std::string("x\x01y")), "xy");
    EXPECT_EQ(escape_xml("Ø 3 µm"), "Ø 3 µm");
}

}  // namespace
}  // namespace abut::escape_xml_test
