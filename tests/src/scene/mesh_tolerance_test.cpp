// SPDX-License-Identifier: GPL-3.0-or-later
// The tolerance of a mesh is in the scene's unit, whatever the file's is, and counts to its last digit.
#include <gtest/gtest.h>

#include <string>

#include "src/scene/read_scene.hpp"
#include "src/scene/scene.hpp"
#include "tests/geometry/mesh/small_meshes.hpp"
#include "tests/src/io/temporary_folder.hpp"

namespace abut::mesh_tolerance_test {
namespace {

/// A plate of 200 mm x 100 mm with a notch of 5 mm, in a file of inches.
std::string plate() {
    constexpr double mm = 1 / 25.4;
    const geometry::Mesh mesh = geometry::prism({{0, 0},
                                                 {200 * mm, 0},
                                                 {200 * mm, 100 * mm},
                                                 {105 * mm, 100 * mm},
                                                 {105 * mm, 95 * mm},
                                                 {100 * mm, 95 * mm},
                                                 {100 * mm, 100 * mm},
                                                 {0, 100 * mm}},
                                                0, 10 * mm, "plate");
    return geometry::three_mf_bytes("inch", geometry::three_mf_object(1, mesh), "<item objectid=\"1\"/>");
}

double area_with(const std::string& tolerance) {
    const TemporaryFolder folder;
    folder.write("plate.3mf", plate());
    const Scene scene = read_scene(folder.write("scene.json", R"({"abut": 1, "units": {"length": "mm", "force": "N"},
        "materials": {"m": {"E": 1, "nu": 0}},
        "assembly": {"file": "plate.3mf", "material": "m", "tolerance": )" +
                                                                  tolerance + "}}"));
    return area(scene.parts.at(0).part);
}

}  // namespace

TEST(MeshTolerance, IsInTheUnitOfTheScene) {
    EXPECT_NEAR(area_with("1"), 200 * 100 - 25, 0.1);  // an inch would swallow the notch
    EXPECT_NEAR(area_with("\"0.1 cm\""), 200 * 100 - 25, 0.1);
}

}  // namespace abut::mesh_tolerance_test
