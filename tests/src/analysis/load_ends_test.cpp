// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/load_ends.hpp"

#include <gtest/gtest.h>

#include "src/scene/read_scene.hpp"

namespace abut::load_ends_test {
namespace {

/// A block whose face has three edges: up to 5, up to 2 (both from the right), and the rest.
std::vector<LoadEnd> ends_with(const std::string& loads) {
    const Scene scene = read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}},
        "parts": [{"name": "b", "material": "m",
                   "geometry": {"polygon": [[0, 0], [10, 0], [10, 4], [5, 4], [2, 4], [0, 4]]}}],
        "supports": [{"on": "b/e0", "fix": ["x", "y"]}], "loads": )" +
                                            loads + "}",
                                        "test.json");
    return load_ends(scene, resolve_conditions(scene), SolvedAssembly(), 0);
}

TEST(LoadEnds, APressureEndsWithinAFace) {
    const std::vector<LoadEnd> ends = ends_with(R"([{"on": "b/e3", "pressure": 7}])");
    ASSERT_EQ(ends.size(), 2U);
    EXPECT_EQ(ends[0].at, Vec2(5, 4));
    EXPECT_EQ(ends[1].at, Vec2(2, 4));
    EXPECT_NEAR((ends[0].jump - Vec2(0, -7)).norm(), 0, 1e-12);
    EXPECT_NEAR((ends[1].jump - Vec2(0, 7)).norm(), 0, 1e-12);
}

TEST(LoadEnds, CornersAreNone) {
    const std::vector<LoadEnd> ends = ends_with(R"([{"on": "b/e2", "traction": [1, 0]}])");
    ASSERT_EQ(ends.size(), 1U);
    EXPECT_EQ(ends[0].at, Vec2(5, 4));
}

TEST(LoadEnds, ALoadThatAnotherOneGoesOnWithHasNone) {
    EXPECT_EQ(ends_with(R"([{"on": "b/e2", "pressure": 3}, {"on": "b/e3", "traction": [0, -3]}])").size(), 1U);
    EXPECT_EQ(ends_with(R"([{"on": ["b/e2", "b/e3", "b/e4"], "pressure": 3}])").size(), 0U);
}

TEST(LoadEnds, LoadsOnVolumesHaveNone) {
    EXPECT_EQ(ends_with(R"([{"part": "b", "force": [1, 2]}])").size(), 0U);
}

}  // namespace
}  // namespace abut::load_ends_test
