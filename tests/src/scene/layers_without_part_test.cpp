// SPDX-License-Identifier: GPL-3.0-or-later
// Entries of an assembly's parts for layers of its drawing that bound none.
#include <gtest/gtest.h>

#include <algorithm>

#include "src/scene/read_scene.hpp"
#include "src/scene/scene.hpp"
#include "tests/src/io/temporary_folder.hpp"

namespace abut::layers_without_part_test {

TEST(LayersWithoutPart, that_have_an_entry_are_told) {
    const auto line = [](const std::string& layer, double x, double y, double to_x, double to_y) {
        return "0\nLINE\n8\n" + layer + "\n10\n" + std::to_string(x) + "\n20\n" + std::to_string(y) + "\n11\n" +
               std::to_string(to_x) + "\n21\n" + std::to_string(to_y) + "\n";
    };
    const TemporaryFolder folder;
    folder.write("plate.dxf", "0\nSECTION\n2\nENTITIES\n" + line("plate", 0, 0, 9, 0) + line("plate", 9, 0, 9, 5) +
                                  line("plate", 9, 5, 0, 0) + line("bolt", 20, 0, 25, 4) + line("bolt", 25, 4, 30, 4) +
                                  line("DIM", 0, -3, 9, -3) + "0\nENDSEC\n0\nEOF\n");
    const auto read = [&](const std::string& parts) {
        return read_scene(
            folder.write("s.json", R"({"abut": 1, "units": {"length": "mm"}, "materials": {"m": {"E": 1, "nu": 0}},
            "assembly": {"file": "plate.dxf", "material": "m", "parts": {)" +
                                       parts + "}}}"));
    };
    const auto tells = [](const Scene& scene) {
        return std::any_of(scene.warnings.begin(), scene.warnings.end(), [](const std::string& warning) {
            return warning.find("layer 'bolt', which has an entry in parts, bounds no part") != std::string::npos;
        });
    };
    EXPECT_TRUE(tells(read(R"("bolt": {"material": "m"})")));
    EXPECT_FALSE(tells(read(R"("bolt": "ignore")")));
    EXPECT_FALSE(tells(read(R"("plate": {"material": "m"})")));
    try {
        read(R"("DIM": {"material": "m"})");
        ADD_FAILURE() << "no error";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("left out for its name, as drafting"), std::string::npos) << error.what();
    }
}

}  // namespace abut::layers_without_part_test
