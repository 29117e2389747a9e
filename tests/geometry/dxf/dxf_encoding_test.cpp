// SPDX-License-Identifier: GPL-3.0-or-later
// Names in the code pages that drawings were saved in before R2007.
#include "geometry/dxf/dxf_encoding.hpp"

#include <gtest/gtest.h>

#include "tests/geometry/dxf/dxf_text.hpp"

namespace abut::geometry::dxf_encoding_test {
namespace {

using dxf::stated_code_page;
using dxf::to_utf8;

struct Page {
    const char *name, *bytes, *text;
};

/// As Python's codecs write them.
const Page pages[] = {{"ANSI_1252", "Geh\xE4use \x80", "Gehäuse €"},
                      {"ansi_1252",
                       "\xD8"
                       "12",
                       "Ø12"},
                      {"ANSI_1251", "\xC4\xE5\xF2\xE0\xEB\xFC", "Деталь"},
                      {"ANSI_936", "\xC1\xE3\xBC\xFE", "零件"},
                      {"ANSI_932", "\x95\x94\x95i \x83\x5C", "部品 ソ"},  // the second byte of the last one is a backslash
                      {"ANSI_949", "\xBA\xCE\xC7\xB0", "부품"},
                      {"ANSI_950", "\xB9\x73\xA5\xF3", "零件"},
                      {"DOS850", "Geh\x84use", "Gehäuse"},
                      {"ISO8859-2", "cz\xEA\xB6\xE6", "część"}};

std::string header(const std::string& page) {
    return dxf_section("HEADER", "9\n$ACADVER\n1\nAC1015\n9\n$DWGCODEPAGE\n3\n" + page + "\n");
}

std::string layer_read(const std::string& page, const std::string& layer) {
    return read_drawing(dxf_file(dxf_line("1", layer, 0, 0, 1, 0), header(page))).entities.at(0).layer;
}

TEST(DxfEncoding, NamesAreReadInTheStatedCodePage) {
    for (const Page& page : pages) {
        EXPECT_EQ(to_utf8(page.bytes, page.name), page.text) << page.name;
        EXPECT_EQ(layer_read(page.name, page.bytes), page.text) << page.name;
    }
}

TEST(DxfEncoding, Utf8IsTakenForItselfWhateverIsStated) {
    for (const Page& page : pages) EXPECT_EQ(layer_read("ANSI_936", page.text), page.text);
}

TEST(DxfEncoding, WhatIsOfNoKnownPageIsLatin1) {
    const std::string bytes = "\xC4\xFF";
    for (const char* page : {"", "ANSI_", "ANSI_99999", "../../x", "ANSI_936//IGNORE", "DOS", "MAC", "ANSI_936"})
        EXPECT_EQ(to_utf8(bytes, page), "Äÿ") << page;  // FF is no byte of page 936
    EXPECT_EQ(to_utf8("", "ANSI_936"), "");
    EXPECT_EQ(to_utf8(std::string("\xE4\0b", 3), "ANSI_1252"), std::string("ä\0b", 4));
}

TEST(DxfEncoding, TheCodePageStandsInTheHeader) {
    EXPECT_EQ(stated_code_page(header("ANSI_932")), "ANSI_932");
    EXPECT_EQ(stated_code_page("  9\r\n$DWGCODEPAGE\r\n  3\r\n  dos850  \r\n"), "dos850");
    EXPECT_EQ(stated_code_page(dxf_file(dxf_line("1", "$DWGCODEPAGE", 0, 0, 1, 0), dxf_section("HEADER", ""))), "");
    for (const char* text :
         {"", "$DWGCODEPAGE", "$DWGCODEPAGE\n3", "$DWGCODEPAGE\n3\n", "0\nENDSEC\n9\n$DWGCODEPAGE\n3\nANSI_932\n"})
        EXPECT_EQ(stated_code_page(text), "") << text;
}

}  // namespace
}  // namespace abut::geometry::dxf_encoding_test
