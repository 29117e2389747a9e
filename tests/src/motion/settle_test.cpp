// SPDX-License-Identifier: GPL-3.0-or-later
// Where rigid parts come to rest, against statics and geometry by hand.
#include "src/motion/settle.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <sstream>

#include "src/scene/read_scene.hpp"

namespace abut::settle_test {
namespace {

constexpr double of_size = 1e-4;  // what a place of rest is known to

Scene scene_of(const std::string& parts, const std::string& supports, const std::string& loads, const std::string& more = "") {
    return read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3, "density": 2}}, "parts": [)" + parts +
                               R"(], "supports": [)" + supports + R"(], "loads": [)" + loads + "]" + more + "}",
                           "s.json");
}

Settling settling_of(const Scene& scene) {
    return settle(scene, resolve_conditions(scene));
}

Vec2 way(const Scene& scene, const Settling& settling, std::size_t part) {
    const Vec2 c = centroid(scene.parts.at(part).part);
    return settling.placements.at(part).of(c) - c;
}

std::string part(const std::string& name, const std::string& geometry) {
    return R"({"name": ")" + name + R"(", "material": "m", "geometry": )" + geometry + "}";
}

std::string scientific(double v) {
    std::ostringstream text;
    text << std::scientific << v;
    return text.str();
}

const std::string floor_part = part("floor", R"({"rectangle": {"min": [-50, -10], "max": [50, 0]}})");
const std::string held_floor = R"({"on": "floor/bottom", "fix": ["x", "y"]})";

std::string hole_and_pin(double r, const Vec2& at) {
    return part("plate", R"({"difference": [{"rectangle": {"min": [-30, -30], "max": [30, 30]}, "name": "p"},
                                            {"circle": {"center": [0, 0], "radius": 10}, "name": "h"}]})") +
           ", " +
           part("pin", R"({"circle": {"center": [)" + std::to_string(at.x()) + ", " + std::to_string(at.y()) +
                           R"(], "radius": )" + std::to_string(r) + "}}");
}

TEST(Settle, APinFindsTheBottomOfItsHoleFromAnywhere) {
    for (const Vec2& at : {Vec2(0, 4), Vec2(4, 0), Vec2(0, 0), Vec2(-2, -3), Vec2(0.1, 3.9)})
        for (const double degrees : {-90.0, 23.0}) {
            const Vec2 along(std::cos(degrees * std::numbers::pi / 180), std::sin(degrees * std::numbers::pi / 180));
            const Scene scene = scene_of(hole_and_pin(6, at), R"({"on": "plate/p/bottom", "fix": ["x", "y"]})",
                                         R"({"part": "pin", "force": [)" + std::to_string(100 * along.x()) + ", " +
                                             std::to_string(100 * along.y()) + "]}");
            const Settling settling = settling_of(scene);
            ASSERT_EQ(settling.end, Settling::End::rests) << at.transpose() << " " << degrees << settling.why;
            const Vec2 rest = at + way(scene, settling, 1);
            EXPECT_NEAR((rest - 4 * along).norm(), 0, 12 * of_size) << at.transpose() << " " << degrees;
            EXPECT_EQ(settling.placements.at(0).shift, Vec2(0, 0));
            EXPECT_EQ(settling.parts, std::vector<std::string>{"pin"});
        }
}

/// Coordinates of a site plan or of a car's body.
TEST(Settle, FarFromTheOriginToo) {
    for (const double far : {3e5, 1e7}) {
        const std::string disc = part("disc", R"({"circle": {"center": [)" + std::to_string(far) + R"(, 12], "radius": 10}})");
        const std::string floor = part("floor", R"({"rectangle": {"min": [)" + std::to_string(far - 50) +
                                                    R"(, -10], "max": [)" + std::to_string(far + 50) + ", 0]}}");
        const Scene scene = scene_of(floor + ", " + disc, held_floor, R"({"part": "disc", "force": [0, -100]})");
        const Settling settling = settling_of(scene);
        ASSERT_EQ(settling.end, Settling::End::rests) << settling.why;
        EXPECT_NEAR((way(scene, settling, 1) - Vec2(0, -2)).norm(), 0, 20 * of_size) << far;
        EXPECT_EQ(settling.placements.at(0).shift, Vec2(0, 0));
    }
}

/// Where a force acts along a round part's middle is known to many more digits than where the gap beside it is least: the
/// answer's balance depends on it.
TEST(Settle, KnowsTheDirectionThatARoundPartIsPressedIn) {
    for (const double r : {2.0, 6.0, 8.0})
        for (const double degrees : {-90.0, 23.0, 101.0}) {
            const double angle = degrees * std::numbers::pi / 180;
            const Vec2 force(100 * std::cos(angle), 100 * std::sin(angle));
            const Scene scene =
                scene_of(hole_and_pin(r, {0.1, 0.2}), R"({"on": "plate/p/bottom", "fix": ["x", "y"]})",
                         R"({"part": "pin", "force": [)" + scientific(force.x()) + ", " + scientific(force.y()) + "]}");
            const Settling settling = settling_of(scene);
            ASSERT_EQ(settling.end, Settling::End::rests) << r << settling.why;
            const Vec2 loaded(scene.loads.at(0).value[0].constant(), scene.loads.at(0).value[1].constant());
            const Vec2 rest = centroid(scene.parts.at(1).part) + way(scene, settling, 1);
            EXPECT_NEAR(geometry::cross(rest, loaded) / (rest.norm() * loaded.norm()), 0, 1e-9) << r << " " << degrees;
        }
}

/// What pulls a chain turns its links into one line, which gaps along them do not see.
TEST(Settle, APulledChainIsStraight) {
    std::string parts;
    const auto add = [&](const std::string& one) { parts += (parts.empty() ? "" : ", ") + one; };
    constexpr int links = 4;
    constexpr double pitch = 16, hole = 2.6, pin = 2.5;
    for (int k = 0; k < links; ++k) {
        const std::string level = std::to_string(1 + k % 2);
        add(R"({"name": "link)" + std::to_string(k) + R"(", "material": "m", "level": )" + level +
            R"(, "place": {"translate": [)" + std::to_string(pitch * k) + R"(, 0]}, "geometry": {"difference": [
                {"slot": {"from": [0, 0], "to": [16, 0], "radius": 7}, "name": "plate"},
                {"circle": {"center": [0, 0], "radius": )" +
            std::to_string(hole) + R"(}, "name": "a"}, {"circle": {"center": [16, 0], "radius": )" + std::to_string(hole) +
            R"(}, "name": "b"}]}})");
        if (k + 1 < links)
            add(part("pin" + std::to_string(k), R"({"circle": {"center": [)" + std::to_string(pitch * (k + 1)) +
                                                    R"(, 0], "radius": )" + std::to_string(pin) + "}}"));
    }
    for (const double degrees : {0.0, 30.0}) {
        const Vec2 along(std::cos(degrees * std::numbers::pi / 180), std::sin(degrees * std::numbers::pi / 180));
        // the first link hangs on a held pin
        const Scene scene = scene_of(
            part("post", R"({"circle": {"center": [0, 0], "radius": 2.5}})") + ", " + parts,
            R"({"part": "post", "rigid": {"translation": [0, 0], "rotation": 0}})",
            R"({"part": "pin2", "force": [)" + scientific(100 * along.x()) + ", " + scientific(100 * along.y()) + "]}");
        const Settling settling = settling_of(scene);
        ASSERT_EQ(settling.end, Settling::End::rests) << degrees << settling.why;
        for (std::size_t i = 1; i < scene.parts.size(); ++i) {
            if (scene.parts[i].name.rfind("pin", 0) != 0) continue;
            const Vec2 rest = centroid(scene.parts[i].part) + way(scene, settling, i);
            EXPECT_NEAR(geometry::cross(along, rest), 0, 1e-6) << degrees << " " << scene.parts[i].name;
        }
    }
}

TEST(Settle, WhatGoesNotFarStays) {
    const Scene scene = scene_of(hole_and_pin(9.9, {0, 0}), R"({"on": "plate/p/bottom", "fix": ["x", "y"]})",
                                 R"({"part": "pin", "force": [0, -100]})");
    EXPECT_EQ(settling_of(scene).end, Settling::End::stays);
    EXPECT_FALSE(large_motion_effect(settling_of(scene)).on);
}

TEST(Settle, ABlockLiesFlush) {
    for (const double tilt : {-30.0, -4.0, 1.0, 10.0}) {
        const Scene scene = scene_of(floor_part + R"(, {"name": "block", "material": "m", "place": {"rotate": )" +
                                         std::to_string(tilt) + R"(, "translate": [0, 7]},
                                         "geometry": {"rectangle": {"min": [-5, 0], "max": [5, 6]}}})",
                                     held_floor, R"({"gravity": [0, -1]})");
        const Settling settling = settling_of(scene);
        ASSERT_EQ(settling.end, Settling::End::rests) << tilt;
        EXPECT_NEAR(settling.placements.at(1).angle, -tilt * std::numbers::pi / 180, of_size) << tilt;
        EXPECT_NEAR(centroid(scene.parts.at(1).part).y() + way(scene, settling, 1).y(), 3, 12 * of_size) << tilt;
    }
}

TEST(Settle, ABlockThatIsPushedTips) {
    // the load acts beyond its edge: it falls on its side
    const Scene scene =
        scene_of(floor_part + R"(, {"name": "block", "material": "m", "place": {"rotate": -30, "translate": [0, 3]},
                                     "geometry": {"rectangle": {"min": [-2, 0], "max": [2, 10]}}})",
                 held_floor, R"({"part": "block", "force": [0, -1]})");
    const Settling settling = settling_of(scene);
    ASSERT_EQ(settling.end, Settling::End::rests) << settling.why;
    EXPECT_NEAR(settling.placements.at(1).angle, -60 * std::numbers::pi / 180, of_size);
}

TEST(Settle, NamesWhatNothingStopsHoweverSmallItsLoad) {
    for (const double push : {1.0, 1e-2, 1e-4}) {
        const Scene scene = scene_of(floor_part + ", " + part("disc", R"({"circle": {"center": [0, 5], "radius": 5}})"),
                                     held_floor, R"({"part": "disc", "force": [)" + std::to_string(push) + ", -100]}");
        const Settling settling = settling_of(scene);
        EXPECT_EQ(settling.end, Settling::End::never) << push << settling.why;
        EXPECT_EQ(settling.parts, std::vector<std::string>{"disc"});
        EXPECT_NE(settling.why.find("disc by ("), std::string::npos) << settling.why;
    }
}

TEST(Settle, AStopEndsASlideUnderASmallLoad) {
    const Scene scene =
        scene_of(floor_part + ", " + part("stop", R"({"rectangle": {"min": [12, 0], "max": [22, 10]}})") + ", " +
                     part("disc", R"({"circle": {"center": [0, 5], "radius": 5}})"),
                 held_floor + R"(, {"on": "stop/top", "fix": ["x", "y"]})", R"({"part": "disc", "force": [0.01, -100]})");
    const Settling settling = settling_of(scene);
    ASSERT_EQ(settling.end, Settling::End::rests) << settling.why;
    EXPECT_NEAR((way(scene, settling, 2) - Vec2(7, 0)).norm(), 0, 14 * of_size);
}

TEST(Settle, GoesAsFarAsItHasTo) {
    const std::string far_stop = part("stop", R"({"rectangle": {"min": [30, 0], "max": [40, 10]}})");
    const Scene scene =
        scene_of(floor_part + ", " + far_stop + ", " + part("disc", R"({"circle": {"center": [0, 5], "radius": 5}})"),
                 held_floor + R"(, {"on": "stop/top", "fix": ["x", "y"]})", R"({"part": "disc", "force": [1, -100]})");
    const Settling settling = settling_of(scene);
    ASSERT_EQ(settling.end, Settling::End::rests) << settling.why;
    EXPECT_NEAR((way(scene, settling, 2) - Vec2(25, 0)).norm(), 0, 14 * of_size);
    const Scene hole = scene_of(hole_and_pin(2, {0, 8}), R"({"on": "plate/p/bottom", "fix": ["x", "y"]})",
                                R"({"part": "pin", "force": [0, -1]})");
    EXPECT_EQ(settling_of(hole).end, Settling::End::rests);
}

/// From above one of its faces, several diameters aside, in any unit.
TEST(Settle, ADiscRollsIntoItsGroove) {
    for (const double unit : {1.0, 1e-3}) {
        const auto number = [&](double v) { return std::to_string(v * unit); };
        const auto at = [&](double x, double y) { return "[" + number(x) + ", " + number(y) + "]"; };
        const Scene scene =
            scene_of(part("groove", "{\"polygon\": [" + at(-60, -30) + ", " + at(60, -30) + ", " + at(60, 60) + ", " +
                                        at(0, 0) + ", " + at(-60, 60) + "]}") +
                         ", " + part("disc", R"({"circle": {"center": )" + at(35, 60) + R"(, "radius": )" + number(8) + "}}"),
                     R"({"on": "groove/e0", "fix": ["x", "y"]})", R"({"part": "disc", "force": [0, -100]})");
        const Settling settling = settling_of(scene);
        ASSERT_EQ(settling.end, Settling::End::rests) << unit << settling.why;
        const Vec2 rest = Vec2(35, 60) + way(scene, settling, 1) / unit;
        EXPECT_NEAR((rest - Vec2(0, 8 * std::numbers::sqrt2)).norm(), 0, 20 * of_size) << unit;
    }
}

/// An arm with a load in its middle, loose on a fixed pin.
std::string hanging(double degrees, double pin) {
    return part("pin", R"({"circle": {"center": [0, 0], "radius": )" + std::to_string(pin) + "}}") +
           R"(, {"name": "arm", "material": "m", "place": {"rotate": )" + std::to_string(degrees) +
           R"(}, "geometry": {"difference": [{"union": [{"circle": {"center": [0, 0], "radius": 10}, "name": "eye"},
               {"rectangle": {"min": [0, -3], "max": [60, 3]}, "name": "bar"}]},
               {"circle": {"center": [0, 0], "radius": 5}, "name": "hole"}]}})";
}

TEST(Settle, AnArmHangsBelowItsPin) {
    const std::string held = R"({"part": "pin", "rigid": {"translation": [0, 0], "rotation": 0}})",
                      down = R"({"part": "arm", "force": [0, -100]})";
    for (const double pin : {4.95, 4.0})
        for (const double from : {0.0, 60.0, -60.0, -89.0, -150.0}) {
            const Settling settling = settling_of(scene_of(hanging(from, pin), held, down));
            ASSERT_EQ(settling.end, Settling::End::rests) << from << settling.why;
            EXPECT_NEAR(settling.placements.at(1).angle * 180 / std::numbers::pi, -90 - from, 0.01) << from << " " << pin;
        }
    const Settling upright = settling_of(scene_of(hanging(90, 4.95), held, down));
    EXPECT_EQ(upright.end, Settling::End::never) << upright.why;
    EXPECT_NE(upright.why.find("unstable"), std::string::npos) << upright.why;
}

TEST(Settle, WhatIsPulledApartTurnsBackByItsLoads) {
    // about the middle of the slot's end: 1000 (40 s + 7.5 c) + 2000 (60 s + 7.5 c) = 0
    const double turn = -std::atan(22.5 / 160);
    const std::string plate = part(
        "plate", R"({"difference": [{"polygon": [[-50, -15], [50, -15], [50, 0], [50, 15], [-50, 15], [-50, 0]], "name": "o"},
                         {"slot": {"from": [-10, 0], "to": [10, 0], "radius": 5}, "name": "s"}]})");
    for (const double r : {4.5, 4.99})
        for (const double x : {0.0, 10.0}) {
            const std::string bolt = part(
                "bolt", R"({"circle": {"center": [)" + std::to_string(x) + R"(, 0], "radius": )" + std::to_string(r) + "}}");
            const Settling settling = settling_of(
                scene_of(plate + ", " + bolt, R"({"part": "bolt", "rigid": {"translation": [0, 0], "rotation": 0}})",
                         R"({"on": "plate/o/e2", "force": [1000, 0]}, {"on": "plate/o/e5", "force": [-2000, 0]})"));
            ASSERT_EQ(settling.end, Settling::End::rests) << r << " " << x << settling.why;
            EXPECT_NEAR(settling.placements.at(0).angle, turn, 1e-4);
        }
}

TEST(Settle, AColumnOfManyDiscsIsUnstable) {
    constexpr int n = 50;
    std::string parts = floor_part;
    for (int k = 0; k < n; ++k)
        parts += ", " + part("d" + std::to_string(k),
                             R"({"circle": {"center": [0, )" + std::to_string(2 * k + 1) + R"(], "radius": 1}})");
    parts += ", " + part("lid", R"({"rectangle": {"min": [-2, )" + std::to_string(2 * n) + R"(], "max": [2, )" +
                                    std::to_string(2 * n + 2) + "]}}");
    const Settling settling =
        settling_of(scene_of(parts, held_floor + R"(, {"part": "lid", "rigid": {"translation": [0, null], "rotation": 0}})",
                             R"({"part": "lid", "force": [0, -100]})"));
    EXPECT_EQ(settling.end, Settling::End::stays) << settling.why;
    EXPECT_EQ(settling.unstable.find("the balance is unstable: the least push takes d"), 0u) << settling.unstable;
}

/// Half on a table, half beyond: its middle decides.
TEST(Settle, ABlockOnALedgeStaysOrTips) {
    for (const bool stays : {true, false})
        for (const double tilt : {3.0, -2.0}) {
            const Settling settling = settling_of(scene_of(
                floor_part +
                    R"(, {"name": "block", "material": "m", "geometry": {"rectangle": {"min": [-10, -3], "max": [10, 3]}},
                    "place": {"rotate": )" +
                    std::to_string(tilt) + R"(, "translate": [)" + (stays ? "47" : "54") + ", 5]}}",
                held_floor, R"({"gravity": [0, -1]})"));
            EXPECT_EQ(settling.end, stays ? Settling::End::rests : Settling::End::never) << tilt << settling.why;
            if (stays) { EXPECT_NEAR(settling.placements.at(1).angle, -tilt * std::numbers::pi / 180, of_size); }
        }
}

/// Down a slope into the corner at its foot, and on along the floor to a stop.
TEST(Settle, ACornerSlidesPastTheEndOfItsFace) {
    for (const double stop : {25.0, 55.0}) {
        const Scene scene =
            scene_of(part("slope", R"({"polygon": [[-60, -30], [60, -30], [60, 0], [0, 0], [-60, 40]]})") + ", " +
                         part("stop", R"({"rectangle": {"min": [)" + std::to_string(stop) + R"(, 0], "max": [)" +
                                          std::to_string(stop + 10) + R"(, 30]}})") +
                         R"(, {"name": "block", "material": "m", "geometry": {"rectangle": {"min": [-6, -4], "max": [6, 4]}},
                      "place": {"rotate": -33.69, "translate": [-20, 24]}})",
                     R"({"on": "slope/e0", "fix": ["x", "y"]}, {"on": "stop/right", "fix": ["x", "y"]})",
                     R"({"part": "block", "force": [0.01, -100]})");
        const Settling settling = settling_of(scene);
        ASSERT_EQ(settling.end, Settling::End::rests) << stop << settling.why;
        EXPECT_NEAR(settling.placements.at(2).angle * 180 / std::numbers::pi, 33.69, 0.01) << stop;
        EXPECT_NEAR((Vec2(-20, 24) + way(scene, settling, 2) - Vec2(stop - 6, 4)).norm(), 0, 20 * of_size) << stop;
    }
}

/// Two pins in holes of their own: each follows its load, whatever the other's.
TEST(Settle, LoadsAreLargeOrSmallBesideTheirOwnPartOnly) {
    for (const double small : {1.0, 1e-6, 1e-12}) {
        const Scene scene =
            scene_of(part("plate", R"({"difference": [{"rectangle": {"min": [-30, -30], "max": [90, 30]}, "name": "p"},
                {"circle": {"center": [0, 0], "radius": 10}, "name": "h"}, {"circle": {"center": [60, 0], "radius": 10}, "name": "k"}]})") +
                         ", " + part("one", R"({"circle": {"center": [1, 0.5], "radius": 8}})") + ", " +
                         part("other", R"({"circle": {"center": [60, 1.5], "radius": 8}})"),
                     R"({"on": "plate/p/bottom", "fix": ["x", "y"]})",
                     R"({"part": "one", "force": [0, -1000]}, {"part": "other", "force": [)" + scientific(700 * small) + ", " +
                         scientific(-700 * small) + "]}");
        const Settling settling = settling_of(scene);
        ASSERT_EQ(settling.end, Settling::End::rests) << settling.why;
        const double half = std::numbers::sqrt2;
        EXPECT_NEAR((way(scene, settling, 2) - Vec2(half, -1.5 - half)).norm(), 0, 16 * of_size) << small;
    }
}

/// A place to begin from, as steps have.
TEST(Settle, BeginsWhereTheStepBeforeEnds) {
    const auto under = [](const std::string& force) {
        return scene_of(hole_and_pin(6, {0, 0}), R"({"on": "plate/p/bottom", "fix": ["x", "y"]})",
                        R"({"part": "pin", "force": )" + force + "}");
    };
    const Settling first = settling_of(under("[100, 0]"));
    const Scene unloaded = under("[0, 0]"), next = under("[0, -100]");
    const Settling second = settle(unloaded, resolve_conditions(unloaded), first.placements),
                   third = settle(next, resolve_conditions(next), second.placements);
    ASSERT_EQ(second.end, Settling::End::rests) << second.why;
    EXPECT_NEAR((way(unloaded, second, 1) - Vec2(4, 0)).norm(), 0, 12 * of_size);
    ASSERT_EQ(third.end, Settling::End::rests) << third.why;
    EXPECT_NEAR((way(next, third, 1) - Vec2(0, -4)).norm(), 0, 12 * of_size);
}

/// A bar on its round tip falls; a disc rolls nowhere.
TEST(Settle, TellsAnUnstableBalance) {
    for (const double height : {2.0, 40.0}) {
        const Scene scene = scene_of(
            floor_part + ", " +
                part("bar", R"({"union": [{"rectangle": {"min": [-3, 3], "max": [3, )" + std::to_string(3 + height) +
                                R"(]}, "name": "shaft"}, {"circle": {"center": [0, 5], "radius": 5}, "name": "tip"}]})"),
            held_floor, R"({"gravity": [0, -1]})");
        const Settling settling = settling_of(scene);
        EXPECT_EQ(settling.end, height > 10 ? Settling::End::never : Settling::End::stays) << height << settling.why;
    }
}

/// A plank on a held disc slides and tips until its end is on the floor; on a held block it stays.
TEST(Settle, TellsABalanceThatEndsAtAnotherPlaceOfRest) {
    const auto unstable = [](const std::string& below) {
        const Settling settling =
            settling_of(scene_of(floor_part + ", " + part("post", below) + ", " +
                                     part("plank", R"({"rectangle": {"min": [-20, 5], "max": [20, 12]}})"),
                                 held_floor + R"(, {"part": "post", "rigid": {"translation": [0, 0], "rotation": 0}})",
                                 R"({"part": "plank", "force": [0, -100]})"));
        EXPECT_EQ(settling.end, Settling::End::stays) << below << settling.why;
        return settling.unstable;
    };
    EXPECT_EQ(
        unstable(R"({"circle": {"center": [0, 3], "radius": 2}})").find("the balance is unstable: the least push takes plank"),
        0u);
    EXPECT_EQ(unstable(R"({"rectangle": {"min": [-2, 1], "max": [2, 5]}})"), "");
}

/// The groove's support turns it, the wedge in it goes along.
TEST(Settle, PrescribedMotionsTakePartsAlong) {
    Scene scene = read_scene(ABUT_SOURCE_DIR "/data/verification/turned_wedge.json", {{"turn", 90}});
    const Settling settling = settling_of(scene);
    ASSERT_EQ(settling.end, Settling::End::rests) << settling.why;
    EXPECT_EQ(settling.placements.at(0).angle, std::numbers::pi / 2);
    EXPECT_EQ((way(scene, settling, 0)), Vec2(0, 0));
    EXPECT_NEAR(settling.placements.at(1).angle, std::numbers::pi / 2, 1e-9);
}

/// By edges, as far as something stops it: what is left of the way is for the bodies to give in.
TEST(Settle, EdgesLeadTheirPartAsAWhole) {
    const std::string block = part("block", R"({"rectangle": {"min": [0, 0], "max": [20, 10]}})"),
                      jaw = part("jaw", R"({"rectangle": {"min": [23, 2], "max": [38, 8]}})"),
                      held = R"({"on": "block/left", "fix": ["x", "y"]}, )";
    const auto led = [&](const std::string& support) { return scene_of(block + ", " + jaw, held + support, ""); };
    const Scene stopped = led(R"({"on": "jaw/right", "displacement": {"x": -3.01, "y": 0}})");
    const Settling settling = settling_of(stopped);
    ASSERT_EQ(settling.end, Settling::End::rests) << settling.why;
    EXPECT_NEAR((way(stopped, settling, 1) - Vec2(-3, 0)).norm(), 0, 16 * of_size);
    const Scene there = placed(stopped, resolve_conditions(stopped), settling.placements);
    EXPECT_NEAR(there.supports.at(1).value[0].constant(), -0.01, 16 * of_size);
    const Scene free = led(R"({"on": "jaw/right", "displacement": {"x": 4, "y": 1}})");
    EXPECT_EQ((way(free, settling_of(free), 1)), Vec2(4, 1));
    // what it slides along does not take it off its line
    const Scene oblique = scene_of(part("block", R"({"polygon": [[0, 0], [20, 0], [10, 10], [0, 10]]})") + ", " + jaw,
                                   R"({"on": "block/e3", "fix": ["x", "y"]}, )"
                                   R"({"on": "jaw/right", "displacement": {"x": -8, "y": -4}})",
                                   "");
    const Vec2 gone = way(oblique, settling_of(oblique), 1);
    EXPECT_NEAR(gone.y(), gone.x() / 2, 16 * of_size);
    EXPECT_NEAR(gone.x() + gone.y(), -5, 16 * of_size);
    const Scene guided = led(R"({"on": "jaw/right", "displacement": {"x": -2}}, {"on": "jaw/bottom", "fix": ["y"]})");
    EXPECT_EQ((way(guided, settling_of(guided), 1)), Vec2(-2, 0));
}

/// A disc that nothing else holds is pushed across to the other jaw, and not squeezed out.
TEST(Settle, AJawClosesOnWhatLiesLoose) {
    const Scene scene = scene_of(part("fixed", R"({"rectangle": {"min": [-40, 0], "max": [-20, 20]}})") + ", " +
                                     part("work", R"({"circle": {"center": [0, 8], "radius": 8}})") + ", " +
                                     part("jaw", R"({"rectangle": {"min": [20, 0], "max": [40, 20]}})"),
                                 R"({"on": "fixed/left", "fix": ["x", "y"]},
                                    {"on": "jaw/right", "displacement": {"x": -24.02, "y": 0}})",
                                 "");
    const Settling settling = settling_of(scene);
    ASSERT_EQ(settling.end, Settling::End::rests) << settling.why;
    EXPECT_NEAR(way(scene, settling, 1).x(), -12, 16 * of_size);
    EXPECT_NEAR(way(scene, settling, 1).y(), 0, 0.1);  // between flat faces it lies anywhere
    EXPECT_NEAR((way(scene, settling, 2) - Vec2(-24, 0)).norm(), 0, 28 * of_size);
}

/// Far is what is far beside the smaller of two parts that come near each other.
TEST(Settle, AnEyeGoesFarBesideItsPin) {
    const Scene scene = read_scene(ABUT_SOURCE_DIR "/data/verification/led_strap.json");
    const Settling settling = settling_of(scene);
    ASSERT_EQ(settling.end, Settling::End::rests) << settling.why;
    EXPECT_NEAR((way(scene, settling, 1) - Vec2(3.05, 0)).norm(), 0, 85 * of_size);
}

TEST(Settle, IsNotAskedWhereWhatIsPrescribedDeforms) {
    const std::string bar = part("bar", R"({"rectangle": {"min": [0, 0], "max": [20, 4]}})"),
                      disc = part("disc", R"({"circle": {"center": [10, 8], "radius": 3}})");
    for (const char* support :
         {R"({"on": "bar/left", "fix": ["x", "y"]}, {"on": "bar/right", "displacement": {"y": -5}})",
          R"({"on": "bar/bottom", "spring": {"normal": 10}}, {"on": "bar/right", "displacement": {"y": -5}})",
          R"({"on": "bar/right", "displacement": {"y": "-5 + x/100", "x": 0}})",
          R"({"on": "bar/bottom", "displacement": {"x": -5}})"})
        EXPECT_EQ(settling_of(scene_of(bar + ", " + disc, support, R"({"part": "disc", "force": [0, -1]})")).end,
                  Settling::End::not_asked)
            << support;
}

/// By a little: that part is held where it is drawn, and others are followed.
TEST(Settle, PartsAreFollowedBesideOnesThatAreDeformedALittle) {
    const std::string two =
                          hole_and_pin(6, {0, 0}) + ", " + part("far", R"({"rectangle": {"min": [100, 0], "max": [120, 20]}})"),
                      held = R"({"on": ["plate/p/bottom", "far/bottom"], "fix": ["x", "y"]}, )";
    const auto followed = [&](const std::string& moved) {
        return settling_of(scene_of(two, held + moved, R"({"part": "pin", "force": [0, -1]})"));
    };
    for (const char* little : {R"({"on": "far/top", "displacement": {"y": -0.01}})",
                               R"({"on": "far/top", "displacement": {"y": "-0.01*(x - 100)/20"}})"}) {
        const Settling settling = followed(little);
        ASSERT_EQ(settling.end, Settling::End::rests) << settling.why;
        EXPECT_NEAR(settling.placements.at(1).shift.y(), -4, 12 * of_size) << little;
        EXPECT_TRUE(settling.placements.at(2).goes_nowhere());
    }
    EXPECT_EQ(followed(R"({"on": "far/top", "displacement": {"y": -5}})").end, Settling::End::not_asked);
    // where it may move besides, what is prescribed would have to go along
    EXPECT_EQ(settling_of(scene_of(two,
                                   R"({"on": "plate/p/bottom", "fix": ["x", "y"]}, {"on": "far/bottom", "fix": ["y"]},
                                      {"on": "far/top", "displacement": {"y": -0.01}})",
                                   R"({"part": "pin", "force": [0, -1]})"))
                  .end,
              Settling::End::not_asked);
}

/// An upright edge that is held in height lets its part turn as drawn, and no more once it leans.
TEST(Settle, WhatItsSupportsLockOnItsWayRestsThere) {
    const Scene scene = scene_of(part("arm", R"({"rectangle": {"min": [0, 0], "max": [100, 10]}})") + ", " +
                                     part("stop", R"({"rectangle": {"min": [60, -40], "max": [100, -8]}})"),
                                 R"({"on": "arm/left", "fix": ["y"]}, {"part": "arm", "at": [0, 5], "fix": ["x"]},
                                    {"on": "stop/bottom", "fix": ["x", "y"]})",
                                 R"({"on": "arm/right", "force": [0, -10]})");
    const Settling settling = settling_of(scene);
    ASSERT_EQ(settling.end, Settling::End::rests) << settling.why;
    EXPECT_LT(settling.placements.at(0).angle, 0);
}

/// A lever with a nose of its own, bonded to it, falls on a stop as one of one piece does.
TEST(Settle, BondedPartsMoveAsOne) {
    const std::string arm = R"({"rectangle": {"min": [0, -4], "max": [100, 4]}}, {"circle": {"center": [0, 0], "radius": 10}})",
                      nose = R"({"circle": {"center": [100, 0], "radius": 6}})",
                      eye = R"({"circle": {"center": [0, 0], "radius": 5.005}})",
                      others = part("stop", R"({"rectangle": {"min": [70, -40], "max": [110, -14]}})") + ", " +
                               part("pin", R"({"circle": {"center": [0, 0], "radius": 5}})") + ", ",
                      held = R"({"on": "stop/bottom", "fix": ["x", "y"]}, )"
                             R"({"part": "pin", "rigid": {"translation": [0, 0], "rotation": 0}})",
                      load = R"({"on": {"part": "arm", "near": [50, 4]}, "force": [0, -300], "at": [50, 4]})";
    const auto less = [](const std::string& first, const std::string& rest) {
        return R"({"difference": [{"union": [)" + first + "]}, " + rest + "]}";
    };
    const Scene one = scene_of(others + part("arm", less(arm + ", " + nose, eye)), held, load),
                two = scene_of(others + part("arm", less(arm, eye + ", " + nose)) + ", " + part("nose", nose), held, load,
                               R"(, "contacts": {"pairs": [{"between": ["arm/*", "nose/*"], "kind": "bonded"}]})");
    const Settling whole = settling_of(one), bonded = settling_of(two);
    ASSERT_EQ(whole.end, Settling::End::rests) << whole.why;
    ASSERT_EQ(bonded.end, Settling::End::rests) << bonded.why;
    const Placement &a = bonded.placements.at(2), &n = bonded.placements.at(3);
    EXPECT_TRUE(a.angle == n.angle && a.shift == n.shift);
    EXPECT_NEAR(a.angle, whole.placements.at(2).angle, 1e-8);
    EXPECT_NEAR((a.shift - whole.placements.at(2).shift).norm(), 0, 1e-6);
}

TEST(Settle, OnePartPushesAnother) {
    const Scene scene = scene_of(floor_part + ", " + part("stop", R"({"rectangle": {"min": [12, 0], "max": [22, 10]}})") +
                                     ", " + part("first", R"({"rectangle": {"min": [-14, 0], "max": [-4, 6]}})") + ", " +
                                     part("second", R"({"rectangle": {"min": [-2, 0], "max": [8, 6]}})"),
                                 held_floor + R"(, {"on": "stop/top", "fix": ["x", "y"]})",
                                 R"({"part": "first", "force": [10, -10]}, {"part": "second", "force": [0, -10]})");
    const Settling settling = settling_of(scene);
    ASSERT_EQ(settling.end, Settling::End::rests) << settling.why;
    EXPECT_NEAR((way(scene, settling, 2) - Vec2(6, 0)).norm(), 0, 14 * of_size);
    EXPECT_NEAR((way(scene, settling, 3) - Vec2(4, 0)).norm(), 0, 14 * of_size);
}

TEST(Settle, AGuidedPartKeepsToItsGuide) {
    const Scene scene = scene_of(floor_part + ", " + part("ram", R"({"rectangle": {"min": [-3, 8], "max": [3, 20]}})"),
                                 held_floor + R"(, {"on": ["ram/left", "ram/right"], "symmetry": true})",
                                 R"({"part": "ram", "force": [50, -10]})");
    const Settling settling = settling_of(scene);
    ASSERT_EQ(settling.end, Settling::End::rests) << settling.why;
    EXPECT_NEAR((way(scene, settling, 1) - Vec2(0, -8)).norm(), 0, 14 * of_size);
    EXPECT_EQ(settling.placements.at(1).angle, 0);
}

TEST(Settle, APartWhoseMiddleIsGuidedFallsStraightHoweverItTurns) {
    const std::string disc = R"({"circle": {"radius": 5, "center": )";
    const Scene scene = scene_of(floor_part + ", " + part("l", disc + "[-30, 5]}}") + ", " + part("r", disc + "[30, 5]}}") +
                                     ", " + part("beam", R"({"rectangle": {"min": [-40, 30], "max": [45, 38]}})"),
                                 held_floor +
                                     R"(, {"part": "l", "rigid": {"translation": [0, null], "rotation": 0}},
            {"part": "r", "rigid": {"translation": [0, null], "rotation": 0}},
            {"part": "beam", "rigid": {"translation": [0, null]}})",
                                 R"({"part": "beam", "force": [0, -30]}, {"on": "beam/right", "force": [0, -5]})");
    const Settling settling = settling_of(scene);
    ASSERT_EQ(settling.end, Settling::End::rests) << settling.why;
    EXPECT_LT((way(scene, settling, 3) - Vec2(0, -20)).norm(), 85 * of_size);
    EXPECT_LT(std::abs(way(scene, settling, 3).x()), 1e-9);
}

/// A bar that a support turns lifts a disc to a lid, which stops it: the rest of the turn is for the bodies.
TEST(Settle, ATurnThatSomethingStopsEndsThere) {
    constexpr double gap = 0.5, x = 40, y = 13 + gap;
    const Scene scene = scene_of(part("bar", R"({"rectangle": {"min": [-50, -5], "max": [50, 5]}})") + ", " +
                                     part("disc", R"({"circle": {"center": [40, 13], "radius": 8}})") + ", " +
                                     part("lid", R"({"rectangle": {"min": [20, 21.5], "max": [60, 35]}})"),
                                 R"({"part": "bar", "rigid": {"translation": [0, 0], "rotation": 5}},
            {"part": "disc", "rigid": {"translation": [0, null]}}, {"on": "lid/top", "fix": ["x", "y"]})",
                                 "");
    const Settling settling = settling_of(scene);
    ASSERT_EQ(settling.end, Settling::End::rests) << settling.why;
    EXPECT_LT((way(scene, settling, 1) - Vec2(0, gap)).norm(), 16 * of_size);
    // the disc's middle is 13 off the bar's line: y cos(angle) - x sin(angle) = 13
    const double angle = std::atan2(y, x) - std::asin(13 / std::hypot(x, y));
    EXPECT_NEAR(settling.placements.at(0).angle, angle, of_size);
}

TEST(Settle, IsNotAskedWhereSomethingElseHolds) {
    const std::string two = hole_and_pin(6, {0, 0}), held = R"({"on": "plate/p/bottom", "fix": ["x", "y"]})",
                      load = R"({"part": "pin", "force": [0, -1]})";
    EXPECT_EQ(settling_of(scene_of(two, held, load, R"(, "contacts": {"friction": 0.1})")).end, Settling::End::not_asked);
    EXPECT_EQ(settling_of(scene_of(two, held, load, R"(, "motion": "off")")).end, Settling::End::not_asked);
    EXPECT_EQ(settling_of(scene_of(two, held, load, R"(, "motion": "auto")")).end, Settling::End::rests);
}

}  // namespace
}  // namespace abut::settle_test
