// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/needed_friction.hpp"

#include <gtest/gtest.h>

#include "tests/verification/scene_answers.hpp"

namespace abut::needed_friction_test {
namespace {

/// A block on a base, pressed down by 1000 and pushed aside; more: supports and contacts.
Result block(double push, const std::string& supports, const std::string& contacts = "") {
    return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "base", "material": "m", "geometry": {"rectangle": {"min": [-50, -20], "max": [50, 0]}}},
        {"name": "block", "material": "m", "geometry": {"rectangle": {"min": [-15, 0], "max": [15, 20]}}}],
        "supports": [{"on": "base/bottom", "fix": ["x", "y"]})" +
                        supports +
                        R"(], "loads": [{"on": "block/top", "force": [0, -1000]}, {"on": "block/bottom", "force": [)" +
                        test::number(push) + R"(, 0]}], "accuracy": {"level": "draft"})" + contacts + "}");
}

/// The note on the block's supports, if there is one.
std::string note_of(const Result& r) {
    for (const std::string& note : r.notes)
        if (note.find("in place of this, friction") != std::string::npos) return note;
    return "";
}

}  // namespace

TEST(NeededFriction, IsTheSupportsForceOverWhatPresses) {
    const std::string side = R"(, {"on": "block/right", "fix": ["x"]})";
    const std::string note = note_of(block(250, side));
    EXPECT_TRUE(note.starts_with("fix x on block/right")) << note;
    EXPECT_NE(note.find("hold block along x: its contacts would need a coefficient of at least 0.25 (250 over the 1000"),
              std::string::npos)
        << note;
    EXPECT_EQ(note_of(block(0, side)), "");
    EXPECT_EQ(note_of(block(250, R"(, {"on": "block/right", "fix": ["x", "y"]})")), "") << "a clamp is one";
    EXPECT_EQ(note_of(block(250, side, R"(, "contacts": {"friction": 0.1})")), "") << "friction holds with it";
}

TEST(NeededFriction, IsNoneWhereContactsHoldWithTheSupport) {
    // the base holds the block against the load, too
    EXPECT_EQ(
        note_of(block(0, R"(, {"on": "block/left", "fix": ["y"]}, {"part": "block", "rigid": {"translation": [0, null]}})")),
        "");
}

}  // namespace abut::needed_friction_test
