// SPDX-License-Identifier: GPL-3.0-or-later
// Skipped, and said so, where the program was built without OpenCASCADE.
#include "geometry/step/step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <numbers>
#include <random>
#include <set>

#include "geometry/brep/input_error.hpp"
#include "geometry/dxf/dxf.hpp"
#include "geometry/foreign/reader_process.hpp"
#include "tests/geometry/mesh/small_meshes.hpp"

namespace abut::geometry::step_test {
namespace {

const std::string sketches = ABUT_SOURCE_DIR "/data/sketches/";
const std::string shaft_and_hub = ABUT_SOURCE_DIR "/tests/geometry/step/shaft_and_hub.step";

class Step : public testing::Test {
protected:
    void SetUp() override {
        if (reader_path("abut-read-step").empty()) GTEST_SKIP() << "OpenCASCADE is not installed";
    }
};

std::string text_of_file(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    EXPECT_NE(text.find(from), std::string::npos) << from;
    return text.replace(text.find(from), from.size(), to);
}

std::string replaced_all(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

Drawing read_text(const std::string& text, const SectionChoice& choice = {}) {
    const TemporaryFile file("a.stp", text);
    return read_step_file(file.path(), choice);
}

std::map<std::string, double> areas_of(const Drawing& drawing) {
    SketchOptions options;
    options.recognise_arcs = false;
    const SketchParts sketch = parts_of(drawing, options);
    EXPECT_TRUE(sketch.problems.empty());
    std::map<std::string, double> areas;
    for (const Part& part : sketch.parts) areas[part.name] = area(part);
    return areas;
}

bool has_repair(const Drawing& drawing, const std::string& words) {
    return std::any_of(drawing.repairs.begin(), drawing.repairs.end(),
                       [&](const Repair& repair) { return repair.what.find(words) != std::string::npos; });
}

std::string refusal(const std::string& text) {
    try {
        read_text(text);
    } catch (const InputError& error) {
        EXPECT_EQ(error.problems().size(), 1u);
        return one_line(error.problems().front());
    }
    return "";
}

/// Half the shaft: steps, a cone at its end, a fillet (part of a torus) at its shoulder.
const double shaft_area = 2 * (18 + 380 + (75 - 6.25 * std::numbers::pi) + 300 + 100);

TEST_F(Step, AnAssemblyHasThePartsOfItsDrawing) {
    const Drawing drawing = read_step_file(sketches + "pin_bracket.step", {});
    EXPECT_EQ(drawing.unit, "mm");
    EXPECT_TRUE(drawing.problems.empty());
    EXPECT_TRUE(drawing.ignored.empty());
    EXPECT_EQ(drawing.cut_at, "z = 5");
    const auto areas = areas_of(drawing), drawn = areas_of(read_dxf(sketches + "pin_bracket_r14.dxf"));
    ASSERT_EQ(areas.size(), 3u);
    for (const auto& [name, size] : drawn) {
        ASSERT_TRUE(areas.contains(name)) << name;
        EXPECT_NEAR(areas.at(name), size, 1e-6 * size) << name << ": the drawing has six decimals";
    }
    EXPECT_NEAR(areas.at("pin"), 100 * std::numbers::pi, 1e-9 * 314);
    EXPECT_NEAR(areas.at("base"), 2400, 1e-9 * 2400);
    for (const SketchEntity& entity : drawing.entities) EXPECT_TRUE(entity.kind == "LINE" || entity.kind == "ARC");
}

TEST_F(Step, TallPartsAreCutAcrossTheirWalls) {
    // The bracket drawn out to a height that no other direction of it has.
    const std::string tall = replaced_all(text_of_file(sketches + "pin_bracket.step"), ",10.))", ",400.))");
    const Drawing drawing = read_text(tall);
    EXPECT_EQ(drawing.cut_at, "z = 200");
    EXPECT_NEAR(areas_of(drawing).at("pin"), 100 * std::numbers::pi, 1e-9 * 314);
}

TEST_F(Step, TurnedPartsAreCutAlongTheirAxis) {
    for (const int axis : {2, 1}) {
        const Drawing drawing = read_step_file(shaft_and_hub, {axis, 0.0});
        const auto areas = areas_of(drawing);
        EXPECT_NEAR(areas.at("shaft"), shaft_area, 1e-9 * shaft_area);
        EXPECT_NEAR(areas.at("ball"), 25 * std::numbers::pi, 1e-9 * 79);
        EXPECT_NEAR(areas.at("hub#0"), 600, 1e-9 * 600);
        EXPECT_NEAR(areas.at("hub#1"), 600, 1e-9 * 600);
        EXPECT_TRUE(has_repair(drawing, "curves of shaft are approximated")) << "the library has no closed form of the fillet";
        EXPECT_EQ(drawing.cut_at, axis == 2 ? "z = 0" : "y = 0");
    }
}

TEST_F(Step, WhatThePlaneDoesNotMeetIsSaid) {
    const Drawing high = read_step_file(shaft_and_hub, {2, 25.0});
    EXPECT_EQ(areas_of(high).size(), 1u);
    EXPECT_EQ(high.counts.at("solid").ignored, 2);
    ASSERT_EQ(high.ignored.size(), 2u);
    EXPECT_EQ(high.ignored[0].what, "solid shaft");
    const Drawing beyond = read_step_file(shaft_and_hub, {2, 100.0});
    ASSERT_EQ(beyond.problems.size(), 1u);
    EXPECT_EQ(beyond.problems[0].what, "the plane z = 100 meets no body");
    EXPECT_EQ(beyond.problems[0].hint, "choose a section; the bodies lie between z = -30 and z = 30");
}

TEST_F(Step, APlaneAlongFacesIsMoved) {
    const Drawing drawing = read_step_file(shaft_and_hub, {0, 35.0});  // the hub's end
    EXPECT_TRUE(has_repair(drawing, "the plane x = 35 runs along faces"));
    const auto areas = areas_of(drawing);
    EXPECT_NEAR(areas.at("hub"), (900 - 100) * std::numbers::pi, 1e-6);
    EXPECT_NEAR(areas.at("shaft"), 100 * std::numbers::pi, 1e-6);
}

TEST_F(Step, NumbersAreInTheUnitOfTheFile) {
    const std::string text = text_of_file(shaft_and_hub);
    const std::string inch = replaced_all(text, "( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) )",
                                          "( CONVERSION_BASED_UNIT('INCH',#90001) LENGTH_UNIT() NAMED_UNIT(#90002) )");
    const std::string with_inch = replaced(inch, "DATA;\n",
                                           "DATA;\n#90001 = LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#90003);\n"
                                           "#90002 = DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n"
                                           "#90003 = ( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) );\n");
    const std::vector<std::pair<std::string, std::string>> files = {
        {"cm", replaced_all(text, "SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT(.CENTI.,.METRE.)")},
        {"m", replaced_all(text, "SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT($,.METRE.)")},
        {"in", with_inch}};
    for (const auto& [unit, file] : files) {
        const Drawing drawing = read_text(file, {2, 0.0});
        EXPECT_EQ(drawing.unit, unit);
        const auto areas = areas_of(drawing);
        EXPECT_NEAR(areas.at("shaft"), shaft_area, 1e-9 * shaft_area) << unit;
        EXPECT_NEAR(areas.at("hub#0"), 600, 1e-9 * 600) << unit;
        EXPECT_EQ(areas_of(read_text(file, {2, 25.0})).size(), 1u) << unit << ": so is the place of the section";
    }
}

TEST_F(Step, WhatIsNoSolidIsSaid) {
    const std::string text = text_of_file(shaft_and_hub);
    const std::size_t shell = text.find("CLOSED_SHELL('',("), comma = text.find(',', shell + 17);
    const Drawing open = read_text(std::string(text).erase(shell + 17, comma + 1 - shell - 17));
    EXPECT_EQ(areas_of(open).count("shaft"), 0u);
    ASSERT_EQ(open.ignored.size(), 1u);
    EXPECT_EQ(open.ignored[0].what, "open shell of shaft");
    const std::size_t solid = text.find("MANIFOLD_SOLID_BREP('',#") + 24;
    const Drawing lost = read_text(std::string(text).replace(solid, text.find(')', solid) - solid, "99999"));
    ASSERT_EQ(lost.problems.size(), 1u);
    EXPECT_NE(lost.problems[0].what.find("cannot be read"), std::string::npos);
    EXPECT_TRUE(has_repair(lost, "entities of the file are damaged"));
}

TEST_F(Step, DamagedFilesAreOneSentence) {
    const std::string text = text_of_file(shaft_and_hub);
    EXPECT_NE(refusal("").find("empty"), std::string::npos);
    EXPECT_NE(refusal("nothing of the kind").find("no STEP"), std::string::npos);
    for (const double part : {0.1, 0.5, 0.9})
        EXPECT_NE(refusal(text.substr(0, static_cast<std::size_t>(part * static_cast<double>(text.size())))).find("damaged"),
                  std::string::npos)
            << part;
    std::mt19937 random(4);
    int n_read = 0;
    for (int round = 0; round < 10; ++round) {
        std::string bytes = text;
        for (int k = 0; k < 5; ++k) bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
        try {
            for (const SketchEntity& entity : read_text(bytes).entities) EXPECT_TRUE(is_finite(entity.curve));
            ++n_read;
        } catch (const InputError& error) { EXPECT_EQ(error.problems().size(), 1u); }
    }
    EXPECT_GT(n_read, 0);
}

TEST_F(Step, AHugeFileIsOneSentence) {
    const TemporaryFile file("huge.step", "ISO-10303-21;");
    std::filesystem::resize_file(file.path(), most_step_bytes + 1);  // takes no room
    try {
        read_step_file(file.path(), {});
        FAIL() << "not refused";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("larger than 256 MB"), std::string::npos) << error.what();
    }
}

TEST(StepFiles, EndingsTell) {
    for (const char* name : {"a.step", "A.STEP", "b/c.stp", "x.STP"}) EXPECT_TRUE(is_step_file(name)) << name;
    for (const char* name : {"a.stl", "step", "a.step.txt", ""}) EXPECT_FALSE(is_step_file(name)) << name;
}

}  // namespace
}  // namespace abut::geometry::step_test
