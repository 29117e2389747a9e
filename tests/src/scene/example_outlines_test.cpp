// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of every scene of data/ have outlines that exact arithmetic finds right.
#include <gtest/gtest.h>

#include <filesystem>

#include "geometry/csg/exact_count.hpp"
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

/// Reading a scene, which every command does first, puts each outline of it through CGAL once: each loop of each part is one
/// that was looked at or made there.
TEST(ExampleScenes, OutlinesGoThroughExactArithmetic) {
    int n_scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(ABUT_SOURCE_DIR) / "data" / "scenes")) {
        if (entry.path().extension() != ".json") continue;
        ++n_scenes;
        const long before = abut::geometry::n_exact_loops();
        const abut::Scene scene = abut::read_scene(entry.path().string());
        long n_loops = 0;
        for (const abut::ScenePart& part : scene.parts) n_loops += static_cast<long>(part.part.loops.size());
        EXPECT_GT(n_loops, 0) << entry.path();
        EXPECT_EQ(abut::geometry::n_exact_loops() - before, n_loops) << entry.path();
    }
    EXPECT_GE(n_scenes, 20);
}

}  // namespace

}  // namespace example_outlines_test
