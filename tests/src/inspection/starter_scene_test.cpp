// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/inspection/starter_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "geometry/brep/input_error.hpp"
#include "src/analysis/analysis.hpp"
#include "src/contact/guessed_levels.hpp"
#include "src/scene/read_scene.hpp"
#include "src/scene/read_sketch.hpp"
#include "src/scene/unit.hpp"
#include "tests/geometry/dxf/dxf_text.hpp"
#include "tests/src/io/temporary_folder.hpp"

namespace abut::starter_scene_test {
namespace {

using geometry::dxf_file;
using geometry::dxf_rectangle;
using geometry::dxf_section;

const std::string source = ABUT_SOURCE_DIR;
const std::string pin_bracket = source + "/data/sketches/pin_bracket_r14.dxf";

/// Two blocks, one on the other.
const std::string stack = dxf_rectangle("A", "base", 0, 0, 40, 10) + dxf_rectangle("B", "top", 10, 10, 30, 20);

/// Bricks that stand for the two blocks, 4 high, as an OBJ file.
std::string brick(const std::string& name, double x0, double y0, double x1, double y1, int first) {
    std::string text = "o " + name + "\n";
    for (const double z : {0.0, 4.0})
        for (const auto& [x, y] : {std::pair(x0, y0), std::pair(x1, y0), std::pair(x1, y1), std::pair(x0, y1)})
            text += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
    for (const auto& [a, b, c, d] : {std::array{4, 3, 2, 1}, std::array{5, 6, 7, 8}, std::array{1, 2, 6, 5},
                                     std::array{2, 3, 7, 6}, std::array{3, 4, 8, 7}, std::array{4, 1, 5, 8}}) {
        text += "f";
        for (const int v : {a, b, c, d}) text += " " + std::to_string(first + v);
        text += "\n";
    }
    return text;
}
const std::string bricks = brick("base", 0, 0, 40, 10, 0) + brick("top", 10, 10, 30, 20, 8);

std::string starter(const std::string& path, const ImportOptions& options = {}) {
    const SketchReading reading = read_sketch(path, options);
    EXPECT_TRUE(reading.sketch.problems.empty());
    return starter_scene(reading, options, detect_contacts(reading.scene, std::nullopt));
}

void replace(std::string& text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    ASSERT_NE(at, std::string::npos) << what << " in\n" << text;
    text.replace(at, what.size(), by);
}

/// Does what the scene says: puts the examples in place of the texts. Draft accuracy, to be quick.
std::string filled_in(std::string text) {
    for (const char* what : {"hold", "load"}) {
        const std::string blank = std::string("\"FILL IN an edge to ") + what + "\"", hint = "// for instance \"on\": ";
        const std::size_t at = text.find(hint, text.find(blank)) + hint.size();
        replace(text, blank, text.substr(at, text.find('\n', at) - at));
    }
    replace(text, "\"abut\": 1,", "\"abut\": 1, \"accuracy\": {\"level\": \"draft\"},");
    return text;
}

/// The faults of a scene's text, one line each.
std::vector<std::string> faults(const std::string& path) {
    std::vector<std::string> lines;
    try {
        analyze(read_scene(path), {});
    } catch (const InputError& error) {
        for (const Problem& problem : error.problems()) lines.push_back(one_line(problem));
    }
    return lines;
}

bool has(const std::string& text, const std::string& piece) {
    return text.find(piece) != std::string::npos;
}

void expect_runs(const std::string& path, double thickness_times_force) {
    const Result result = analyze(read_scene(path), {});
    EXPECT_EQ(result.status, "ok") << result.message;
    ASSERT_EQ(result.reactions.size(), 1u);
    EXPECT_NEAR(result.reactions[0].force.y(), thickness_times_force, 1e-6 * thickness_times_force);
    EXPECT_TRUE(std::any_of(result.contacts.begin(), result.contacts.end(), [&](const ContactResult& c) {
        return std::abs(std::abs(c.force.y()) - thickness_times_force) < 1e-3 * thickness_times_force;
    }));
}

TEST(StarterScene, GuessedLevelsStandWithTheParts) {
    const TemporaryFolder folder;
    const std::string lap = dxf_rectangle("A", "LEFT", 0, 0, 60, 20) + geometry::dxf_circle("A4", "LEFT", 50, 10, 4) +
                            dxf_rectangle("B", "RIGHT", 40, 0, 99, 20) + geometry::dxf_circle("B4", "RIGHT", 50, 10, 4) +
                            geometry::dxf_circle("C", "PIN", 50, 10, 4);
    SketchReading reading = read_sketch(folder.write("lap.dxf", dxf_file(lap)), {});
    take_guessed_levels(reading.scene);
    const std::string scene = starter_scene(reading, {}, detect_contacts(reading.scene, std::nullopt));
    for (const char* words :
         {R"("LEFT": {"material": "steel", "level": 1})", R"("RIGHT": {"material": "steel", "level": 2})",
          R"("PIN": {"material": "steel", "level": [1, 2]})", "check \"level\"", "LEFT/hA4 and PIN/hC: pin-in-hole"})
        EXPECT_NE(scene.find(words), std::string::npos) << words << " in\n" << scene;
    EXPECT_EQ(scene.find("LEFT/hA4 and RIGHT"), std::string::npos);
    EXPECT_EQ(starter(folder.write("stack.dxf", dxf_file(stack))).find("level"), std::string::npos);
}

TEST(StarterScene, RunsOnceASupportAndALoadAreFilledIn) {
    const TemporaryFolder folder;
    const std::string drawing = folder.write("stack.dxf", dxf_file(stack)), mesh = folder.write("stack.obj", bricks);
    for (const std::string& file : {drawing, mesh, pin_bracket}) {
        SCOPED_TRACE(file);
        expect_runs(folder.write("scene.json", filled_in(starter(file))), 100);
    }
}

TEST(StarterScene, SaysWhatToFillIn) {
    const TemporaryFolder folder;
    const std::string drawing = folder.write("stack.dxf", dxf_file(stack));
    const std::string text = starter(drawing);
    const std::vector<std::string> lines = faults(folder.write("scene.json", text));
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_TRUE(has(lines[0], "/supports/0/on") && has(lines[0], "FILL IN an edge to hold")) << lines[0];
    EXPECT_TRUE(has(lines[1], "/loads/0/on") && has(lines[1], "FILL IN an edge to load")) << lines[1];
    for (const char* word : {"base/hA0", "top/hB2", "base/hA2 and top/hB0: flat-on-flat, touching"})
        EXPECT_TRUE(has(text, word)) << word;
    EXPECT_EQ(faults(folder.write("filled.json", filled_in(text))), std::vector<std::string>());
}

TEST(StarterScene, StatesUnitsAsTheyAreMeant) {
    const TemporaryFolder folder;
    const std::string inches = dxf_section("HEADER", "9\n$INSUNITS\n70\n1\n");
    const std::string with = folder.write("with.dxf", dxf_file(stack, inches)),
                      without = folder.write("without.dxf", dxf_file(stack));
    ImportOptions options;
    EXPECT_TRUE(has(starter(with), R"("units": {"length": "in", "force": "lbf"})"));
    EXPECT_TRUE(has(starter(without), R"({"length": "mm", "force": "N"},  // the file states no unit)"));
    options.units = "m";
    EXPECT_TRUE(has(starter(without, options), R"({"length": "m", "force": "N"},)"));
    for (const std::string& file : {with, without}) {  // whatever is stated, the scene's parts have the file's numbers
        for (const std::string unit : {"", "in", "mm", "ft", "dm", "yd"}) {
            options.units = unit;
            const Scene scene = read_scene(folder.write("scene.json", filled_in(starter(file, options))));
            ASSERT_EQ(scene.parts.size(), 2u);
            EXPECT_NEAR(area(scene.parts[0].part), 400, 1e-9) << file << " in " << unit;
            const SceneUnits units{!unit.empty() ? unit : file == with ? "in" : "mm", scene.force_unit};
            EXPECT_NEAR(scene.materials[0].E / unit_factor("Pa", dimension::stress, units), 210e9, 1) << file << " in " << unit;
        }
    }
}

TEST(StarterScene, KeepsTheOptionsThatTheFileWasReadWith) {
    const TemporaryFolder folder;
    const std::string open = geometry::dxf_line("1", "base", 0, 0, 40, 0) + geometry::dxf_line("2", "base", 40.02, 0, 40, 10) +
                             geometry::dxf_line("3", "base", 40, 10, 0, 10) + geometry::dxf_line("4", "base", 0, 10, 0, 0) +
                             dxf_rectangle("B", "top", 10, 10, 30, 20);
    ImportOptions options;
    options.tolerance = 0.05;
    const std::string drawing = folder.write("open.dxf", dxf_file(open)), mesh = folder.write("stack.obj", bricks);
    EXPECT_EQ(read_scene(folder.write("scene.json", filled_in(starter(drawing, options)))).parts.size(), 2u);

    ImportOptions lengthwise;
    lengthwise.section.axis = 1;
    lengthwise.section.at = 5;
    const Scene scene = read_scene(folder.write("scene.json", filled_in(starter(mesh, lengthwise))));
    ASSERT_EQ(scene.parts.size(), 1u);
    EXPECT_NEAR(area(scene.parts[0].part), 40 * 4, 1e-9);
}

TEST(StarterScene, NamesOfAnyKindStayInTheirPlace) {
    const TemporaryFolder folder;
    for (const std::string name : {"a \"b\"", "a\\b", "// x", "*/ x", "零件", "a b#1", "FILL IN"}) {
        const std::string file = folder.write(
            "odd.dxf", dxf_file(dxf_rectangle("A", name, 0, 0, 40, 10) + dxf_rectangle("B", "top", 10, 10, 30, 20)));
        const std::string path = folder.write("scene.json", filled_in(starter(file)));
        EXPECT_EQ(faults(path), std::vector<std::string>()) << name;
    }
}

}  // namespace
}  // namespace abut::starter_scene_test
