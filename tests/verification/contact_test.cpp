// SPDX-License-Identifier: GPL-3.0-or-later
// Contact against closed forms and converged numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/verification/hertz_error.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::contact_test {
namespace {

void expect_balance(const Result& r) {
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_LT(r.equilibrium.relative_residual, 1e-9);
    EXPECT_LT(r.equilibrium.relative_moment_residual, 1e-9);
}

TEST(Hertz, AHundredthOfTheRadius) {
    const Result r = test::answer_file("data/verification/hertz_001.json");
    expect_balance(r);
    ASSERT_EQ(r.contacts.size(), 1u);
    EXPECT_LE(r.unknowns, 4000);
    EXPECT_LT(test::hertz_error(r.contacts[0].profile, 0.01, 500), 0.01);
    EXPECT_NEAR(r.contacts[0].contact_length, 0.01, 0.01 * 0.01);
    EXPECT_NEAR(r.contacts[0].force.y(), 3.92699081698724, 1e-9);
    // the measure can fail: half a per cent of shift in p0 is seen
    EXPECT_GT(test::hertz_error(r.contacts[0].profile, 0.01, 510), 0.015);
}

TEST(Dissertation, CaseB) {
    const Result r = test::answer_file("data/scenes/case_b.json");
    expect_balance(r);
    ASSERT_EQ(r.contacts.size(), 1u);
    EXPECT_NEAR(r.contacts[0].max_pressure.value, 3454.941, 0.01 * 3454.941);
    EXPECT_NEAR(r.contacts[0].contact_length, 0.0921318, 0.01 * 0.0921318);
    EXPECT_EQ(r.contacts[0].interface, "round-on-round");
    EXPECT_EQ(r.contacts[0].between[0], "upper/circle");
    EXPECT_EQ(r.contacts[0].between[1], "lower/circle");
}

TEST(Dissertation, CaseC) {
    const Result r = test::answer_file("data/scenes/case_c.json");
    expect_balance(r);
    ASSERT_EQ(r.contacts.size(), 1u);
    EXPECT_NEAR(r.contacts[0].max_pressure.value, 1994.71, 0.015 * 1994.71);
}

TEST(Dissertation, Vise) {
    const Result r = test::answer_file("data/scenes/vise.json");
    expect_balance(r);
    ASSERT_EQ(r.contacts.size(), 1u);
    const ContactResult& c = r.contacts[0];
    EXPECT_NEAR(c.force.norm(), 429.60, 0.01 * 429.60);
    const auto top = std::max_element(c.profile.y.begin(), c.profile.y.end()) - c.profile.y.begin();
    EXPECT_NEAR(c.profile.gap[static_cast<std::size_t>(top)], 3.0749e-3, 0.02 * 3.0749e-3);
    ASSERT_EQ(c.ends.size(), 2u);
    EXPECT_NEAR(std::max(c.ends[0].y(), c.ends[1].y()), 0.6125, 0.01);
    EXPECT_NEAR(r.strain_energy, 2.148032, 0.01 * 2.148032);
    ASSERT_EQ(r.probes.size(), 1u);
    EXPECT_NEAR(r.probes[0].displacement.x(), 3.6168e-3, 0.02 * 3.6168e-3);
}

/// Two blocks of equal width on grids that match nowhere, turned by an angle; E2 of the upper one.
std::string patch_scene(double E2, double angle_upper, double turn) {
    const double a = turn * M_PI / 180;
    const auto p = [&](double x, double y) {
        return test::pair_text(std::cos(a) * x - std::sin(a) * y, std::sin(a) * x + std::cos(a) * y);
    };
    const std::string down = test::pair_text(100 * std::sin(a), -100 * std::cos(a));
    return R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3}, "n": {"E": )" + test::number(E2) + R"(, "nu": 0.3}},
      "parts": [{"name": "lower", "material": "m", "geometry": {"polygon": [)" +
           p(0, 0) + "," + p(2, 0) + "," + p(2, 1) + "," + p(0, 1) + R"(]}},
                {"name": "upper", "material": "n", "geometry": {"polygon": [)" +
           p(0, 1) + "," + p(2, 1) + "," + p(2, 2) + "," + p(0, 2) + R"(]}}],
      "supports": [{"on": ["lower/e0"], "symmetry": true}, {"part": "lower", "rigid": {"translation": [0, null], "rotation": null}},
                   {"part": "upper", "rigid": {"translation": [0, null], "rotation": null}}],
      "loads": [{"on": "upper/e2", "traction": )" +
           down + R"(}],
      "accuracy": {"grids": {"lower": {"cells": [7, 4], "offset": [0.031, 0.017]}, "upper": {"cells": [5, 3], "offset": [0.11, 0.05], "angle": )" +
           test::number(angle_upper) + "}}}}";
}

TEST(ContactPatch, NonMatchingGridsCarryAConstantPressure) {
    for (double E2 : {1e5, 1e6, 1e3})
        for (double angle : {0.0, 13.0, 40.0})
            for (double turn : {0.0, 25.0}) {
                const Result r = test::answer(patch_scene(E2, angle, turn));
                ASSERT_EQ(r.status, "ok") << r.message;
                expect_balance(r);
                ASSERT_EQ(r.contacts.size(), 1u);
                EXPECT_EQ(r.contacts[0].status, "closed");
                for (double p : r.contacts[0].profile.pressure) EXPECT_NEAR(p, 100, 100 * 1e-8) << E2 << " " << angle;
                EXPECT_NEAR(r.contacts[0].contact_length, 2, 1e-12);
            }
}

/// The vise in units of another length and force, or drawn somewhere else.
std::string vise(double length, double force, double dx, double dy) {
    const auto p = [&](double x, double y) { return test::pair_text(length * x + dx, length * y + dy); };
    const auto E = [&](double e) { return test::number(e * force / (length * length)); };
    return R"({"abut": 1, "thickness": )" + test::number(length) + R"(, "materials": {"soft": {"E": )" + E(1e5) +
           R"(, "nu": 0.3}, "hard": {"E": )" + E(1e6) + R"(, "nu": 0.3}},
      "parts": [{"name": "workpiece", "material": "soft", "geometry": {"rectangle": {"min": )" +
           p(0, 0) + R"(, "max": )" + p(0.6, 1.1) + R"(}}},
                {"name": "jaw", "material": "hard", "geometry": {"polygon": [)" +
           p(0.6, -0.9) + "," + p(2.2, -0.9) + "," + p(2.2, -0.4) + "," + p(1, 0) + "," + p(1, 1.1) + "," + p(0.6, 1.1) +
           R"(]}}],
      "supports": [{"on": ["workpiece/left", "workpiece/bottom"], "symmetry": true}, {"on": "jaw/e0", "fix": ["y"]},
                   {"on": "jaw/e1", "displacement": {"x": )" +
           test::number(-0.01 * length) + "}}]}";
}

TEST(Invariance, UnitsAndPlaceDoNotMatter) {
    const Result base = test::answer(vise(1, 1, 0, 0));
    const double f0 = base.contacts.at(0).force.x(), p0 = base.contacts[0].max_pressure.value,
                 u0 = base.parts[1].max_displacement.value;
    struct Variant {
        double length, force, dx, dy;
    };
    for (const Variant& v :
         {Variant{1e-3, 1, 0, 0}, {1000, 1e3, 0, 0}, {1, 1, 7.3, -2.1}, {1, 1, 1e4, 3e4}, {25.4, 4.448, 0.1, 0.2}}) {
        const Result r = test::answer(vise(v.length, v.force, v.dx, v.dy));
        ASSERT_EQ(r.status, "ok") << r.message;
        ASSERT_EQ(r.contacts.size(), 1u);
        EXPECT_EQ(r.unknowns, base.unknowns);
        EXPECT_NEAR(r.contacts[0].force.x() / v.force, f0, 1e-6 * std::abs(f0));
        EXPECT_NEAR(r.contacts[0].max_pressure.value / v.force * v.length * v.length, p0, 1e-6 * p0);
        EXPECT_NEAR(r.parts[1].max_displacement.value / v.length, u0, 1e-6 * u0);
    }
}

TEST(Invariance, TheSameSceneGivesTheSameAnswer) {
    Result a = test::answer_file("data/scenes/pin_bracket.json"), b = test::answer_file("data/scenes/pin_bracket.json");
    for (Result* r : {&a, &b}) {
        r->timing.clear();
        r->next_level.reset();
        for (Effect& e : r->effects) e.seconds = e.share = 0;
        for (PassSummary& p : r->passes) p.seconds = 0;
    }
    EXPECT_TRUE(result_json(a) == result_json(b));
}

TEST(PinBracket, CarriesItsLoad) {
    const Result r = test::answer_file("data/scenes/pin_bracket.json");
    expect_balance(r);
    ASSERT_EQ(r.contacts.size(), 2u);
    EXPECT_EQ(r.contacts[0].interface, "pin-in-hole");
    EXPECT_NEAR(r.contacts[0].force.y(), -20000, 1e-6);
    EXPECT_NEAR(r.contacts[1].force.y(), 20000, 1e-6);
    EXPECT_EQ(r.contacts[1].interface, "flat-on-flat");
    EXPECT_GT(r.contacts[0].max_pressure.value, 150);
    EXPECT_LT(r.contacts[0].max_pressure.value, 250);
}

}  // namespace
}  // namespace abut::contact_test
