// SPDX-License-Identifier: GPL-3.0-or-later
// What turns as parts move by less than they are followed for, against statics where they come to rest.
#include "src/analysis/turned_contacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/verification/scene_answers.hpp"

namespace abut::turned_contacts_test {
namespace {

std::string circle(const std::string& name, double x, double y) {
    return R"({"name": ")" + name + R"(", "material": "m", "geometry": {"circle": {"center": )" + test::pair_text(x, y) +
           R"(, "radius": 10}}})";
}

bool has_reason(const Result& r, const std::string& kind) {
    return std::any_of(r.reasons.begin(), r.reasons.end(), [&](const Reason& reason) { return reason.kind == kind; });
}

/// A disc on two others, between walls that are so far from these.
Result three_discs(double gap, const std::string& motion = "auto") {
    const double apart = 11, height = 10 + std::sqrt(400 - apart * apart), wall = apart + 10 + gap;
    const auto number = [](double v) { return std::to_string(v); };
    const std::string inner = number(wall), outer = number(wall + 15);
    return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "box", "material": "m", "geometry": {"difference": [
            {"rectangle": {"min": [-)" +
                        outer + R"(, -15], "max": [)" + outer + R"(, 60]}},
            {"rectangle": {"min": [-)" +
                        inner + R"(, 0], "max": [)" + inner + R"(, 61]}}]}}, )" + circle("l", -apart, 10) + ", " +
                        circle("r", apart, 10) + ", " + circle("t", 0, height) + R"(],
        "supports": [{"on": {"part": "box", "facing": [0, -1]}, "fix": ["x", "y"]}], "loads": [{"part": "t", "force": [0, -500]}], "motion": ")" +
                        motion + "\"}");
}

/// A strut of length 50, up by 10 degrees, on a pin, with its round end so far from a wall, pressed down there.
Result strut(double gap, const std::string& motion = "auto") {
    const double angle = std::numbers::pi / 18, x = 50 * std::cos(angle), y = 50 * std::sin(angle);
    const auto number = [](double v) { return std::to_string(v); };
    const std::string wall = number(x + 6 + gap), behind = number(x + 26 + gap);
    return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "strut", "material": "m", "geometry": {"difference": [{"union": [{"circle": {"center": [0, 0], "radius": 9}},
            {"slot": {"from": [0, 0], "to": )" +
                        test::pair_text(x, y) + R"(, "radius": 6}}]},
            {"circle": {"center": [0, 0], "radius": 5}}]}}, )" +
                        "{" + R"("name": "pin", "material": "m",
            "geometry": {"circle": {"center": [0, 0], "radius": 4.999}}},
        {"name": "wall", "material": "m", "geometry": {"rectangle": {"min": [)" +
                        wall + R"(, -20], "max": [)" + behind + R"(, 40]}}}],
        "supports": [{"part": "pin", "rigid": {"translation": [0, 0], "rotation": 0}}, {"on": "wall/right", "fix": ["x", "y"]}],
        "loads": [{"on": {"part": "strut", "near": )" +
                        test::pair_text(x + 6, y) + R"(}, "force": [0, -5], "at": )" + test::pair_text(x, y) +
                        R"(}], "motion": ")" + motion + "\"}");
}

/// A disc between two plates, turned by this share of what friction holds.
Result clamped_disc(double share) {
    return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "lo", "material": "m", "geometry": {"rectangle": {"min": [-40, -20], "max": [40, 0]}}}, )" +
                        circle("d", 0, 10) + R"(,
        {"name": "up", "material": "m", "geometry": {"rectangle": {"min": [-40, 20], "max": [40, 40]}}}],
        "supports": [{"on": "lo/bottom", "fix": ["x", "y"]}, {"on": "up/left", "roller": true}, {"on": "up/right", "roller": true}],
        "loads": [{"on": "up/top", "force": [0, -2000]}, {"part": "d", "moment": )" +
                        std::to_string(share * 2 * 0.15 * 2000 * 10) + R"(}], "contacts": {"friction": 0.15}})");
}

/// A disc in a right-angled groove, under its weight and a moment.
Result disc_in_groove(double moment) {
    return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [{"name": "vee", "material": "m",
        "geometry": {"polygon": [[-30, -40], [30, -40], [30, 15.857864376269049], [0, -14.142135623730951], [-30, 15.857864376269049]]}}, )" +
                        circle("d", 0, 0) + R"(], "supports": [{"on": "vee/e0", "fix": ["x", "y"]}],
        "loads": [{"part": "d", "force": [0, -1000]}, {"part": "d", "moment": )" +
                        std::to_string(moment) + R"(}], "contacts": {"friction": 0.2}, "accuracy": {"level": "draft"}})");
}

/// A disc on a plate under 1000, pushed along the plate by 800 and turned by a moment; all of it turned by an angle.
Result pushed_disc(double moment, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const auto pair = [&](double x, double y) {
        return "[" + std::to_string(c * x - s * y) + ", " + std::to_string(s * x + c * y) + "]";
    };
    return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [{"name": "base", "material": "m",
        "geometry": {"polygon": [)" +
                        pair(-60, -30) + ", " + pair(60, -30) + ", " + pair(60, 0) + ", " + pair(-60, 0) +
                        R"(]}}, {"name": "disc", "material": "m", "geometry": {"circle": {"center": )" + pair(0, 10) +
                        R"(, "radius": 10}}}], "supports": [{"on": "base/e0", "fix": ["x", "y"]}],
        "loads": [{"part": "disc", "force": )" +
                        pair(800, -1000) + R"(}, {"part": "disc", "moment": )" + std::to_string(moment) +
                        R"(}], "contacts": {"friction": 2}, "accuracy": {"level": "draft"}})");
}

/// Of parts that move, and of the same drawn where they come to rest.
void expect_told_where_parts_move(const Result& moved, const Result& at_rest) {
    ASSERT_EQ(moved.status, "ok") << moved.message;
    EXPECT_TRUE(has_reason(moved, "turned_force"));
    ASSERT_EQ(at_rest.status, "ok") << at_rest.message;
    EXPECT_FALSE(has_reason(at_rest, "turned_force"));
}

}  // namespace

/// The walls' forces at rest are 11 % above those of the places as drawn.
TEST(TurnedContacts, DiscsThatMoveApartAreTold) {
    expect_told_where_parts_move(three_discs(0.9, "off"), three_discs(0));
}

TEST(TurnedContacts, DiscsThatMoveApartAreFollowed) {
    const Result r = three_discs(0.9);
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_FALSE(has_reason(r, "turned_force"));
    double sideways = 0;
    for (const ContactResult& c : r.contacts)
        if (c.parts[0] == "box") sideways += 0.5 * std::abs(c.force.x());
    EXPECT_NEAR(sideways / (250 * std::tan(std::asin(11.9 / 20))), 1, 2e-3);
}

/// A strut's forces go as the cotangent of its angle, which pins that move in their holes change.
TEST(TurnedContacts, StrutsThatTurnAreTold) {
    expect_told_where_parts_move(strut(0.05, "off"), strut(0));
    const Result followed = strut(0.05);
    ASSERT_EQ(followed.status, "ok") << followed.message;
    EXPECT_FALSE(has_reason(followed, "turned_force"));
}

/// Pressure on a disc goes through its centre: friction alone bears the moment.
TEST(TurnedContacts, MomentsBeyondFrictionAreTold) {
    const Result beyond = clamped_disc(1.05), below = clamped_disc(0.5);
    EXPECT_TRUE(beyond.status != "ok" || has_reason(beyond, "turned_lever")) << beyond.message;
    ASSERT_EQ(below.status, "ok") << below.message;
    EXPECT_TRUE(below.reasons.empty());
}

/// Where one contact sticks and the other slips, small displacements have the one that sticks bear what it cannot.
TEST(TurnedContacts, FrictionThatWouldHaveToBearMoreIsTold) {
    const double limit = 0.2 * std::sqrt(2.0) / (1 + 0.2 * 0.2) * 1000 * 10;  // by statics
    const Result beyond = disc_in_groove(1.05 * limit), below = disc_in_groove(0.95 * limit);
    EXPECT_TRUE(beyond.status != "ok" || has_reason(beyond, "turned_lever")) << beyond.message;
    ASSERT_EQ(below.status, "ok") << below.message;
    EXPECT_FALSE(has_reason(below, "turned_lever"));
}

/// A wheel pulled against a sharp step: the two faces of its corner share a force that statics knows.
TEST(TurnedContacts, TheFacesOfACornerBearOneForce) {
    const double up = 6, radius = 20, aside = std::sqrt(radius * radius - (radius - up) * (radius - up));
    for (const double friction : {0.0, 0.3}) {
        const Result r = test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
            {"name": "ground", "material": "m", "geometry": {"polygon": [[-60, -30], [60, -30], [60, 6], )" +
                                      test::pair_text(aside, up) + ", " + test::pair_text(aside, 0) + R"(, [-60, 0]]}},
            {"name": "wheel", "material": "m", "geometry": {"circle": {"center": [0, 20], "radius": 20}}}],
            "supports": [{"on": "ground/e0", "fix": ["x", "y"]}], "loads": [{"part": "wheel", "force": [400, -1000]}],
            "contacts": {"friction": )" +
                                      std::to_string(friction) + "}}");
        ASSERT_EQ(r.status, "ok") << r.message;
        for (const char* kind : {"turned_force", "turned_lever", "turned_balance"})
            EXPECT_FALSE(has_reason(r, kind)) << kind << " " << friction;
        geometry::Vec2 at_corner(0, 0);
        for (const ContactResult& c : r.contacts)
            if (std::abs(c.max_pressure.at.x()) > 0.5 * aside) at_corner += c.force;
        if (friction == 0) { EXPECT_NEAR(at_corner.x(), 400, 0.4); }
    }
}

/// Pressure all round cancels but for rounding, which drives nothing, whatever acts on other parts.
TEST(TurnedContacts, PressureAllRoundDrivesNothing) {
    const auto ring = [](const std::string& name, double x, double outer, double inner) {
        const auto disc = [&](double radius) {
            return R"({"circle": {"center": )" + test::pair_text(x, 0) + R"(, "radius": )" + test::number(radius) + "}}";
        };
        return R"({"name": ")" + name + R"(", "material": "m", "geometry": {"difference": [)" + disc(outer) + ", " +
               disc(inner) + "]}}";
    };
    const Result r =
        test::answer(R"({"abut": 1, "analysis": "plane_strain", "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [)" +
                     ring("r0", 0, 20, 10) + ", " + ring("s0", 0, 10, 4) + ", " + ring("r1", 100, 20, 10) + ", " +
                     ring("s1", 100, 10, 4) + R"(], "supports": [
        {"part": "s0", "rigid": {"translation": [0, 0], "rotation": 0}}, {"part": "s1", "rigid": {"translation": [0, 0], "rotation": 0}}],
        "loads": [{"on": {"part": "r0", "near": [20, 0]}, "pressure": 20}, {"part": "r1", "force": [0, 1000]}]})");
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_FALSE(has_reason(r, "turned_balance")) << r.reasons.front().text;
}

/// A disc that rolls is balanced by small displacements alone, whose contact moves along while the loads stay.
TEST(TurnedContacts, DiscsThatRollAreTold) {
    for (const double angle : {0.0, 0.3})
        for (const double off : {-300.0, 60.0, 300.0}) {
            const Result rolls = pushed_disc(8000 + off, angle);
            EXPECT_TRUE(rolls.status != "ok" || has_reason(rolls, "turned_balance")) << angle << " " << off;
        }
    const Result rests = pushed_disc(8000, 0.3);
    ASSERT_EQ(rests.status, "ok") << rests.message;
    EXPECT_FALSE(has_reason(rests, "turned_balance"));
}

/// In a hollow it rolls until its weight holds it, and that is so.
TEST(TurnedContacts, DiscsInHollowsRest) {
    const Result r = test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "base", "material": "m", "geometry": {"difference": [{"rectangle": {"min": [-15, -15], "max": [15, 5]}},
            {"circle": {"center": [0, 10.5], "radius": 10.5}}]}}, )" +
                                  circle("disc", 0, 10) + R"(],
        "supports": [{"on": "base/bottom", "fix": ["x", "y"]}],
        "loads": [{"part": "disc", "force": [0, -1000]}, {"part": "disc", "force": [5, 0]}], "contacts": {"friction": 0.3}})");
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_FALSE(has_reason(r, "turned_balance"));
}

/// In a groove whose bottom is cut free one contact presses on both flanks: each has a force of its own.
TEST(TurnedContacts, StretchesOfOneContactHaveTheirOwnForces) {
    const Result r = test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "thickness": 10, "parts": [
        {"name": "b", "material": "m", "geometry": {"difference": [{"rectangle": {"min": [-40, -30], "max": [40, 0]}},
            {"union": [{"circle": {"center": [0, -2], "radius": 7}}, {"polygon": [[-4.949747468305833, -6.949747468305833],
              [4.949747468305833, -6.949747468305833], [16.899494936611667, 5], [-16.899494936611667, 5]]}]}]}},
        {"name": "pin", "material": "m", "geometry": {"circle": {"center": [0, -0.5857864376269051], "radius": 8}}}],
        "supports": [{"on": "b/bottom", "fix": ["x", "y"]}], "loads": [{"part": "pin", "force": [0, -5000]}],
        "contacts": {"friction": 0.1}, "accuracy": {"level": "draft"}})");
    ASSERT_EQ(r.status, "ok") << r.message;
    ASSERT_NEAR(r.contacts.at(0).force.y(), -5000, 1e-6);
    EXPECT_FALSE(has_reason(r, "turned_lever"));
    EXPECT_FALSE(has_reason(r, "turned_balance"));
}

/// A drum on its axle, braked by a shoe: normals pass through its middle, so that it holds mu N R, and no more.
Result braked(double share) {
    constexpr double friction = 0.3, force = 500, radius = 50;
    return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "thickness": 10, "parts": [
        {"name": "drum", "material": "m", "geometry": {"circle": {"center": [0, 0], "radius": 50}}},
        {"name": "shoe", "material": "m", "geometry": {"rectangle": {"min": [-20, -70], "max": [20, -50]}}}],
        "supports": [{"part": "drum", "rigid": {"translation": [0, 0]}}, {"part": "shoe", "rigid": {"translation": [0, null], "rotation": 0}}],
        "loads": [{"part": "shoe", "force": [0, 500]}, {"part": "drum", "moment": )" +
                        std::to_string(share * friction * force * radius) + R"(}], "contacts": {"friction": 0.3}})");
}

TEST(TurnedContacts, ADrumIsBrakedByNoMoreThanFrictionBears) {
    const Result held = braked(0.9);
    ASSERT_EQ(held.status, "ok") << held.message;
    EXPECT_FALSE(has_reason(held, "turned_lever") || has_reason(held, "turned_balance"));
    for (const double share : {1.02, 1.1}) {
        const Result slips = braked(share);
        EXPECT_TRUE(slips.status != "ok" || has_reason(slips, "turned_lever") || has_reason(slips, "turned_balance")) << share;
    }
}

/// Where discs stay as they are drawn, what their motion to the walls does to each force is in its error.
TEST(TurnedContacts, ForcesErrByWhatMotionsChange) {
    const Result drawn = three_discs(0.5, "off"), followed = three_discs(0.5);
    ASSERT_EQ(drawn.status, "ok") << drawn.message;
    ASSERT_EQ(followed.status, "ok") << followed.message;
    const auto wall_of = [](const Result& r) {
        return *std::find_if(r.contacts.begin(), r.contacts.end(), [](const ContactResult& c) {
            return c.parts[0] == "box" && std::abs(c.force.x()) > std::abs(c.force.y());
        });
    };
    const ContactResult wall = wall_of(drawn);
    const double off = std::abs(wall.force.norm() / wall_of(followed).force.norm() - 1);
    EXPECT_GT(off, 0.03);
    ASSERT_TRUE(wall.errors);
    EXPECT_NEAR(wall.errors->force, off, 0.3 * off);
    EXPECT_GE(wall.errors->pressure, wall.errors->force);
}

/// Pressed into a groove a ball slips down both sides: nothing says whether it turns. Where friction holds it, it does not.
TEST(MotionsAtLimit, ABallInAGrooveMayTurn) {
    const auto in_groove = [](double friction) {
        return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
            {"name": "block", "material": "m", "geometry": {"difference": [{"rectangle": {"min": [-30, -30], "max": [30, 0]}},
                {"polygon": [[0, -14.142135623730951], [20, 5.857864376269049], [-20, 5.857864376269049]]}]}}, )" +
                            circle("ball", 0, 0) +
                            R"(], "supports": [{"on": {"part": "block", "facing": [0, -1]}, "fix": ["x", "y"]}],
            "loads": [{"part": "ball", "force": [0, -500]}], "contacts": {"friction": )" +
                            std::to_string(friction) + "}}");
    };
    const auto says = [](const Result& r) {
        return std::any_of(r.warnings.begin(), r.warnings.end(), [](const std::string& w) {
            return w.find("friction bears all it can wherever") != std::string::npos &&
                   w.find("ball rotates") != std::string::npos;
        });
    };
    const Result slips = in_groove(0.05), sticks = in_groove(0.9);
    ASSERT_EQ(slips.status, "ok") << slips.message;
    ASSERT_EQ(sticks.status, "ok") << sticks.message;
    EXPECT_TRUE(says(slips));
    EXPECT_FALSE(says(sticks));
}

/// Of dead loads: a plate on a cylinder that is held rolls back while it is loaded below the cylinder's middle.
TEST(UnstableBalance, IsSaidWhereFrictionLetsPartsRoll) {
    const auto plate_on = [](const std::string& below, double thickness, bool is_held) {
        const std::string supports =
            R"({"on": "bed/bottom", "fix": ["x", "y"]})" +
            std::string(is_held ? R"(, {"part": "r", "rigid": {"translation": [0, 0], "rotation": 0}})" : "");
        return test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
            {"name": "bed", "material": "m", "geometry": {"rectangle": {"min": [-60, -30], "max": [60, 0]}}},
            {"name": "plate", "material": "m", "geometry": {"rectangle": {"min": [-40, 20], "max": [40, )" +
                            std::to_string(20 + thickness) + "]}}}, " + below + R"(], "supports": [)" + supports + R"(],
            "loads": [{"on": "plate/top", "force": [0, -100]}], "contacts": {"friction": 0.3}})");
    };
    const auto says = [](const Result& r) {
        EXPECT_EQ(r.status, "ok") << r.message;
        return std::any_of(r.warnings.begin(), r.warnings.end(), [](const std::string& w) {
            return w.find("the balance is unstable: once pushed, plate rotates") != std::string::npos;
        });
    };
    const std::string one = circle("r", 0, 10), two = circle("r", -20, 10) + ", " + circle("s", 20, 10);
    EXPECT_FALSE(says(plate_on(one, 8, true)));
    EXPECT_TRUE(says(plate_on(one, 12, true)));
    EXPECT_TRUE(says(plate_on(one, 8, false))) << "the cylinder rolls away below the plate";
    EXPECT_FALSE(says(plate_on(two, 12, false)));
}

/// A block in the corner of a frame rests on two faces: it is held by each along its length.
TEST(UnstableBalance, ABlockInACornerRests) {
    const Result r = test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "frame", "material": "m", "geometry": {"polygon": [[-80, -60], [60, -60], [60, 60], [40, 60], [40, -40], [-80, -40]]}},
        {"name": "b", "material": "m", "geometry": {"rectangle": {"min": [10, -40], "max": [40, 20]}}}],
        "supports": [{"on": "frame/e0", "fix": ["x", "y"]}], "loads": [{"on": "b/top", "force": [0, -10000]}],
        "contacts": {"friction": 0.1}})");
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_FALSE(has_reason(r, "turned_balance"));
}

/// A cam that a support turns by half a degree under a flat follower, less than its pairs are good for: its lever goes by a
/// third of itself. Of an ellipse the touching point of a level tangent is known.
TEST(TurnedContacts, ThePlaceOfAForceOnAPartThatASupportTurnsIsThatWhereItEnds) {
    constexpr double a = 20, b = 12, drawn = 87, force = 2000;
    const auto at = [&](double degrees) {  // of the highest point: x and y
        const double w = degrees * std::numbers::pi / 180, y = std::hypot(a * std::sin(w), b * std::cos(w));
        return Vec2((a * a - b * b) * std::sin(w) * std::cos(w) / y, y);
    };
    const double top = at(drawn).y();
    const Result r = test::answer(R"({"abut": 1, "analysis": "plane_stress", "thickness": 10,
        "materials": {"steel": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "cam", "material": "steel", "geometry": {"ellipse": {"center": [0, 0], "radii": [20, 12], "angle": 87}}},
        {"name": "follower", "material": "steel", "geometry": {"rectangle": {"min": )" +
                                  test::pair_text(-25, top) + R"(, "max": )" + test::pair_text(25, top + 10) + R"(}}}],
        "supports": [{"part": "cam", "rigid": {"translation": [0, 0], "rotation": 0.5}},
            {"part": "follower", "rigid": {"translation": [0, null], "rotation": 0}}],
        "loads": [{"part": "follower", "force": [0, -2000]}]})");
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_TRUE(r.accuracy.reached);
    EXPECT_NEAR(r.reactions.at(0).moment, force * at(drawn + 0.5).x(), 0.005 * force * at(drawn).x());
}

/// Nothing moves as a rigid body, and there is friction.
TEST(TurnedContacts, PartsThatSupportsHoldHaveNoBalanceToLose) {
    const Result r = test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "a", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [60, 10]}}},
        {"name": "b", "material": "m", "geometry": {"rectangle": {"min": [0, 10], "max": [60, 20]}}}],
        "supports": [{"on": ["a/left", "b/left"], "fix": ["x", "y"]}], "loads": [{"on": "b/top", "pressure": 1}],
        "contacts": {"friction": 0.2}, "accuracy": {"level": "draft"}})");
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_GT(r.contacts.at(0).max_pressure.value, 0.4);
}

/// A bar that a support leads by 0.4 over a knob, by less than pairs are good for: the knob's lever to its middle is 1 less
/// 0.4.
TEST(TurnedContacts, AndOnAPartThatOneLeadsAlong) {
    const Result r = test::answer(R"({"abut": 1, "analysis": "plane_stress", "thickness": 10,
        "materials": {"steel": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "knob", "material": "steel", "geometry": {"circle": {"center": [1, -10], "radius": 10}}},
        {"name": "bar", "material": "steel", "geometry": {"rectangle": {"min": [-60, 0], "max": [60, 10]}}}],
        "supports": [{"part": "knob", "rigid": {"translation": [0, 0], "rotation": 0}},
            {"part": "bar", "rigid": {"translation": [0.4, null], "rotation": 0}}],
        "loads": [{"part": "bar", "force": [0, -1000]}]})");
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_TRUE(r.accuracy.reached);
    // the reaction's moment is about the origin, and the load goes along
    ASSERT_TRUE(r.parts.at(1).placement);
    EXPECT_NEAR(r.parts.at(1).placement->translation.x(), 0.4, 1e-6);
    EXPECT_NEAR(r.reactions.at(1).moment, -600, 5);
}

/// A disc on a cantilever that loads push to a wall, drawn so far from it: what bends the beam is the disc's weight where it
/// comes to rest.
TEST(TurnedContacts, LeversThatLoadsMoveAreThoseWhereTheyEnd) {
    const auto pushed = [](double gap, const std::string& more) {
        return test::answer(R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 200000, "nu": 0.3}}, "parts": [
            {"name": "beam", "material": "m", "geometry": {"rectangle": {"min": [0, -6], "max": [35, 0]}}}, )" +
                            circle("d", 13 - gap, 10) + R"(,
            {"name": "wall", "material": "m", "geometry": {"rectangle": {"min": [23, 1], "max": [38, 25]}}}],
            "supports": [{"on": "beam/left", "fix": ["x", "y"]}, {"on": "wall/right", "fix": ["x", "y"]},
                {"part": "d", "rigid": {"translation": null, "rotation": 0}}],
            "loads": [{"part": "d", "force": [200, -2000]}])" +
                            more + "}");
    };
    const Result at_rest = pushed(0, "");
    for (const double gap : {0.2, 0.5, 1.0}) {
        SCOPED_TRACE(gap);
        const Result r = pushed(gap, "");
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_NEAR(r.reactions.at(0).moment, at_rest.reactions.at(0).moment, 1e-3 * at_rest.reactions[0].moment);
        EXPECT_FALSE(has_reason(r, "turned_lever"));
    }
    EXPECT_TRUE(has_reason(pushed(1, R"(, "motion": "off")"), "turned_lever"));
}

/// A block that slides to a stop takes its weight along: nothing turns it, and what it slides on is answered where it rests.
TEST(TurnedContacts, ASliderIsNotTurnedByItsOwnWeight) {
    const auto slider = [](double gap, const std::string& motion) {
        return test::answer(R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 2e5, "nu": 0.3}}, "parts": [
            {"name": "table", "material": "m", "geometry": {"rectangle": {"min": [-40, -10], "max": [60, 0]}}},
            {"name": "block", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [16, 20]}}},
            {"name": "stop", "material": "m", "geometry": {"circle": {"center": [)" +
                            test::number(26 + gap) + R"(, 10], "radius": 10}}}],
            "supports": [{"on": "table/bottom", "fix": ["x", "y"]}, {"part": "stop", "rigid": {"translation": [0, 0], "rotation": 0}},
                {"part": "block", "rigid": {"translation": null, "rotation": 0}}],
            "loads": [{"part": "block", "force": [300, -500]}], "motion": ")" +
                            motion + "\"}");
    };
    const Result r = slider(1, "off");
    ASSERT_EQ(r.status, "ok") << r.message;
    for (const Reason& reason : r.reasons) EXPECT_EQ(reason.text.find("on block move"), std::string::npos) << reason.text;
    const Result at_rest = slider(0, "auto"), followed = slider(1, "auto");
    EXPECT_NEAR(followed.reactions.at(0).moment - at_rest.reactions.at(0).moment, 500, 5);
}

/// Supports that take all parts along change no lever.
TEST(TurnedContacts, WhatMovesTogetherTurnsNothing) {
    const auto carried = [](const std::string& x, const std::string& y) {
        const std::string held = R"("rigid": {"translation": [)" + x + ", " + y + R"(], "rotation": 0}})",
                          guided = R"("rigid": {"translation": [)" + x + R"(, null])";
        return test::answer(R"({"abut": 1, "thickness": 25, "materials": {"m": {"E": 200000, "nu": 0.3}}, "parts": [
            {"name": "beam", "material": "m", "geometry": {"rectangle": {"min": [-15, 20], "max": [65, 25]}}}, )" +
                            circle("left", 0, 10) + ", " + circle("right", 50, 10) + ", " + circle("top", 20, 35) +
                            R"(], "supports": [{"part": "left", )" + held + R"(, {"part": "right", )" + held +
                            R"(, {"part": "top", )" + guided + R"(, "rotation": 0}}, {"part": "beam", )" + guided +
                            R"(}}], "loads": [{"part": "top", "force": [0, -300]}]})");
    };
    EXPECT_FALSE(has_reason(carried("0", "0"), "turned_lever"));
    EXPECT_FALSE(has_reason(carried("0.01", "-0.02"), "turned_lever"));
}

}  // namespace abut::turned_contacts_test
