// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/solution/contact_joints.hpp"

#include <gtest/gtest.h>

#include "src/analysis/adaptive.hpp"
#include "tests/verification/true_errors.hpp"

namespace abut::contact_joints_test {
namespace {

std::vector<ContactJoint> joints_of(const test::EstimateCase& c) {
    Scene scene = test::adaptive_scene(c);
    scene.accuracy.cell_size = 0.02;
    Stopwatches seconds;
    const Outcome out = solve_adaptively(scene, resolve_conditions(scene), {}, seconds);
    return contact_joints(scene, out.solved.contacts.at(0));
}

}  // namespace

TEST(ContactJoints, WhereAFlatBecomesAFillet) {
    const std::vector<ContactJoint> joints = joints_of({"verification/filleted_punch.json", {{"R", 2}}});
    ASSERT_EQ(joints.size(), 1u);
    EXPECT_NEAR(joints[0].s, 0.02, 1e-6);  // the middle curve is as long as its chords
    EXPECT_NEAR(joints[0].opening, 1 / 2.0, 1e-9);
    for (const Vec2& x : joints[0].x) EXPECT_NEAR(x.x(), 0.02, 1e-6);
}

TEST(ContactJoints, NoneOnOneArc) {
    EXPECT_TRUE(joints_of({"verification/cylinder_on_plane.json"}).empty());
}

}  // namespace abut::contact_joints_test
