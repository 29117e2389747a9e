// SPDX-License-Identifier: GPL-3.0-or-later
// What scenes and options say of a drawing's areas and blocks.
#include <gtest/gtest.h>

#include "geometry/brep/input_error.hpp"
#include "src/contact/detect.hpp"
#include "src/inspection/starter_scene.hpp"
#include "src/scene/read_scene.hpp"
#include "src/scene/read_sketch.hpp"
#include "src/scene/scene.hpp"
#include "tests/geometry/dxf/dxf_text.hpp"
#include "tests/src/io/temporary_folder.hpp"

namespace abut::drawn_regions_test {
namespace {

using geometry::dxf_file;
using geometry::dxf_line;
using geometry::dxf_rectangle;

/// A screw of 2 x 10 whose thread crosses its tip, on a table.
std::string screw_on_table() {
    const std::string screw = dxf_rectangle("1", "0", -1, 0, 1, 10) + dxf_line("20", "0", -0.8, 0, -0.8, 8) +
                              dxf_line("21", "0", 0.8, 0, 0.8, 8) + dxf_line("22", "0", -1, 0.5, 1, 0.5) +
                              dxf_line("23", "0", -1, 8, 1, 8);
    return dxf_file(dxf_rectangle("3", "TABLE", -20, -5, 20, 0) + geometry::dxf_insert("40", "SCREW", "M2", 0, 0),
                    geometry::dxf_section("BLOCKS", geometry::dxf_block("M2", 0, 0, screw)));
}

std::string scene_with(const std::string& keys) {
    return R"({"abut": 1, "materials": {"m": {"E": 1, "nu": 0.3}}, "assembly": {"file": "drawing.dxf", "material": "m")" +
           keys + "}}";
}

std::vector<std::string> parts_of_scene(const TemporaryFolder& folder, const std::string& keys) {
    std::vector<std::string> names;
    for (const ScenePart& part : read_scene(folder.write("scene.json", scene_with(keys))).parts) names.push_back(part.name);
    return names;
}

std::string error_of_scene(const TemporaryFolder& folder, const std::string& keys) {
    try {
        read_scene(folder.write("scene.json", scene_with(keys)));
    } catch (const InputError& error) { return error.what(); }
    return {};
}

TEST(DrawnRegions, TheOutlineOfABlockIsAKeyOfScenes) {
    const TemporaryFolder folder;
    folder.write("drawing.dxf", screw_on_table());
    EXPECT_NE(error_of_scene(folder, "").find(R"("block_outline": ["M2"])"), std::string::npos) << error_of_scene(folder, "");
    EXPECT_EQ(parts_of_scene(folder, R"(, "block_outline": ["M*"])"), (std::vector<std::string>{"SCREW", "TABLE"}));
    EXPECT_NE(error_of_scene(folder, R"(, "block_outline": ["M*", "DIN*"])").find("no block that is inserted is called 'DIN*'"),
              std::string::npos);
    EXPECT_NE(error_of_scene(folder, R"(, "block_outline": "M2")").find("/assembly/block_outline"), std::string::npos);
}

TEST(DrawnRegions, OneRegionIsAPieceOfAnother) {
    const TemporaryFolder folder;
    folder.write("drawing.dxf", dxf_file(dxf_rectangle("1", "0", 0, 0, 20, 10) + dxf_line("20", "0", 10, 0, 10, 10)));
    EXPECT_EQ(parts_of_scene(folder, "").size(), 2U);
    EXPECT_EQ(parts_of_scene(folder, R"(, "regions": {"r2": "r1"})"), (std::vector<std::string>{"0"}));
    EXPECT_EQ(parts_of_scene(folder, R"(, "regions": {"r1": "P", "r2": "P"})"), (std::vector<std::string>{"P"}));
}

/// The starter scene says what was joined, and reads to the same parts.
TEST(DrawnRegions, TheStarterSceneNamesWhatIsOne) {
    const TemporaryFolder folder;
    const std::string hatch = geometry::dxf_record("HATCH", "", "H", {{10, 0}, {20, 0}}) + "2\nANSI31\n" +
                              geometry::dxf_groups({{70, 0},
                                                    {91, 1},
                                                    {92, 3},
                                                    {72, 0},
                                                    {73, 1},
                                                    {93, 4},
                                                    {10, 0},
                                                    {20, 0},
                                                    {10, 20},
                                                    {20, 0},
                                                    {10, 20},
                                                    {20, 10},
                                                    {10, 0},
                                                    {20, 10},
                                                    {97, 0}});
    const std::string path =
        folder.write("drawing.dxf", dxf_file(dxf_rectangle("1", "A", 0, 0, 20, 10) + dxf_line("20", "A", 10, 0, 10, 10) +
                                             dxf_rectangle("3", "A", 0, -10, 20, 0) + hatch));
    const ImportOptions options;
    const SketchReading reading = read_sketch(path, options);
    EXPECT_EQ(reading.sketch.parts.size(), 2U);
    const std::string scene = starter_scene(reading, options, detect_contacts(reading.scene, std::nullopt));
    EXPECT_NE(scene.find(R"("r1":"part","r3":"r1")"), std::string::npos) << scene;
}

}  // namespace
}  // namespace abut::drawn_regions_test
