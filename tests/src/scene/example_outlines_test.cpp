// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of every scene of data/ have outlines that exact arithmetic finds right.
#include <gtest/gtest.h>

#include <filesystem>

#include "geometry/csg/exact_outline.hpp"
#include "src/scene/read_scene.hpp"

namespace example_outlines_test {

namespace {

TEST(ExampleScenes, OutlinesAreExactlyRight) {
    int n_scenes = 0, n_parts = 0;
    for (const char* folder : {"scenes", "verification"})
        for (const auto& entry :
             std::filesystem::directory_iterator(std::filesystem::path(ABUT_SOURCE_DIR) / "data" / folder)) {
            if (entry.path().extension() != ".json") continue;
            ++n_scenes;
            for (const abut::ScenePart& part : abut::read_scene(entry.path().string()).parts) {
                EXPECT_FALSE(abut::geometry::exact_fault(part.part)) << entry.path() << ": " << part.name;
                ++n_parts;
            }
        }
    EXPECT_GT(n_scenes, 40);
    EXPECT_GT(n_parts, n_scenes);
}

}  // namespace

}  // namespace example_outlines_test
