// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/self_contact.hpp"

#include <gtest/gtest.h>

#include "src/analysis/analysis.hpp"
#include "src/scene/read_scene.hpp"
#include "src/scene/scene.hpp"

namespace abut::self_contact_test {
namespace {

/// A U whose arms, a slot apart, are pressed towards each other by `load` each.
Result pressed_u(double load) {
    const std::string force = std::to_string(load);
    return analyze(read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}}, "parts": [
        {"name": "u", "material": "m", "geometry":
            {"polygon": [[0, 0], [10, 0], [10, 20], [5.5, 20], [5.5, 4], [4.5, 4], [4.5, 20], [0, 20]]}}],
        "supports": [{"on": "u/e0", "fix": ["x", "y"]}],
        "loads": [{"on": "u/e7", "traction": [)" +
                                       force + R"(, 0]}, {"on": "u/e1", "traction": [-)" + force +
                                       R"(, 0]}], "accuracy": {"level": "draft"}})",
                                   "scene.json"),
                   {});
}

bool tells_of_self_contact(const Result& r) {
    for (const std::string& w : r.warnings)
        if (w.find("part u closes on itself near (") != std::string::npos) return true;
    return false;
}

FieldSample sample(double x, double y, double u = 0) {
    return {{x, y}, {u, 0}, {}};
}

}  // namespace

TEST(SelfContact, IsToldWhereASlotCloses) {
    const Result free = pressed_u(0.01);
    ASSERT_EQ(free.status, "ok") << free.message;
    EXPECT_FALSE(tells_of_self_contact(free));
    const double closing = free.parts[0].max_displacement.value / 0.01;  // of one arm's end, by load
    EXPECT_FALSE(tells_of_self_contact(pressed_u(0.4 / closing)));
    EXPECT_TRUE(tells_of_self_contact(pressed_u(0.7 / closing)));
}

TEST(SelfContact, IsAPlaceOnTheDrawnBoundary) {
    PartField field;
    field.boundary = {
        {sample(0, 0), sample(4, 0), sample(4, 3), sample(3, 3, 2), sample(3, 1), sample(1, 1), sample(1, 3), sample(0, 3)}};
    const std::optional<Vec2> place = self_overlap(field);
    ASSERT_TRUE(place);
    EXPECT_EQ(*place, Vec2(4, 1.5));
    field.boundary[0][3].displacement.x() = 0.5;
    EXPECT_FALSE(self_overlap(field));
}

TEST(SelfContact, CrossingsThatAreDrawnAreNotToldOfAgain) {
    PartField field;
    field.boundary = {{sample(0, 0), sample(2, 2), sample(2, 0), sample(0, 2)}};
    EXPECT_FALSE(self_overlap(field));
}

}  // namespace abut::self_contact_test
