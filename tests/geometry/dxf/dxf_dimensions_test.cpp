// SPDX-License-Identifier: GPL-3.0-or-later
// Dimensions that say something else than what is drawn.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/geometry/dxf/dxf_text.hpp"

namespace abut::geometry::dxf_dimensions_test {
namespace {

/// A linear dimension between (0, 0) and (length, 0), with a text.
std::string dimension(double length, const std::string& text, int kind = 0) {
    return dxf_record("DIMENSION", "D", "DIM", {{70, kind}, {13, 0}, {23, 0}, {14, length}, {24, 0}}) + "1\n" + text + "\n";
}

std::vector<std::string> told(const std::string& dimensions, const std::string& header = "") {
    const std::string before = header.empty() ? "" : dxf_section("HEADER", header);
    std::vector<std::string> all;
    for (const SketchProblem& w :
         read_dxf_bytes("a.dxf", dxf_file(dxf_rectangle("h", "0", 0, 0, 50, 20) + dimensions, before)).warnings)
        if (w.what.find("say") != std::string::npos) all.push_back(w.what);
    return all;
}

TEST(DxfDimensions, OfADrawingToAScaleAreTold) {
    const auto by_text = told(dimension(50, "100") + dimension(20, "40 H7") + dimension(12.5, "25,0"));
    ASSERT_EQ(by_text.size(), 1u);
    EXPECT_NE(by_text[0].find("dimensions say 2 times what is drawn (100 where 50 is drawn)"), std::string::npos) << by_text[0];
    EXPECT_EQ(told(dimension(50, "<>"), "9\n$DIMLFAC\n40\n2\n").size(), 1u);
    for (const char* text : {"100 mm", "\\A1;100", "{\\H0.7x;100}", "100 +0.1", "(100)", "100%%p0.2"})
        EXPECT_EQ(told(dimension(50, text)).size(), 1u) << text;
    EXPECT_EQ(told(dimension(50, "<>"), "9\n$DIMLFAC\n40\n-2\n").size(), 0u);  // of paper space
}

TEST(DxfDimensions, OneThatWasChangedAloneIsToldAlone) {
    const auto alone = told(dimension(50, "50") + dimension(20, "20%%p0.1") + dimension(30, "35"));
    ASSERT_EQ(alone.size(), 1u);
    EXPECT_NE(alone[0].find("a dimension says 35 where 30 is drawn"), std::string::npos) << alone[0];
}

/// Rounded texts, other units, number times length, diameters of half sections, angles and text.
TEST(DxfDimensions, ThatAreNoContradictionAreNot) {
    for (const char* text : {"50", "(50)", "<>", "", "1.9685", "50000", "4x12", "%%c100", "M20x100", "see note", "2x45%%d",
                             "50,000", "10 5", "0.164", "50 mm", "{\\H0.7x;50}", "50 +0.1"})
        EXPECT_TRUE(told(dimension(50, text)).empty()) << text;
    EXPECT_TRUE(told(dimension(17.32, "17")).empty());
    EXPECT_TRUE(told(dimension(50, "60", 2)).empty());  // an angle's points are no distance
}

}  // namespace
}  // namespace abut::geometry::dxf_dimensions_test
