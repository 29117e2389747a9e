// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/follow_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "src/results/displacement_from_drawn.hpp"
#include "src/results/verdict.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::follow_motion_test {
namespace {

/// A beam, 2 high, on two rollers 100 apart, that a punch bends in the middle: the punch goes far beside its own size, the beam
/// does not, but for its bending.
Result bent_by(double force, const std::string& motion) {
    return test::answer(R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "beam", "material": "m", "geometry": {"rectangle": {"min": [-60, 0], "max": [60, 2]}}},
        {"name": "s1", "material": "m", "geometry": {"circle": {"center": [-50, -5], "radius": 5}}},
        {"name": "s2", "material": "m", "geometry": {"circle": {"center": [50, -5], "radius": 5}}},
        {"name": "punch", "material": "m", "geometry": {"circle": {"center": [0, 7], "radius": 5}}}],
        "supports": [{"part": "s1", "rigid": {"translation": [0, 0], "rotation": 0}},
                     {"part": "s2", "rigid": {"translation": [0, 0], "rotation": 0}},
                     {"part": "punch", "rigid": {"translation": [0, null], "rotation": 0}}],
        "contacts": {"friction": 0.3}, "loads": [{"part": "punch", "force": [0, )" +
                        test::number(-force) +
                        R"(]}], "output": {"probes": [{"part": "beam", "at": [0, 1]}]}, "accuracy": {"level": "draft"})" +
                        motion + "}");
}

}  // namespace

/// A link that is drawn so little off the vertical that it is not followed hangs under its load, to rounding.
TEST(FollowMotion, ALinkDrawnALittleOffHangsUnderItsPin) {
    for (const auto& [degrees, radius] :
         {std::pair(0.1, 4.98), std::pair(0.2, 4.98), std::pair(0.3, 4.8), std::pair(0.5, 4.8)}) {
        SCOPED_TRACE(degrees);
        const Result r = test::answer(R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
            {"name": "pin", "material": "m", "geometry": {"circle": {"center": [0, 0], "radius": )" +
                                      test::number(radius) + R"(}}},
            {"name": "link", "material": "m", "place": {"rotate": )" +
                                      test::number(degrees) + R"(}, "geometry": {"difference": [
                {"slot": {"from": [0, 0], "to": [0, -60], "radius": 10}}, {"circle": {"center": [0, 0], "radius": 5}}]}}],
            "supports": [{"part": "pin", "rigid": {"translation": [0, 0], "rotation": 0}}],
            "loads": [{"part": "link", "force": [0, -1000]}], "accuracy": {"level": "draft"}})");
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_LT(r.solver.contact_residual.value(), 1e-7);
        ASSERT_TRUE(r.parts.at(1).placement.has_value());
        EXPECT_NEAR(r.parts.at(1).placement->rotation, -degrees * std::numbers::pi / 180, 1e-8);
    }
}

/// Where the punch is placed anew, the deflection of the beam is still told from where it was drawn.
TEST(FollowMotion, BendingIsNoMotionOfThePart) {
    for (double force : {40.0, 50.0, 60.0, 70.0}) {
        SCOPED_TRACE(force);
        const Result followed = bent_by(force, ""), as_drawn = bent_by(force, R"(, "motion": "off")");
        ASSERT_EQ(followed.status, "ok");
        const double deflection = as_drawn.probes.at(0).displacement.y();
        // Euler and Bernoulli: F L^3 / (48 E I); friction at the rollers takes a little of it
        EXPECT_NEAR(deflection, -force * 1e6 / (48 * 210000 * 10 * 8.0 / 12), 0.03 * std::abs(deflection));
        EXPECT_NEAR(followed.probes.at(0).displacement.y(), deflection, 0.01 * std::abs(deflection));
        EXPECT_FALSE(followed.parts.at(0).placement);
    }
}

/// A shoe on a drum that is turned, a little or far: friction slides all the same, over what the drum goes last. Its moment is
/// mu R times the integral of the pressure.
TEST(FollowMotion, FrictionSlidesWhereAPartIsLedFar) {
    const auto braked = [](double degrees) {
        return test::answer(R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
            {"name": "drum", "material": "m", "geometry": {"circle": {"center": [0, 0], "radius": 40}}},
            {"name": "shoe", "material": "m", "geometry": {"difference": [
                {"rectangle": {"min": [-20, 30], "max": [20, 60]}}, {"circle": {"center": [0, 0], "radius": 40}}]}}],
            "supports": [{"part": "drum", "rigid": {"translation": [0, 0], "rotation": )" +
                            test::number(degrees) + R"(}},
                         {"part": "shoe", "rigid": {"translation": [0, null], "rotation": 0}}],
            "loads": [{"part": "shoe", "force": [0, -1000]}], "contacts": {"friction": 0.3},
            "accuracy": {"level": "draft"}})");
    };
    const double near = braked(0.01).reactions.at(0).moment;
    EXPECT_NEAR(std::abs(near), 0.3 * 40 * 1000, 0.05 * 12000);  // the arc presses a little more than the force
    for (double degrees : {0.5, 20.0, -20.0}) {
        const Result far = braked(degrees);
        ASSERT_EQ(far.status, "ok") << far.message;
        EXPECT_NEAR(far.reactions.at(0).moment, degrees > 0 ? near : -near, 0.01 * std::abs(near)) << degrees;
    }
}

/// A slider crosses a gap to a block on a spring of 10 over its height of 10, which gives way by (1000 - 0.3 2000) / 100 = 4:
/// it goes so far once, whether it is followed over the gap or begins at the block.
TEST(FollowMotion, WhatFrictionSlidesAgainstASpringGoesAsFarAsTheSpringGives) {
    for (const double gap : {6.0, 0.0}) {
        SCOPED_TRACE(gap);
        const Result r = test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "thickness": 1, "parts": [
            {"name": "base", "material": "m", "geometry": {"rectangle": {"min": [-50, -20], "max": [120, 0]}}},
            {"name": "slider", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [40, 10]}}},
            {"name": "block", "material": "m", "geometry": {"rectangle": {"min": )" +
                                      test::pair_text(40 + gap, 0.5) + R"(, "max": )" + test::pair_text(60 + gap, 10.5) +
                                      R"(}}}],
            "supports": [{"on": "base/bottom", "fix": ["x", "y"]}, {"on": "block/right", "spring": {"normal": 10}},
                {"part": "block", "rigid": {"translation": [null, 0], "rotation": 0}}],
            "loads": [{"on": "slider/top", "force": [0, -2000]}, {"on": "slider/left", "force": [1000, 0]}],
            "contacts": {"friction": 0.3, "pairs": [{"between": ["slider/*", "block/*"], "friction": 0}]},
            "accuracy": {"level": "draft"}})");
        ASSERT_EQ(r.status, "ok") << r.message;
        const PartResult& slider = r.parts.at(1);
        const double placed = slider.placement ? slider.placement->translation.x() : 0;
        EXPECT_NEAR(placed + slider.max_displacement.value, gap + 4, 0.05);
        EXPECT_NEAR(placed, gap, 1e-3);
    }
}

/// A ball is led along a flat and up a ramp, or only along the flat: F = W tan(slope + atan mu).
TEST(FollowMotion, FrictionSlidesUpARampThatAPartIsLedTo) {
    const double load = 200, mu = 0.2, radius = 4;
    for (const auto& [degrees, way, climbs] :
         {std::tuple(30.0, 8.0, true), {10.0, 8.0, true}, {30.0, 5.0, true}, {30.0, 2.0, false}}) {
        SCOPED_TRACE(way);
        const double slope = degrees * std::numbers::pi / 180, begin = 5, end = 15;
        const Result r = test::answer(R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
            {"name": "bed", "material": "m", "geometry": {"polygon": [[-40, -10], [60, -10], )" +
                                      test::pair_text(60, (end - begin) * std::tan(slope)) + ", " +
                                      test::pair_text(end, (end - begin) * std::tan(slope)) + ", " + test::pair_text(begin, 0) +
                                      R"(, [-40, 0]]}},
            {"name": "ball", "material": "m", "geometry": {"circle": {"center": [0, 4], "radius": )" +
                                      test::number(radius) +
                                      R"(}}}], "supports": [{"on": "bed/e0", "fix": ["x", "y"]},
            {"part": "ball", "rigid": {"translation": [)" +
                                      test::number(way) + R"(, null], "rotation": 0}}],
            "loads": [{"part": "ball", "force": [0, )" +
                                      test::number(-load) + R"(]}], "contacts": {"friction": )" + test::number(mu) +
                                      R"(}, "accuracy": {"level": "draft"}})");
        ASSERT_EQ(r.status, "ok") << r.message;
        const double force = load * std::tan((climbs ? slope : 0) + std::atan(mu));
        EXPECT_NEAR(r.reactions.at(1).force.x(), force, 2e-3 * force);
    }
}

/// A block of rubber that is dragged far: what it slides in the solution is less than what it shears by.
TEST(FollowMotion, FrictionOfSoftBodiesThatIsShortOfItsLimitIsTold) {
    const auto dragged = [](double modulus) {
        return test::answer(R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 210000, "nu": 0.3}, "b": {"E": )" +
                            test::number(modulus) + R"(, "nu": 0.4}}, "parts": [
            {"name": "base", "material": "m", "geometry": {"rectangle": {"min": [-60, -20], "max": [60, 0]}}},
            {"name": "block", "material": "b", "geometry": {"rectangle": {"min": [-20, 0], "max": [20, 20]}}}],
            "supports": [{"on": "base/bottom", "fix": ["x", "y"]},
                         {"part": "block", "rigid": {"translation": [20, null], "rotation": 0}}],
            "loads": [{"part": "block", "force": [0, -100]}], "contacts": {"friction": 0.2}, "accuracy": {"level": "draft"}})");
    };
    const auto tells = [](const Result& r) {
        return std::any_of(r.reasons.begin(), r.reasons.end(), [](const auto& reason) {
            return reason.text == "friction between base and block is not at its limit though they slide";
        });
    };
    const Result steel = dragged(210000), rubber = dragged(5);
    EXPECT_NEAR(steel.reactions.at(1).force.x(), 20, 0.02);
    EXPECT_FALSE(tells(steel));
    EXPECT_LT(rubber.reactions.at(1).force.x(), 19);
    EXPECT_TRUE(tells(rubber));
}

/// A cam that turns under a flat follower slides all the way: the shear is mu W, wherever solutions move the follower first.
TEST(FollowMotion, FrictionSlidesUnderACamThatLiftsAPart) {
    const double load = 1000, mu = 0.1, off = 5;
    for (const double degrees : {3.0, 20.0, 30.0, -30.0}) {
        const double a = degrees * std::numbers::pi / 180;  // about the axis, beside which the disc is drawn
        const Result r = test::answer(R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
            {"name": "cam", "material": "m", "geometry": {"circle": {"center": [5, 0], "radius": 20}}},
            {"name": "follower", "material": "m", "geometry": {"rectangle": {"min": [-25, 20], "max": [25, 50]}}}],
            "supports": [{"part": "cam", "rigid": {"translation": )" +
                                      test::pair_text(off * (std::cos(a) - 1), off * std::sin(a)) + R"(, "rotation": )" +
                                      test::number(degrees) + R"(}},
                         {"part": "follower", "rigid": {"translation": [0, null], "rotation": 0}}],
            "loads": [{"part": "follower", "force": [0, )" +
                                      test::number(-load) + R"(]}], "contacts": {"friction": )" + test::number(mu) +
                                      R"(}, "accuracy": {"level": "draft"}})");
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_NEAR(r.contacts.at(0).force.x(), (degrees > 0 ? 1 : -1) * mu * load, 1e-3 * mu * load) << degrees;
    }
}

/// A lever in mid-air, held by its pin alone, falls on its stop with or without friction, which acts on it there.
TEST(FollowMotion, FrictionThatHoldsNothingLetsPartsGo) {
    const auto falls = [](const std::string& friction) {
        return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
            {"name": "stop", "material": "m", "geometry": {"rectangle": {"min": [70, -40], "max": [130, -14]}}},
            {"name": "pin", "material": "m", "geometry": {"circle": {"center": [0, 0], "radius": 5}}},
            {"name": "arm", "material": "m", "geometry": {"difference": [
                {"union": [{"slot": {"from": [0, 0], "to": [100, 0], "radius": 6}}, {"circle": {"center": [0, 0], "radius": 10}}]},
                {"circle": {"center": [0, 0], "radius": 5.005}}]}}],
            "supports": [{"on": "stop/bottom", "fix": ["x", "y"]},
                         {"part": "pin", "rigid": {"translation": [0, 0], "rotation": 0}}],
            "loads": [{"part": "arm", "force": [0, -300]}], "contacts": {"friction": )" +
                            friction + R"(}, "accuracy": {"level": "draft"}})");
    };
    const Result smooth = falls("0"), held = falls("0.1");
    ASSERT_EQ(smooth.status, "ok") << smooth.message;
    ASSERT_EQ(held.status, "ok") << held.message;
    ASSERT_TRUE(held.parts.at(2).placement);
    EXPECT_NEAR(held.parts.at(2).placement->rotation, smooth.parts.at(2).placement->rotation, 1e-6);
    EXPECT_TRUE(std::any_of(held.warnings.begin(), held.warnings.end(),
                            [](const std::string& w) { return w.find("friction acts from there on") != std::string::npos; }));
    EXPECT_NEAR(held.contacts.at(0).force.norm() / smooth.contacts.at(0).force.norm(), 1, 0.03);
}

/// A clamp drawn far above its strip, which lies above its base: the first step closes both gaps, and friction remembers there.
/// A crowned block falls into a corner and is pushed against its wall: friction begins where it has come to rest, of bodies
/// that are not pressed together yet. Statics, where all slides: N = H - mu R, R = W - mu N.
TEST(FollowMotion, FrictionDoesNotRememberTheFall) {
    const double mu = 0.1, weight = 10000, push = 1500, wall = (push - mu * weight) / (1 - mu * mu);
    for (const double fall : {0.0, 6.0, 20.0}) {
        const auto y = [&](double at) { return test::number(at + fall); };
        const Result r = test::answer(R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
            {"name": "frame", "material": "m", "geometry": {"polygon":
                [[-80, -60], [60, -60], [60, 60], [40, 60], [40, -40], [-80, -40]]}},
            {"name": "b", "material": "m", "geometry": {"intersection": [
                {"rectangle": {"min": [10, )" +
                                      y(-40) + R"(], "max": [40, )" + y(20) + R"(]}},
                {"circle": {"center": [25, )" +
                                      y(160) + R"(], "radius": 200}},
                {"circle": {"center": [-160, )" +
                                      y(-10) + R"(], "radius": 200}}]}}],
            "supports": [{"on": "frame/e0", "fix": ["x", "y"]}, {"part": "b", "rigid": {"rotation": 0}}],
            "loads": [{"part": "b", "force": [1500, -10000]}], "contacts": {"friction": 0.1}})");
        ASSERT_EQ(r.status, "ok") << r.message;
        geometry::Vec2 on_wall(0, 0);
        for (const ContactResult& c : r.contacts)
            if (c.max_pressure.at.x() > 39.9) on_wall += c.force;
        EXPECT_NEAR(on_wall.x(), wall, 1e-3 * wall) << fall;
    }
}

TEST(FollowMotion, StepsWithFrictionGoOnFromWhereTheFirstTakesTheParts) {
    const Scene scene = read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "base", "material": "m", "geometry": {"rectangle": {"min": [-60, -20], "max": [60, 0]}}},
        {"name": "strip", "material": "m", "geometry": {"rectangle": {"min": [-50, 4], "max": [50, 8]}}},
        {"name": "clamp", "material": "m", "geometry": {"rectangle": {"min": [-15, 14], "max": [15, 30]}}}],
        "supports": [{"on": "base/bottom", "fix": ["x", "y"]}, {"on": ["clamp/left", "clamp/right"], "symmetry": true}],
        "loads": [{"name": "clamp", "on": "clamp/top", "force": [0, -2000]}, {"name": "pull", "on": "strip/right", "force": [200, 0]},
                  {"name": "weight", "on": "strip/bottom", "force": [0, -1]}],
        "contacts": {"friction": 0.15}, "accuracy": {"level": "draft"},
        "steps": [{"name": "clamp", "loads": {"clamp": 1, "weight": 1}}, {"name": "pull", "loads": {"clamp": 1, "weight": 1, "pull": 1}},
                  {"name": "release", "loads": {"clamp": 1, "weight": 1}}]})",
                                        "s.json");
    const std::vector<CaseResult> steps = analyze_cases(scene, {});
    ASSERT_EQ(steps.size(), 3U);
    for (const CaseResult& step : steps) {
        ASSERT_EQ(step.result.status, "ok") << step.result.message;
        ASSERT_TRUE(step.result.parts.at(2).placement) << step.name;
        EXPECT_NEAR(step.result.parts.at(2).placement->translation.y(), -10, 1e-3);
        EXPECT_NEAR(step.result.parts.at(1).placement->translation.y(), -4, 1e-3);
        EXPECT_LT(step.result.equilibrium.relative_residual, 1e-9);
    }
}

/// A plate drawn on its corner, beyond the place where it would balance, falls on its long side; round parts turn as they like.
TEST(FollowMotion, APartThatTipsOverIsAReason) {
    const auto falls = [](double degrees) {
        const double a = degrees * std::numbers::pi / 180, c = std::cos(a), s = std::sin(a);
        return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
            {"name": "floor", "material": "m", "geometry": {"rectangle": {"min": [-100, -20], "max": [100, 0]}}},
            {"name": "plate", "material": "m", "geometry": {"polygon": [[0, 0], )" +
                            test::pair_text(10 * c, 10 * s) + ", " + test::pair_text(10 * c - 40 * s, 10 * s + 40 * c) + ", " +
                            test::pair_text(-40 * s, 40 * c) + R"(]}},
            {"name": "stop", "material": "m", "geometry": {"rectangle": {"min": [-100, 0], "max": [-60, 30]}}}],
            "supports": [{"on": "floor/bottom", "fix": ["x", "y"]}, {"on": "stop/left", "fix": ["x", "y"]}],
            "loads": [{"on": "plate/*", "force": [0, -100]}], "accuracy": {"level": "draft"}})");
    };
    const auto tips = [](const Result& r) {
        return std::any_of(r.reasons.begin(), r.reasons.end(),
                           [](const Reason& reason) { return reason.text.find("plate turns by") != std::string::npos; });
    };
    const Result over = falls(30), back = falls(80);
    ASSERT_EQ(over.status, "ok") << over.message;
    ASSERT_EQ(back.status, "ok") << back.message;
    EXPECT_NEAR(over.parts.at(1).placement->rotation, std::numbers::pi / 3, 1e-6);
    EXPECT_TRUE(tips(over));
    EXPECT_NEAR(back.parts.at(1).placement->rotation, std::numbers::pi / 18, 1e-6);
    EXPECT_FALSE(tips(back));
}

/// A pin with 5 % clearance moves by less than is far, but by more than pairs of where it was drawn are good for.
TEST(FollowMotion, WhatIsPairedAstrayIsPairedAnew) {
    const auto pin_at = [](const std::string& x, const std::string& y) {
        return test::answer(R"({"abut": 1, "materials": {"m": {"E": 2e5, "nu": 0.3}}, "parts": [
            {"name": "plate", "material": "m", "geometry": {"difference": [
                {"rectangle": {"min": [-30, -30], "max": [30, 30]}, "name": "p"}, {"circle": {"center": [0, 0], "radius": 10}}]}},
            {"name": "pin", "material": "m", "geometry": {"circle": {"center": [)" +
                            x + ", " + y + R"(], "radius": 9.5}}}],
            "supports": [{"on": "plate/p/bottom", "fix": ["x", "y"]}],
            "loads": [{"part": "pin", "force": [0, -3000]}]})");
    };
    const Result in_place = pin_at("0", "-0.5");
    ASSERT_EQ(verdict_of(in_place), Verdict::reached);
    EXPECT_FALSE(in_place.parts.at(1).placement);
    const double peak = in_place.contacts.at(0).max_pressure.value;
    for (const auto& [x, y] : {std::pair{"0", "0"}, {"0.45", "0"}, {"0", "0.45"}, {"-0.2", "-0.3"}}) {
        SCOPED_TRACE(std::string(x) + ", " + y);
        const Result r = pin_at(x, y);
        EXPECT_EQ(verdict_of(r), Verdict::reached);
        const ContactResult& c = r.contacts.at(0);
        EXPECT_NEAR(c.max_pressure.value, peak, (c.errors->peak + in_place.contacts[0].errors->peak) * peak);
    }
    EXPECT_TRUE(pin_at("0", "0.45").parts.at(1).placement);
}

/// A disc that is drawn into its flat by less than drawings are precise to keeps no pin from its place of rest.
TEST(FollowMotion, OverlapsByRoundingAreNone) {
    const auto drawn_at = [](const std::string& y) {
        return test::answer(R"({"abut": 1, "materials": {"m": {"E": 2e5, "nu": 0.3}}, "parts": [
            {"name": "plate", "material": "m", "geometry": {"difference": [
                {"rectangle": {"min": [-30, -30], "max": [30, 30]}, "name": "p"}, {"circle": {"center": [0, 0], "radius": 10}}]}},
            {"name": "pin", "material": "m", "geometry": {"circle": {"center": [0, )" +
                            y + R"(], "radius": 9.7}}},
            {"name": "disc", "material": "m", "geometry": {"circle": {"center": [10, 37.9999], "radius": 8}}}],
            "supports": [{"on": "plate/p/bottom", "fix": ["x", "y"]}],
            "loads": [{"part": "pin", "force": [0, -1500]}, {"part": "disc", "force": [0, -300]}]})");
    };
    const Result in_place = drawn_at("-0.3"), beside = drawn_at("0.25");
    EXPECT_EQ(verdict_of(beside), Verdict::reached);
    EXPECT_TRUE(beside.parts.at(1).placement);
    EXPECT_NEAR(beside.contacts.at(0).max_pressure.value / in_place.contacts.at(0).max_pressure.value, 1, 0.01);
}

/// The wall is drawn 10 away: where the way ends just beyond it, however little, the block is pressed by that.
TEST(FollowMotion, TheLastOfAPrescribedWayPressesAsFarAsItIsStopped) {
    for (const double beyond : {1e-6, 1e-4, 1e-3, 0.0095, 0.0105, 0.05}) {
        SCOPED_TRACE(beyond);
        const Result r = test::answer(R"({"abut": 1, "analysis": "plane_stress", "thickness": 10,
            "materials": {"m": {"E": 2e5, "nu": 0.3}}, "parts": [
            {"name": "block", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [100, 40]}}},
            {"name": "wall", "material": "rigid", "geometry": {"rectangle": {"min": [110, -20], "max": [150, 60]}}}],
            "supports": [{"on": "block/bottom", "fix": ["y"]}, {"part": "wall", "rigid": {"translation": [0, 0], "rotation": 0}},
                         {"on": "block/left", "displacement": {"x": )" +
                                      test::number(10 + beyond) + "}}]}");
        EXPECT_EQ(verdict_of(r), Verdict::reached);
        const double force = 2e5 * beyond / 100 * 40 * 10;
        EXPECT_NEAR(r.contacts.at(0).force.x(), -force, 1e-4 * force);
    }
}

/// An elastic arm that is led by less than a twentieth of its length: its nose meets a catch that it has nothing to do with
/// where it is drawn, and slides up on it. The force of friction is at its limit, on a slope of 4 by 9.
TEST(FollowMotion, FrictionMeetsWhatAPartIsLedTo) {
    const Result r = test::answer(R"({"abut": 1, "thickness": 5, "materials": {"m": {"E": 2000, "nu": 0.3}}, "parts": [
        {"name": "arm", "material": "m", "geometry": {"polygon": [[-140, 0], [-140, 4], [50, 4], [50, 7], [51, 7], [60, 3], [60, 0]]}},
        {"name": "catch", "material": "rigid", "geometry": {"polygon": [[63, 4.2], [83, 4.2], [83, 10], [63, 10]]}}],
        "supports": [{"part": "catch", "rigid": {"translation": [0, 0], "rotation": 0}},
                     {"on": "arm/e0", "displacement": {"x": 8, "y": 0}}],
        "contacts": {"friction": 0.2}, "accuracy": {"level": "draft"}})");
    ASSERT_EQ(r.status, "ok") << r.message;
    ASSERT_EQ(r.contacts.size(), 1u);
    const Vec2 force = r.contacts[0].force;
    EXPECT_NEAR(force.x() / force.y(), std::tan(std::atan2(4, 9) + std::atan(0.2)), 0.01);
}

/// A plank falls on two round pins, one 3 higher than the other: from any height it rests on both, which their friction of 0.3
/// is enough for (tan 4.9 degrees = 0.086), and does not slide to where it would rest without.
TEST(FollowMotion, FrictionHoldsWhatItCanHoweverFarItFalls) {
    const auto falls_by = [](double height, double friction) {
        const auto corner = [&](double x, double y) { return test::pair_text(x, y + height); };
        return test::answer(R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 2e5, "nu": 0.3}}, "parts": [
            {"name": "left", "material": "rigid", "geometry": {"circle": {"center": [-15, -5], "radius": 5}}},
            {"name": "right", "material": "rigid", "geometry": {"circle": {"center": [20, -2], "radius": 5}}},
            {"name": "plank", "material": "m", "geometry": {"polygon": [)" +
                            corner(-40, 0) + ", " + corner(40, 0) + ", " + corner(40, 10) + ", " + corner(-40, 10) + R"(]}}],
            "supports": [{"part": "left", "rigid": {"translation": [0, 0], "rotation": 0}},
                         {"part": "right", "rigid": {"translation": [0, 0], "rotation": 0}}],
            "loads": [{"part": "plank", "force": [0, -100]}], "accuracy": {"level": "draft"}, "contacts": {"friction": )" +
                            test::number(friction) + "}}");
    };
    const double turn = std::atan2(3, 35), rolled = 20 - 5 * turn;
    for (const double height : {6.0, 9.0, 12.0, 15.0, 40.0}) {
        SCOPED_TRACE(height);
        const Result r = falls_by(height, 0.3);
        ASSERT_EQ(r.status, "ok") << r.message;
        ASSERT_TRUE(r.parts.at(2).placement);
        EXPECT_NEAR(r.parts[2].placement->rotation, turn, 1e-4);
        EXPECT_NEAR(r.parts[2].placement->translation.x(), 20 - 10 * std::sin(turn) - rolled * std::cos(turn), 1e-3)
            << "it rolls on the right pin until it meets the other one";
        EXPECT_NEAR(r.contacts.at(0).force.y() + r.contacts.at(1).force.y(), -100, 0.1);
        EXPECT_NEAR(r.contacts[1].force.y(), -43.9, 0.5);
    }
    const Result slides = falls_by(12, 0.05);
    EXPECT_TRUE(slides.status != "ok" || std::abs(slides.parts.at(2).placement->translation.x()) > 1);
}

TEST(FollowMotion, WhatOnlyMovesHasItsWay) {
    const Result r = test::answer(R"({"abut": 1, "materials": {"m": {"E": 2e5, "nu": 0.3}}, "parts": [
        {"name": "arm", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [60, 5]}}},
        {"name": "stop", "material": "rigid", "geometry": {"rectangle": {"min": [30, -20], "max": [60, -10]}}}],
        "supports": [{"part": "stop", "rigid": {"translation": [0, 0], "rotation": 0}},
                     {"part": "arm", "rigid": {"translation": [0, 0], "rotation": 3}}]})");
    ASSERT_TRUE(r.parts.at(0).placement);
    const double turn = 2 * std::sin(1.5 * std::numbers::pi / 180);
    EXPECT_NEAR(displacement_from_drawn(r, 0).value, turn * 0.5 * std::hypot(60, 5), 1e-6);
}

/// A ladder at 70 degrees against a wall that it touches as drawn, 40 above the floor: the wall does not hold it before it
/// stands. A block between guides as wide as it is but for 1e-3: what only prestress could hold goes on falling.
TEST(FollowMotion, FrictionHoldsNothingThatIsNotPressed) {
    const std::string held = R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 2e5, "nu": 0.3}},
        "accuracy": {"level": "draft"}, "contacts": {"friction": 0.3}, "supports": [
            {"part": "floor", "rigid": {"translation": [0, 0], "rotation": 0}},
            {"part": "left", "rigid": {"translation": [0, 0], "rotation": 0}},
            {"part": "right", "rigid": {"translation": [0, 0], "rotation": 0}}], "parts": [
            {"name": "floor", "material": "rigid", "geometry": {"rectangle": {"min": [-120, -20], "max": [120, 0]}}},
            {"name": "right", "material": "rigid", "geometry": {"rectangle": {"min": [20, 0], "max": [40, 150]}}}, )";
    const Result ladder = test::answer(held + R"(
            {"name": "left", "material": "rigid", "geometry": {"rectangle": {"min": [-120, 0], "max": [-100, 20]}}},
            {"name": "bar", "material": "m", "geometry": {"slot": {"from": [-16.20201433256688, 42],
             "to": [18, 135.96926207859082], "radius": 2}}}], "loads": [{"part": "bar", "force": [0, -100]}]})");
    ASSERT_EQ(ladder.status, "ok") << ladder.message;
    EXPECT_NEAR(ladder.parts.at(3).placement->translation.y(), -40, 1e-3);
    EXPECT_NEAR(ladder.parts.at(3).placement->rotation, 0, 1e-4);
    const Result block = test::answer(held + R"(
            {"name": "left", "material": "rigid", "geometry": {"rectangle": {"min": [-40, 0], "max": [-10.001, 150]}}},
            {"name": "block", "material": "m", "geometry": {"rectangle": {"min": [-10, 30], "max": [19.999, 50]}}}],
            "loads": [{"part": "block", "force": [0, -100]}]})");
    ASSERT_EQ(block.status, "ok") << block.message;
    EXPECT_NEAR(block.parts.at(3).placement->translation.y(), -30, 1e-3);
}

/// A wedge that an edge leads by one component only, the other one being free: it drives under a block that a spring holds
/// down.
TEST(FollowMotion, FrictionMeetsWhatOneComponentLeadsTo) {
    const Result r = test::answer(R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 2e5, "nu": 0.3}}, "parts": [
        {"name": "floor", "material": "rigid", "geometry": {"rectangle": {"min": [-100, -20], "max": [200, 0]}}},
        {"name": "wedge", "material": "m", "geometry": {"polygon": [[-60, 0], [0, 0], [0, 10], [-60, 26.076951545867363]]}},
        {"name": "block", "material": "m", "geometry": {"polygon": [[2, 10.464101615137755], [22, 5.105117766515301], [22, 60], [2, 60]]}}],
        "supports": [{"part": "floor", "rigid": {"translation": [0, 0], "rotation": 0}}, {"on": "wedge/e3", "displacement": {"x": 14}},
                     {"on": ["block/e1", "block/e3"], "symmetry": true}, {"on": "block/e2", "spring": {"normal": 2}}],
        "contacts": {"friction": 0.1}, "accuracy": {"level": "draft"}})");
    ASSERT_EQ(r.status, "ok") << r.message;
    bool any = false;
    for (const ContactResult& c : r.contacts) {
        if (c.parts[0] != "wedge" || c.parts[1] != "block") continue;
        any = true;
        EXPECT_NEAR(c.force.x() / c.force.y(), std::tan(15 * std::numbers::pi / 180 + std::atan(0.1)), 0.01);
        EXPECT_NEAR(c.force.y(), -1100, 20) << "the spring's 2 by 200 by what 14 less the way there lift";
    }
    EXPECT_TRUE(any);
}

/// A slider pushes a block to where it ends, in its reach as drawn or far from it: both slide on the floor all the way.
TEST(FollowMotion, FrictionOfWhatALedPartPushesIsAtItsLimit) {
    for (const double way : {5.0, 40.0, 2.01}) {
        SCOPED_TRACE(way);
        const Result r = test::answer(R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 2e5, "nu": 0.3}}, "parts": [
        {"name": "floor", "material": "m", "geometry": {"rectangle": {"min": [-60, -20], "max": [160, 0]}}},
        {"name": "slider", "material": "m", "geometry": {"rectangle": {"min": [-20, 0], "max": [0, 20]}}},
        {"name": "block", "material": "m", "geometry": {"rectangle": {"min": [2, 0], "max": [22, 20]}}}],
        "supports": [{"on": "floor/bottom", "fix": ["x", "y"]}, {"part": "slider", "rigid": {"translation": [)" +
                                      test::number(way) + R"(, null]}}],
        "loads": [{"part": "slider", "force": [0, -200]}, {"part": "block", "force": [0, -300]}],
        "accuracy": {"level": "draft"}, "contacts": {"friction": 0.3}})");
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_NEAR(r.reactions.at(1).force.x(), 0.3 * 500, 0.01 * 150);
        EXPECT_FALSE(std::any_of(r.reasons.begin(), r.reasons.end(), [](const Reason& reason) {
            return reason.text.find("is not at its limit") != std::string::npos;
        }));
    }
}

/// A tray takes a block along: friction carries it, and the lip that stands close behind it has nothing to push.
TEST(FollowMotion, FrictionOfWhatIsCarriedAlongIsNotDriven) {
    for (const double gap : {0.01, 0.2}) {
        SCOPED_TRACE(gap);
        const Result r = test::answer(R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 2e5, "nu": 0.3}}, "parts": [
            {"name": "tray", "material": "m", "geometry": {"union": [{"rectangle": {"min": [-50, -10], "max": [50, 0]}},
                {"rectangle": {"min": [-50, -10], "max": [-38, 9]}}, {"circle": {"center": [-40, 12], "radius": 10}}]}},
            {"name": "block", "material": "m", "geometry": {"rectangle": {"min": [)" +
                                      test::number(-30 + gap) + R"(, 0], "max": [-5, 30]}}}],
            "supports": [{"part": "tray", "rigid": {"translation": [20, 0], "rotation": 0}}],
            "loads": [{"part": "block", "force": [0, -300]}], "accuracy": {"level": "draft"}, "contacts": {"friction": 0.3}})");
        ASSERT_EQ(r.status, "ok") << r.message;
        for (const ContactResult& c : r.contacts) EXPECT_NEAR(c.force.x(), 0, 0.5);
    }
}

/// A wedge that slides a little way into its seat, with friction: one step of its load is that load.
TEST(FollowMotion, OneStepIsWhatItsLoadsAreWithoutSteps) {
    const auto seated = [](const std::string& steps) {
        return read_scene_text(R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 2e5, "nu": 0.3}}, "parts": [
            {"name": "wedge", "material": "m", "geometry": {"polygon": [[-2, 1.2], [2, 1.2], [15, 31.2], [-15, 31.2]]}},
            {"name": "left", "material": "m", "geometry": {"polygon": [[-40, 6], [-4.6, 6], [-13.26666666666667, 26], [-40, 26]]}},
            {"name": "right", "material": "m", "geometry": {"polygon": [[40, 6], [4.6, 6], [13.26666666666667, 26], [40, 26]]}}],
            "supports": [{"on": "left/e3", "fix": ["x", "y"]}, {"on": "right/e3", "fix": ["x", "y"]}],
            "loads": [{"name": "press", "part": "wedge", "force": [0, -300]}], "contacts": {"friction": 0.2},
            "accuracy": {"level": "draft"})" +
                                   steps + "}",
                               "wedge.json");
    };
    const Result plain = analyze(seated(""), {});
    const std::vector<CaseResult> step = analyze_cases(seated(R"(, "steps": [{"name": "one", "loads": {"press": 1}}])"), {});
    ASSERT_EQ(plain.status, "ok") << plain.message;
    ASSERT_EQ(step.size(), 1U);
    ASSERT_TRUE(plain.parts.at(0).placement);
    ASSERT_TRUE(step[0].result.parts.at(0).placement);
    for (std::size_t k = 0; k < 2; ++k)
        EXPECT_NEAR(step[0].result.contacts.at(k).contact_length, plain.contacts.at(k).contact_length,
                    0.01 * plain.contacts[k].contact_length);
}

/// What friction does not hold slides to what stops it, bonded of two parts as in one piece.
TEST(FollowMotion, BondedPartsSlideToWhatStopsThemWhereFrictionGivesWay) {
    const auto on_slope = [](const std::string& more, const std::string& loads, const std::string& pairs) {
        return test::answer(R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 2e5, "nu": 0.3}}, "parts": [
            {"name": "table", "material": "rigid", "geometry": {"rectangle": {"min": [-100, -20], "max": [100, 0]}}},
            {"name": "stop", "material": "rigid", "geometry": {"rectangle": {"min": [-100, 0], "max": [-80, 40]}}},
            {"name": "low", "material": "m", "geometry": {"rectangle": {"min": [-20, 0], "max": [0, 10]}}})" +
                            more + R"(], "supports": [{"part": "table", "rigid": {"translation": [0, 0], "rotation": 0}},
                {"part": "stop", "rigid": {"translation": [0, 0], "rotation": 0}}],
            "loads": [{"part": "low", "force": [-25, -43.3]})" +
                            loads + R"(], "accuracy": {"level": "draft"}, "contacts": {"friction": 0.3)" + pairs + "}}");
    };
    const Result one = on_slope("", "", ""),
                 two = on_slope(
                     R"(, {"name": "up", "material": "m", "geometry": {"rectangle": {"min": [-20, 10], "max": [0, 20]}}})",
                     R"(, {"part": "up", "force": [-25, -43.3]})",
                     R"(, "pairs": [{"between": ["low/*", "up/*"], "kind": "bonded"}])");
    for (const Result* r : {&one, &two}) {
        ASSERT_EQ(r->status, "ok") << r->message;
        EXPECT_NEAR(r->parts.at(2).placement.value().translation.x(), -60, 1e-6);
        EXPECT_NEAR(r->parts.at(2).placement.value().translation.y(), 0, 1e-6);
        EXPECT_TRUE(test::warns(r->warnings, "low slides along (-1, 0)"));
    }
    EXPECT_TRUE(test::warns(one.warnings, "A coefficient of friction of 0.5774 would hold it, 0.3 does not"));
}

}  // namespace abut::follow_motion_test
