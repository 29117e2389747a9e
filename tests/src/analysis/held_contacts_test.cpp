// SPDX-License-Identifier: GPL-3.0-or-later
// What the analysis says of supports on contacts, and of touches that it cannot couple.
#include "src/analysis/held_contacts.hpp"

#include <gtest/gtest.h>

#include "src/analysis/analysis.hpp"
#include "src/contact/detect.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::held_contacts_test {
namespace {

/// Parts by name and geometry, with more members of the scene.
Scene scene_of(const std::string& parts, const std::string& more = "") {
    return read_scene_text(
        R"({"abut": 1, "units": {"length": "mm", "force": "N"}, "materials": {"m": {"E": 1e5, "nu": 0.3}}, "parts": [)" +
            parts + "]" + more + "}",
        "scene.json");
}

std::string part(const std::string& name, const std::string& geometry) {
    return R"({"name": ")" + name + R"(", "material": "m", "geometry": )" + geometry + "}";
}

std::string block(const std::string& name, const std::string& min, const std::string& max) {
    return part(name, R"({"rectangle": {"min": )" + min + R"(, "max": )" + max + "}}");
}

const std::string base = block("base", "[-9, -9]", "[9, 0]");

std::vector<std::string> warnings_with(const std::string& word, const Scene& scene) {
    std::vector<std::string> found;
    for (const std::string& warning : analyze(scene, {}).warnings)
        if (warning.find(word) != std::string::npos) found.push_back(warning);
    return found;
}

std::string conditions(const std::string& supports) {
    return R"(, "supports": [{"on": "base/bottom", "fix": ["x", "y"]}, )" + supports +
           R"(], "loads": [{"on": "b/top", "pressure": 1}], "accuracy": {"level": "draft"})";
}

TEST(HeldContacts, ASupportOnAContactIsAWarning) {
    const std::string parts = base + "," + block("b", "[0, 0]", "[4, 2]"), glide = R"({"on": "b/left", "fix": ["x"]})";
    const auto held = [&](const std::string& supports) {
        return warnings_with("touches it", scene_of(parts, conditions(supports)));
    };
    const std::vector<std::string> both = held(R"({"on": "b/bottom", "fix": ["x", "y"]})");
    ASSERT_EQ(both.size(), 1U);
    for (const char* word : {"support 2", "holds part b where base touches it", "rigid"})
        EXPECT_NE(both[0].find(word), std::string::npos) << both[0];
    EXPECT_EQ(held(R"({"on": "b/bottom", "symmetry": true}, )" + glide).size(), 1U);
    EXPECT_EQ(held(R"({"on": "base/top", "fix": ["y"]}, )" + glide).size(), 1U);
    // as it should be: along the contact, across an edge that only meets it in a corner, elsewhere on the same edge
    EXPECT_TRUE(held(glide).empty());
    EXPECT_TRUE(held(R"({"on": "b/bottom", "fix": ["x"]})").empty());
    EXPECT_TRUE(held(R"({"on": {"part": "base", "box": [[-9, -1], [-2, 1]]}, "fix": ["y"]}, )" + glide).empty());
}

/// A cam lifts a follower, guided by its motion, against a spring: no load acts, and no force is along the guide.
TEST(HeldContacts, DisplacementsAloneDriveACamAndItsFollower) {
    const Result r =
        analyze(scene_of(R"({"name": "cam", "material": "rigid", "geometry": {"circle": {"center": [0, 0], "radius": 30}}},)" +
                             block("follower", "[-20, 30]", "[20, 36]"),
                         R"(, "supports": [{"part": "cam", "rigid": {"translation": [0, 0.5], "rotation": 0}},
                     {"on": "follower/top", "spring": {"normal": 2}},
                     {"part": "follower", "rigid": {"translation": [0, null], "rotation": 0}}], "thickness": 10)"),
                {});
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_NEAR(r.contacts.at(0).force.norm(), 2 * 40 * 10 * 0.5, 6);  // less what the follower gives way
    EXPECT_NEAR((r.reactions.at(0).force + r.reactions.at(1).force).norm(), 0, 1e-9);
}

TEST(HeldContacts, ALoadOnAHeldEdgeIsAWarning) {
    const auto told = [](const std::string& on) {
        return warnings_with("it goes into the support",
                             scene_of(block("b", "[0, 0]", "[4, 2]"),
                                      R"(, "supports": [{"on": "b/bottom", "fix": ["x", "y"]}, {"on": "b/left", "fix": ["x"]}],
                                          "loads": [{"on": "b/top", "pressure": 1}, {"on": )" +
                                          on + R"(, "force": [1, 1]}])"));
    };
    const std::vector<std::string> held = told(R"("b/bottom")");
    ASSERT_EQ(held.size(), 1U);
    EXPECT_EQ(held[0].find("load 2 acts where support 1 (fix x, y on b/bottom) holds part b"), 0U) << held[0];
    EXPECT_EQ(told(R"({"part": "b", "box": [[1, -1], [2, 1]]})").size(), 1U);
    EXPECT_TRUE(told(R"("b/left")").empty());
    EXPECT_TRUE(told(R"(["b/bottom", "b/right"])").empty());
}

TEST(UnpairedTouches, ASharpCornerOnAFaceIsAWarning) {
    const std::string wedge = part("b", R"({"polygon": [[0, 0], [0.3, 1], [-0.3, 1]]})");
    const Scene scene = scene_of(base + "," + wedge, R"(, "supports": [{"on": "base/bottom", "fix": ["x", "y"]},
        {"on": "b/*", "fix": ["x", "y"]}], "loads": [{"on": "base/top", "pressure": 1}], "accuracy": {"level": "draft"})");
    EXPECT_EQ(detect_contacts(scene, std::nullopt).pairs.size(), 1U);
    EXPECT_EQ(warnings_with("no faces oppose each other", scene).size(), 1U);
}

}  // namespace
}  // namespace abut::held_contacts_test
