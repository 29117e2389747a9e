// SPDX-License-Identifier: GPL-3.0-or-later
// Errors that results state on faces in contact: of the largest stress there, and of the length that sticks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "src/analysis/analysis.hpp"
#include "src/io/whole_file.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::face_estimates_test {
namespace {

const PartResult& part_of(const Result& r, const std::string& name) {
    return *std::find_if(r.parts.begin(), r.parts.end(), [&](const PartResult& p) { return p.name == name; });
}

/// Under Hertz' contact in plane stress the largest von Mises stress of a face is its pressure; a thick part's is as much less.
TEST(FaceEstimates, OfAThickPartUnderAThinRoller) {
    const Result r = test::answer(R"({"abut": 1, "materials": {"m": {"E": 2e5, "nu": 0.3}}, "parts": [
        {"name": "plate", "material": "m", "thickness": 10, "geometry": {"rectangle": {"min": [-20, -20], "max": [20, 0]}}},
        {"name": "roller", "material": "m", "thickness": 2, "geometry": {"circle": {"center": [0, 8], "radius": 8}}}],
        "supports": [{"on": "plate/bottom", "fix": ["x", "y"]}, {"part": "roller", "rigid": {"translation": [0, null], "rotation": 0}}],
        "loads": [{"part": "roller", "force": [0, -600]}]})");
    ASSERT_EQ(r.status, "ok") << r.message;
    const PartResult& plate = part_of(r, "plate");
    EXPECT_LT(plate.max_von_mises_error.value_or(1), 0.05);
    EXPECT_NEAR(plate.max_von_mises.value, 0.2 * r.contacts.at(0).max_pressure.value,
                2 * *plate.max_von_mises_error * plate.max_von_mises.value);
}

/// A foot of aluminium pressed on steel that it sticks to: tractions of friction stretch the face.
TEST(FaceEstimates, OfStressesThatFrictionMakes) {
    const auto foot = [](const std::string& level) {
        return test::answer(R"({"abut": 1, "thickness": 10, "materials": {"steel": {"E": 210000, "nu": 0.3}, "aluminium":
            {"E": 70000, "nu": 0.33}}, "parts": [
            {"name": "block", "material": "steel", "geometry": {"rectangle": {"min": [-50, -30], "max": [50, 0]}}},
            {"name": "foot", "material": "aluminium", "geometry": {"union": [{"circle": {"center": [0, 12], "radius": 12}},
             {"name": "stem", "rectangle": {"min": [-8, 12], "max": [8, 60]}}]}}],
            "supports": [{"on": "block/bottom", "fix": ["x", "y"]}, {"part": "foot", "rigid": {"rotation": 0}}],
            "contacts": {"friction": 0.3}, "loads": [{"on": "foot/stem/top", "force": [60, -3000]}], "accuracy": {"level": ")" +
                            level + R"("}})");
    };
    const Result coarse = foot("draft"), fine = foot("standard");
    ASSERT_EQ(coarse.status, "ok") << coarse.message;
    const PartResult &there = part_of(coarse, "block"), &truth = part_of(fine, "block");
    const double off = std::abs(there.max_von_mises.value / truth.max_von_mises.value - 1);
    EXPECT_GT(off, 0.03);  // or this test shows nothing
    EXPECT_LT(off, 2 * there.max_von_mises_error.value_or(0));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

/// Cattaneo: of equal cylinders sheared by a share of what makes them slip, the root of what is left of 1 sticks.
TEST(FaceEstimates, OfTheLengthThatSticks) {
    const std::string scene = read_whole_file(std::string(ABUT_SOURCE_DIR) + "/data/verification/cattaneo.json");
    for (const double share : {0.1, 0.2, 0.5, 0.8, 0.9}) {
        const std::string at_draft = replaced(replaced(scene, R"("share": 0.5)", R"("share": )" + std::to_string(share)),
                                              R"("target": 0.01)", R"("target": 0.05)");
        const std::vector<CaseResult> steps = analyze_cases(read_scene_text(at_draft, "cattaneo.json"), {});
        const ContactResult& c = steps.at(1).result.contacts.at(0);
        const double sticks = 0.02 * std::sqrt(1 - share);
        ASSERT_TRUE(c.friction && c.friction->stick_length_error) << share;
        EXPECT_LT(std::abs(c.friction->stick_length - sticks), 1.5 * *c.friction->stick_length_error) << share;
        EXPECT_LE(*c.friction->stick_length_error, c.contact_length * (1 + 1e-12)) << share;
    }
}

}  // namespace
}  // namespace abut::face_estimates_test
