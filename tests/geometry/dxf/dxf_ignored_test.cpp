// SPDX-License-Identifier: GPL-3.0-or-later
// What is left out of a drawing, and how entities look by layer.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/geometry/dxf/dxf_text.hpp"

namespace abut::geometry::dxf_ignored_test {
namespace {

TEST(DxfIgnored, CountsWhatIsLeftOutAndSaysWhy) {
    const std::string layers = dxf_section("TABLES",
                                           "0\nTABLE\n2\nLAYER\n0\nLAYER\n2\nOff\n62\n-7\n0\nLAYER\n2\nFrozen\n70\n1\n"
                                           "0\nLAYER\n2\nAxes\n6\nCENTER2\n0\nENDTAB\n");
    const Drawing drawing = read_drawing(dxf_file(
        dxf_line("1", "A", 0, 0, 1, 0) + dxf_line("2", "OFF", 0, 0, 1, 0) + dxf_line("3", "Frozen", 0, 0, 1, 0) +
            dxf_line("4", "Axes", 0, 0, 1, 0) + dxf_record("REGION", "5", "A", {}) + dxf_record("REGION", "6", "A", {}) +
            dxf_record("TEXT", "7", "A", {}) + dxf_record("LINE", "8", "A", {{67, 1}, {10, 0}, {20, 0}, {11, 1}, {21, 1}}) +
            dxf_record("CIRCLE", "9", "A", {{60, 1}, {10, 0}, {20, 0}, {40, 1}}),
        layers));
    const auto why = [&](const std::string& what) {
        for (const Ignored& ignored : drawing.ignored)
            if (ignored.what == what) return std::to_string(ignored.count) + " " + ignored.why;
        return std::string("not ignored");
    };
    EXPECT_EQ(drawing.entities.size(), 1u);
    EXPECT_EQ(why("LINE on layer OFF"), "1 layer is off");
    EXPECT_EQ(why("LINE on layer Frozen"), "1 layer is frozen");
    EXPECT_EQ(why("REGION"), "2 a solid or surface in a closed format (ACIS)");
    EXPECT_EQ(why("TEXT"), "1 annotation");
    EXPECT_EQ(why("CIRCLE"), "1 invisible");
    EXPECT_TRUE(std::any_of(drawing.ignored.begin(), drawing.ignored.end(),
                            [](const Ignored& i) { return i.why == "line type CENTER2"; }));
    EXPECT_TRUE(std::any_of(drawing.ignored.begin(), drawing.ignored.end(),
                            [](const Ignored& i) { return i.why == "in paper space"; }));
    EXPECT_EQ(drawing.counts.at("LINE").read, 4);  // the one in paper space is not of this drawing
    int read = 0;
    for (const auto& [type, count] : drawing.counts) {
        EXPECT_EQ(count.read, count.used + count.ignored) << type;
        read += count.read;
    }
    EXPECT_EQ(read, 8);
}

/// What is listed as ignored of one entity that is no outline.
std::vector<Ignored> ignored_of(const std::string& record, const std::string& before = "") {
    return read_drawing(dxf_file(dxf_line("1", "A", 0, 0, 1, 0) + record, before)).ignored;
}

TEST(DxfIgnored, ListsEveryKindThatItDoesNotRead) {
    for (const char* type :
         {"TEXT",    "MTEXT", "DIMENSION", "LEADER",    "MULTILEADER", "POINT",   "XLINE",      "RAY",    "HATCH",
          "WIPEOUT", "SOLID", "TRACE",     "3DFACE",    "MESH",        "3DSOLID", "REGION",     "BODY",   "MLINE",
          "HELIX",   "IMAGE", "LIGHT",     "OLE2FRAME", "VIEWPORT",    "SHAPE",   "ACAD_TABLE", "NO_SUCH"}) {
        const std::vector<Ignored> ignored = ignored_of(dxf_record(type, "2", "A", {{10, 0}, {20, 0}}));
        ASSERT_EQ(ignored.size(), 1u) << type;
        EXPECT_EQ(ignored[0].what, type);
        EXPECT_EQ(ignored[0].count, 1);
        EXPECT_EQ(ignored[0].why == "not read by this version", type == std::string("NO_SUCH")) << ignored[0].why;
    }
}

/// What lies above or rises is read as in one plane, and that is told; a little z is carelessness.
TEST(DxfIgnored, TellsHeights) {
    const auto heights = [](const std::string& more, const std::string& before = "") {
        const Drawing drawing = read_drawing(dxf_file(dxf_line("1", "A", 0, 0, 100, 0) + more, before));
        for (const SketchProblem& w : drawing.warnings)
            if (const std::size_t from = w.what.find("heights (z)"); from != std::string::npos)
                return w.what.substr(from, w.what.find(':') - from);
        return std::string();
    };
    const auto line = [](double z0, double z1) {
        return dxf_record("LINE", "2", "A", {{10, 0}, {20, 5}, {30, z0}, {11, 9}, {21, 5}, {31, z1}});
    };
    EXPECT_EQ(heights(""), "");
    EXPECT_EQ(heights(line(0.01, -0.01)), "");
    EXPECT_EQ(heights(line(0, 5)), "heights (z) from 0 to 5");
    EXPECT_EQ(heights(line(-3, -3)), "heights (z) from -3 to 0");
    EXPECT_EQ(heights(dxf_record("CIRCLE", "2", "A", {{10, 0}, {20, 0}, {30, 7}, {40, 1}})), "heights (z) from 0 to 7");
    EXPECT_EQ(heights(dxf_record("CIRCLE", "2", "A", {{10, 0}, {20, 0}, {30, 7}, {40, 1}, {210, 0}, {220, 0}, {230, -1}})),
              "heights (z) from -7 to 0");
    EXPECT_EQ(heights(dxf_record("LWPOLYLINE", "2", "A", {{90, 2}, {70, 0}, {38, 4}, {10, 0}, {20, 5}, {10, 9}, {20, 5}})),
              "heights (z) from 0 to 4");
    const std::string block = dxf_section("BLOCKS", dxf_block("B", 0, 0, line(1, 2)));
    EXPECT_EQ(heights(dxf_insert("3", "A", "B", 0, 50, {{30, 10}}), block), "heights (z) from 0 to 12");
}

TEST(DxfIgnored, TellsFillingsDrawnAsWideLines) {
    const auto told = [](double width) {
        const Drawing drawing = read_drawing(dxf_file(dxf_record(
            "LWPOLYLINE", "1", "A", {{90, 2}, {70, 1}, {43, width}, {10, 0}, {20, 0}, {42, 1}, {10, 4}, {20, 0}, {42, 1}})));
        EXPECT_EQ(drawing.entities.size(), 2u);
        return std::any_of(drawing.warnings.begin(), drawing.warnings.end(), [](const SketchProblem& w) {
            return w.what == "LWPOLYLINE is drawn wide, as a filled area: the middle of the line is read as the outline";
        });
    };
    EXPECT_TRUE(told(4));
    EXPECT_FALSE(told(0.1));
    EXPECT_FALSE(told(0));
}

TEST(DxfIgnored, TellsWhatCouldBoundAPart) {
    const auto is_told = [](const std::string& type) {
        const Drawing drawing = read_drawing(
            dxf_file(dxf_line("1", "A", 0, 0, 1, 0) + dxf_record(type, "2", "A", {{10, 0}, {20, 0}, {11, 1}, {21, 0}})));
        return std::any_of(drawing.warnings.begin(), drawing.warnings.end(),
                           [&](const SketchProblem& w) { return w.what.find(type) != std::string::npos; });
    };
    for (const char* type : {"MLINE", "3DSOLID", "REGION", "3DFACE"}) EXPECT_TRUE(is_told(type)) << type;
    for (const char* type : {"TEXT", "DIMENSION", "SOLID", "XLINE"}) EXPECT_FALSE(is_told(type)) << type;
}

TEST(DxfIgnored, KnowsConstructionLinesByLineTypeAndLayer) {
    for (const char* name :
         {"CENTER", "Center2", "CENTERX2", "ACAD_ISO04W100", "SLD-Center", "HIDDEN", "phantom", "DASHDOT", "DASHED2"}) {
        const std::string typed = std::string("0\nLINE\n8\nA\n6\n") + name + "\n10\n0\n20\n0\n11\n1\n21\n1\n";
        EXPECT_EQ(ignored_of(typed).size(), 1u) << name;
    }
    for (const char* name : {"CONTINUOUS", "Continuous", "BYLAYER", "ByBlock", "SLD-Solid"}) {
        const std::string typed = std::string("0\nLINE\n8\nA\n6\n") + name + "\n10\n0\n20\n0\n11\n1\n21\n1\n";
        EXPECT_TRUE(ignored_of(typed).empty()) << name;
    }
    for (const char* name :
         {"centerlines", "Center Line", "CENTRE_LINE", "Construction-Lines", "DIMS", "xref|Hidden", "Mittellinien", "Verdeckt",
          "Title Block", "BORDER", "Bema\xC3\x9Fung", "notes", "HATCH", "Hatch (ISO)", "01-Mittellinien", "AM_7", "SLD-Border",
          "\xE4\xB8\xAD\xE5\xBF\x83\xE7\xBA\xBF", "\xD1\x88\xD1\x82\xD0\xB0\xD0\xBC\xD0\xBF"})
        EXPECT_EQ(ignored_of(dxf_line("2", name, 0, 0, 1, 1)).size(), 1u) << name;
    for (const char* name : {"0", "CENTERPIECE", "HIDDENLATCH", "DIMPLE", "FRAME", "AXIS", "BORDERPLATE", "IV_OUTER_PROFILE"})
        EXPECT_TRUE(ignored_of(dxf_line("2", name, 0, 0, 1, 1)).empty()) << name;
}

TEST(DxfIgnored, LayersOfHolesAreKnownByWholeWords) {
    const auto holes = [](const char* layer) {
        return !read_drawing(dxf_file(dxf_circle("1", layer, 0, 0, 1))).hole_layers.empty();
    };
    for (const char* layer : {"HOLES", "Bohrungen", "02-drill-holes", "Langl\u00f6cher", "Gewinde", "CUTOUT"})
        EXPECT_TRUE(holes(layer)) << layer;
    for (const char* layer : {"CUTTER", "Tape", "Borehead", "PLATE", "0", "Slotted nut"}) EXPECT_FALSE(holes(layer)) << layer;
}

TEST(DxfIgnored, GivesColoursByLayer) {
    const std::string layers = dxf_section("TABLES", "0\nLAYER\n2\nA\n62\n3\n0\nLAYER\n2\nB\n62\n99999\n");
    const auto color = [&](const char* layer, std::initializer_list<std::pair<int, double>> more) {
        std::string record = dxf_line("1", layer, 0, 0, 1, 1);
        for (const auto& [code, value] : more)
            record += std::to_string(code) + "\n" + std::to_string(static_cast<int>(value)) + "\n";
        return read_drawing(dxf_file(record, layers)).entities.at(0).color;
    };
    EXPECT_EQ(color("A", {}), 3);
    EXPECT_EQ(color("a", {{62, 256}}), 3);
    EXPECT_EQ(color("A", {{62, 5}}), 5);
    EXPECT_EQ(color("A", {{62, 0}}), 7);  // by block, and there is none
    EXPECT_EQ(color("B", {}), 7);
    EXPECT_EQ(color("C", {}), 7);
}

}  // namespace
}  // namespace abut::geometry::dxf_ignored_test
