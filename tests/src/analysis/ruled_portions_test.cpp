// SPDX-License-Identifier: GPL-3.0-or-later
// Rules for edges at a place mean the portions that they select in the drawing, wherever parts go and however they bend.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "src/analysis/analysis.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::ruled_portions_test {
namespace {

std::string rectangle(const std::string& name, const std::string& min, const std::string& max) {
    return R"({"name": ")" + name + R"(", "material": "m", "geometry": {"rectangle": {"min": )" + min + R"(, "max": )" + max +
           "}}}";
}

Result answer(const std::string& parts, const std::string& rule, const std::string& conditions) {
    return analyze(read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [)" + parts +
                                       R"(], "contacts": {"pairs": [)" + rule + "]}, " + conditions + "}",
                                   "s.json"),
                   {});
}

}  // namespace

/// A strip that is bonded on half of its length bends beside it, as one whose edge was drawn in two does.
TEST(RuledPortions, ABondOnHalfAnEdgeLeavesTheOtherHalf) {
    const std::string base = rectangle("base", "[0, 0]", "[100, 20]");
    const std::string peel =
        R"("supports": [{"on": "base/bottom", "fix": ["x", "y"]}], "loads": [{"on": "strip/right", "force": [0, 1]}])";
    const Result ruled =
        answer(base + ", " + rectangle("strip", "[0, 20]", "[100, 24]"),
               R"({"between": ["base/top", {"part": "strip", "box": [[-1, 19], [50, 21]]}], "kind": "bonded"})", peel);
    const Result split = answer(base + R"(, {"name": "strip", "material": "m", "geometry": {"loops": [[
            {"name": "held", "line": {"from": [0, 20], "to": [50, 20]}}, {"name": "free", "line": {"from": [50, 20], "to": [100, 20]}},
            {"name": "right", "line": {"from": [100, 20], "to": [100, 24]}}, {"name": "top", "line": {"from": [100, 24], "to": [0, 24]}},
            {"name": "left", "line": {"from": [0, 24], "to": [0, 20]}}]]}})",
                                R"({"between": ["base/top", "strip/held"], "kind": "bonded"})", peel);
    ASSERT_EQ(ruled.status, "ok") << ruled.message;
    ASSERT_EQ(split.status, "ok") << split.message;
    const double beam = 50.0 * 50 * 50 / (3 * 210000 * 4 * 4 * 4 / 12.0), tip = ruled.parts[1].max_displacement.value;
    EXPECT_GT(tip, beam) << "the clamp gives";
    EXPECT_LT(tip, 1.25 * beam);
    EXPECT_NEAR(tip, split.parts[1].max_displacement.value, 1e-6 * tip);
}

/// A block that falls onto its base takes its friction along, by whatever it was selected.
TEST(RuledPortions, GoWithThePart) {
    const std::string parts = rectangle("base", "[-100, -20]", "[100, 0]") + ", " + rectangle("block", "[-10, 30]", "[10, 50]");
    const std::string drop =
        R"("supports": [{"on": "base/bottom", "fix": ["x", "y"]}], "loads": [{"part": "block", "force": [30, -100]}])";
    for (const char* bottom :
         {R"("block/bottom")", R"({"part": "block", "near": [0, 30]})", R"({"part": "block", "box": [[-11, 29], [11, 31]]})",
          R"({"part": "block", "facing": [0, -1]})"}) {
        const Result r = answer(parts, R"({"between": ["base/top", )" + std::string(bottom) + R"(], "friction": 0.5})", drop);
        ASSERT_EQ(r.status, "ok") << bottom << ": " << r.message;
        ASSERT_EQ(r.contacts.size(), 1u) << bottom;
        EXPECT_NEAR(r.contacts[0].force.x(), 30, 1e-6) << bottom;
        EXPECT_NEAR(r.contacts[0].force.y(), -100, 1e-6) << bottom;
    }
}

/// A leaf that bends out of the box by which it was bonded stays bonded.
TEST(RuledPortions, AreThoseOfTheDrawingWherePartsBend) {
    for (const double force : {50.0, 100.0}) {
        const Result r = answer(
            rectangle("long", "[0, 0]", "[100, 4]") + ", " + rectangle("short", "[0, -4]", "[70, 0]"),
            R"({"between": [{"part": "long", "box": [[69.7, -0.1], [70, 0.1]]}, {"part": "short", "box": [[69.7, -0.1], [70, 0.1]]}],
                "kind": "bonded"})",
            R"("thickness": 20, "supports": [{"on": ["long/left", "short/left"], "fix": ["x", "y"]}],
               "loads": [{"on": "long/right", "force": [0, )" +
                std::to_string(-force) + "]}]");
        ASSERT_EQ(r.status, "ok") << r.message;
        double bonded = 0;
        for (const ContactResult& c : r.contacts) bonded += c.kind == "bonded" ? c.force.norm() : 0;
        EXPECT_NEAR(bonded / force, 11.9, 0.5);  // linear
    }
}

/// A slit ring whose slit is bonded is whole, pulled or pressed; an interference presses its slit without any load.
TEST(RuledPortions, OfOnePartWithItself) {
    const auto ring = [](const std::string& rule, double force) {
        return answer(
            R"({"name": "ring", "material": "m", "geometry": {"difference": [{"circle": {"center": [0, 0], "radius": 30}},
                {"circle": {"center": [0, 0], "radius": 26}}, {"rectangle": {"min": [20, -0.1], "max": [40, 0.1]}}]}})",
            R"({"between": ["ring/bottom", "ring/top"], )" + rule + "}",
            R"("thickness": 10, "supports": [{"part": "ring", "at": [-28, 0], "fix": ["x", "y"]},
                            {"part": "ring", "at": [-26.5, 0], "fix": ["y"]}],
                         "loads": [{"on": {"part": "ring", "box": [[-1, 29], [1, 31]]}, "force": [0, )" +
                std::to_string(force) + R"(]}, {"on": {"part": "ring", "box": [[-1, -31], [1, -29]]}, "force": [0, )" +
                std::to_string(-force) + "]}]");
    };
    const Result pulled = ring(R"("kind": "bonded")", 50), pressed = ring(R"("kind": "bonded")", -50);
    ASSERT_EQ(pulled.status, "ok") << pulled.message;
    ASSERT_EQ(pulled.contacts.size(), 1u);
    ASSERT_EQ(pressed.contacts.size(), 1u);
    EXPECT_NEAR(pulled.contacts[0].force.y(), -pressed.contacts[0].force.y(), 1e-6 * 25);
    EXPECT_NEAR(std::abs(pulled.contacts[0].force.y()), 25, 0.1) << "half of the load";
    EXPECT_NEAR(pulled.parts[0].max_displacement.value, pressed.parts[0].max_displacement.value, 1e-4);
    const Result fitted = ring(R"("interference": 0.3)", 0);
    ASSERT_EQ(fitted.contacts.size(), 1u);
    EXPECT_GT(fitted.contacts[0].force.norm(), 5) << "0.1 are to be opened, by 10 N for 0.185";
    EXPECT_LT(fitted.contacts[0].force.norm(), 6.5);
}

}  // namespace abut::ruled_portions_test
