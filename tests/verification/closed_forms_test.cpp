// SPDX-License-Identifier: GPL-3.0-or-later
// The problems E and C of data/README.md at the default accuracy, through the scenes of data/verification/.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/verification/scene_answers.hpp"

namespace abut::closed_forms_test {
namespace {

Result verified(const std::string& name) {
    return test::answer_file("data/verification/" + name + ".json");
}

TEST(ClosedForm, KirschPlate) {
    const Result r = verified("kirsch");
    ASSERT_EQ(r.status, "ok") << r.message;
    ASSERT_EQ(r.probes.size(), 2u);
    EXPECT_NEAR(r.probes[0].stress.xx, 3, 0.03);
    EXPECT_NEAR(r.probes[1].stress.yy, -1, 0.03);
    EXPECT_NEAR(r.probes[1].displacement.x(), 3e-5, 3e-8);
    EXPECT_NEAR(r.probes[0].displacement.y(), -1e-5, 3e-8);
}

TEST(ClosedForm, FreeDiscUnderRadialBodyForce) {
    const Result r = verified("radial_body_force");
    ASSERT_EQ(r.status, "ok") << r.message;
    ASSERT_EQ(r.probes.size(), 2u);
    EXPECT_NEAR(r.probes[0].stress.xx, 4125, 0.01 * 4125);  // "standard" aims at about 1 %
    EXPECT_NEAR(r.probes[1].displacement.x(), 0.0175, 0.001 * 0.0175);
    EXPECT_LT(r.equilibrium.relative_residual, 1e-9);
    ASSERT_EQ(r.warnings.size(), 1u);
    EXPECT_NE(r.warnings[0].find("the same of 2 others: "), std::string::npos) << "two slides and a rotation are neutral";
}

TEST(ClosedForm, ShrinkFit) {
    const Result r = verified("shrink_fit");
    ASSERT_EQ(r.status, "ok") << r.message;
    ASSERT_EQ(r.contacts.size(), 1u);
    EXPECT_EQ(r.contacts[0].status, "closed");
    EXPECT_NEAR(r.contacts[0].contact_length, 4 * M_PI, 1e-6);
    for (double p : r.contacts[0].profile.pressure) EXPECT_NEAR(p, 23.4375, 0.01 * 23.4375);
    EXPECT_LT(r.equilibrium.relative_residual, 1e-9);
}

/// The ring is held at R = 10, not at infinity: R p0 / Q = 0.707662, half angle 60.73 degrees (C6 of data/README.md).
TEST(ClosedForm, PinInHole) {
    const Result r = verified("pin_in_hole");
    ASSERT_EQ(r.status, "ok") << r.message;
    ASSERT_EQ(r.contacts.size(), 1u);
    const ContactResult& c = r.contacts[0];
    EXPECT_EQ(c.interface, "pin-in-hole");
    EXPECT_NEAR(c.max_pressure.value, 70.7662, 0.005 * 70.7662);
    ASSERT_EQ(c.ends.size(), 2u) << "one stretch, though the drawn gap is the same all round";
    for (const Vec2& end : c.ends)
        EXPECT_NEAR(std::acos(end.dot(Vec2(1, 1).normalized()) / end.norm()) * 180 / M_PI, 60.73, 0.7);
}

TEST(ClosedForm, ALoadClosesAGap) {
    const Result r = verified("gap_closed_by_load");
    ASSERT_EQ(r.status, "ok") << r.message;
    ASSERT_EQ(r.contacts.size(), 1u);
    EXPECT_NEAR(r.contacts[0].force.x(), -140, 140 * 1e-8);
    ASSERT_EQ(r.probes.size(), 1u);
    EXPECT_NEAR(r.probes[0].displacement.x(), 0.86, 0.86 * 1e-8);
}

/// Dropping the functions of the whole grid line would hold the ceiling of the recess, too: an eleventh of the deflection.
TEST(Supports, DoNotHoldARecessBetweenThem) {
    const Result r = verified("recessed_feet");
    ASSERT_EQ(r.status, "ok") << r.message;
    ASSERT_EQ(r.probes.size(), 2u);
    EXPECT_NEAR(r.probes[0].displacement.y(), -0.02276, 0.02 * 0.02276);
}

TEST(Mechanism, ABlockOnASlopeIsNamedWithItsMotion) {
    const Result r = verified("slope");
    EXPECT_EQ(r.status, "failed");
    EXPECT_NE(r.message.find("b slides along (-0.8944, -0.4472)"), std::string::npos) << r.message;
}

}  // namespace
}  // namespace abut::closed_forms_test
