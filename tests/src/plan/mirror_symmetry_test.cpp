// SPDX-License-Identifier: GPL-3.0-or-later
// Mirror symmetry of scenes: found where it is, and what breaks it is named.
#include "src/plan/mirror_symmetry.hpp"

#include <gtest/gtest.h>

#include "src/scene/read_scene.hpp"

namespace abut::mirror_symmetry_test {
namespace {

MirrorSymmetry of(const std::string& parts, const std::string& supports, const std::string& loads,
                  const std::string& more = "") {
    const Scene scene =
        read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3, "density": 1}, "n": {"E": 2e5, "nu": 0.3}},
        "parts": [)" + parts +
                            R"(], "supports": [)" + supports + R"(], "loads": [)" + loads + "]" + more + "}",
                        "scene.json");
    return find_mirror_symmetry(scene, resolve_conditions(scene));
}

std::string block(const std::string& name, const std::string& min, const std::string& max, const std::string& material = "m") {
    return R"({"name": ")" + name + R"(", "material": ")" + material + R"(", "geometry": {"rectangle": {"min": )" + min +
           R"(, "max": )" + max + "}}}";
}

const std::string pair =
    block("left", "[1, 0]", "[2, 1]") + ", " + block("right", "[4, 0]", "[5, 1]") + ", " + block("beam", "[0, 1]", "[6, 2]");
const std::string held = R"({"on": ["left/bottom", "right/bottom"], "fix": ["x", "y"]})";
const std::string pressed = R"({"on": "beam/top", "pressure": "10 + (x - 3)^2"})";

TEST(MirrorSymmetry, IsFoundWithTheImagesOfParts) {
    const MirrorSymmetry s = of(pair, held, pressed);
    ASSERT_TRUE(s.found) << s.why_not;
    EXPECT_NEAR(s.line.point.x(), 3, 1e-12);
    EXPECT_EQ(s.line.along, Vec2(0, 1));
    EXPECT_EQ(s.line.image, (std::vector<int>{1, 0, 2}));
    EXPECT_NE(symmetry_text(s, false).find("mirror symmetric about x = 3 "), std::string::npos);
    const MirrorSymmetry level = of(block("bar", "[0, -1]", "[9, 1]"), R"({"on": "bar/left", "fix": ["x", "y"]})",
                                    R"({"on": "bar/right", "traction": [5, "0.1*y"]})");
    ASSERT_TRUE(level.found) << level.why_not;
    EXPECT_EQ(level.line.along, Vec2(1, 0));
}

TEST(MirrorSymmetry, WhatBreaksItIsNamed) {
    struct Case {
        std::string parts, supports, loads, more, why;
    };
    const std::string stiffer = block("left", "[1, 0]", "[2, 1]", "n") + ", " + block("right", "[4, 0]", "[5, 1]") + ", " +
                                block("beam", "[0, 1]", "[6, 2]");
    const std::string longer = block("left", "[1, 0]", "[2.000001, 1]") + ", " + block("right", "[4, 0]", "[5, 1]") + ", " +
                               block("beam", "[0, 1]", "[6, 2]");
    for (const Case& c : std::vector<Case>{
             {stiffer, held, pressed, "", "part left has no mirror image"},
             {longer, held, pressed, "", "part left has no mirror image"},
             {pair, R"({"on": "left/bottom", "fix": ["x", "y"]}, {"on": "right/bottom", "fix": ["y"]})", pressed, "",
              "support 0 (fix x, y on left/bottom) has no mirror image at ("},
             {pair,
              held + R"(, {"on": "beam/left", "displacement": {"x": 0.1}}, {"on": "beam/right", "displacement": {"x": 0.1}})",
              pressed, "", "support 1 "},
             {pair, held + R"(, {"on": "beam/left", "spring": {"normal": 5}}, {"on": "beam/right", "spring": {"normal": 6}})",
              pressed, "", "support 1 "},
             {pair, held + R"(, {"part": "beam", "rigid": {"translation": [0.1, null], "rotation": null}})", pressed, "",
              "support 1 "},
             {pair, held, R"({"on": "beam/top", "pressure": "10 + x"})", "", "load 0 has no mirror image at ("},
             {pair, held, R"({"on": {"part": "beam", "box": [[0, 1.9], [3, 2.1]]}, "pressure": 1})", "", "load 0 "},
             {pair, held, R"({"on": "beam/top", "traction": [1, 0]})", "", "load 0 "},
             {pair, held, R"({"part": "left", "body_force": [0, 1]})", "", "the forces in part left have no mirror image"},
             {pair, held, pressed,
              R"(, "contacts": {"pairs": [{"between": ["left/top", "beam/bottom"], "interference": 0.1}]})",
              "rule 0 of contacts.pairs has no mirror image"},
         }) {
        const MirrorSymmetry s = of(c.parts, c.supports, c.loads, c.more);
        EXPECT_FALSE(s.found) << c.why;
        EXPECT_NE(s.why_not.find(c.why), std::string::npos) << s.why_not << "\nnot: " << c.why;
    }
}

TEST(MirrorSymmetry, MirroredValuesAreSymmetric) {
    for (
        const std::string more :
        {R"(, {"on": "beam/left", "displacement": {"x": 0.1}}, {"on": "beam/right", "displacement": {"x": -0.1}})",
         R"(, {"on": "beam/left", "displacement": {"x": 0, "y": 0.1}}, {"on": "beam/right", "displacement": {"x": 0, "y": 0.1}})",
         R"(, {"on": ["beam/left", "beam/right"], "spring": {"normal": 5, "tangential": 1}})",
         R"(, {"part": "beam", "rigid": {"translation": [0, -0.1], "rotation": 0}})"}) {
        const MirrorSymmetry s = of(pair, held + more, pressed);
        EXPECT_TRUE(s.found) << more << ": " << s.why_not;
    }
    const MirrorSymmetry gravity =
        of(block("a", "[0, 0]", "[2, 1]"), R"({"on": "a/bottom", "fix": ["x", "y"]})",
           R"({"gravity": [0, -9]}, {"part": "a", "body_force": ["x - 1", 0]}, {"on": "a/left", "traction": [1, 0]},
                                         {"on": "a/right", "traction": [-1, 0]})");
    EXPECT_TRUE(gravity.found) << gravity.why_not;
}

}  // namespace
}  // namespace abut::mirror_symmetry_test
