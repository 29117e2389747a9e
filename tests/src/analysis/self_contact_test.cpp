// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of parts with themselves: the same as that of two parts which are bonded where the one is whole; slots that stay
// open change nothing.
#include "src/analysis/self_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>
#include <string>

#include "src/analysis/analysis.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::self_contact_test {
namespace {

constexpr double E = 2e5, gap = 0.4, radius = 1;  // of the bumps at the arms' tips, which face each other

std::string number(double v) {
    std::string text(32, ' ');
    text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.12g", v)));
    return text;
}

std::string rectangle(double x0, double y0, double x1, double y1, const std::string& name) {
    return R"({"rectangle": {"min": [)" + number(std::min(x0, x1)) + ", " + number(y0) + R"(], "max": [)" +
           number(std::max(x0, x1)) + ", " + number(y1) + R"(]}, "name": ")" + name + "\"}";
}

/// Half a clip: an arm with a round bump at its tip on a base; side: 1 on the right, -1 on the left.
std::string half(int side, const std::string& name) {
    const double inner = side * 0.5 * (gap + radius), outer = inner + side;
    return R"({"name": ")" + name + R"(", "union": [)" + rectangle(inner, 0, outer, 22, "arm") +
           R"(, {"circle": {"center": [)" + number(side * (0.5 * gap + radius)) + R"(, 20], "radius": )" + number(radius) +
           R"(}, "name": "bump"}, )" + rectangle(0, -4, outer, 0, "base") + "]}";
}

struct Posed {
    double pressure;  ///< on the outer sides of both arms
    double turn = 0;  ///< of everything, degrees
    bool in_halves = false;
    std::string contacts{};
};

Result clip(const Posed& p) {
    const std::string place = R"(, "material": "m", "place": {"rotate": )" + number(p.turn) + "}}";
    const std::string parts =
        p.in_halves
            ? R"({"name": "L", "geometry": )" + half(-1, "l") + place + R"(, {"name": "R", "geometry": )" + half(1, "r") + place
            : R"({"name": "clip", "geometry": {"union": [)" + half(-1, "l") + ", " + half(1, "r") + "]}" + place;
    const std::string pressure = R"(, "pressure": )" + number(p.pressure) + "}";
    const std::string contacts =
        p.in_halves ? R"(, "contacts": {"pairs": [{"between": ["L/l/base/right", "R/r/base/left"], "kind": "bonded"}]})"
                    : p.contacts;
    return analyze(read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 2e5, "nu": 0.3}}, "parts": [)" + parts +
                                       R"(], "supports": [{"on": ["*/base/bottom"], "fix": ["x", "y"]}],
            "loads": [{"on": "*/l/arm/left")" +
                                       pressure + R"(, {"on": "*/r/arm/right")" + pressure + "]" + contacts + "}",
                                   "clip.json"),
                   {});
}

/// The contact of the bumps.
const ContactResult& pressed(const Result& r) {
    for (const ContactResult& c : r.contacts)
        if (c.kind == "contact" && c.status != "open") return c;
    throw std::runtime_error("nothing is pressed");
}

}  // namespace

TEST(SelfContact, AClipThatClosesIsTwoPartsThatPress) {
    const Result whole = clip({1}), halves = clip({1, 0, true});
    ASSERT_EQ(whole.status, "ok") << whole.message;
    ASSERT_EQ(halves.status, "ok") << halves.message;
    const ContactResult &own = pressed(whole), &other = pressed(halves);
    EXPECT_EQ(own.parts, (std::array<std::string, 2>{"clip", "clip"}));
    EXPECT_NE(own.between[0], own.between[1]);
    const double force = own.force.norm();
    EXPECT_NEAR(force, other.force.norm(), 0.01 * force);
    EXPECT_NEAR(own.max_pressure.value, other.max_pressure.value, 0.01 * own.max_pressure.value);
    const double hertz = std::sqrt(force * (E / 2) / (std::numbers::pi * radius / 2));
    EXPECT_NEAR(own.max_pressure.value, hertz, 0.01 * hertz);
    EXPECT_NEAR(std::abs(own.force.x()), force, 1e-3 * force);  // straight across
}

TEST(SelfContact, LiesAsThePartLies) {
    const ContactResult drawn = pressed(clip({1})), turned = pressed(clip({1, 17}));
    EXPECT_NEAR(turned.force.norm(), drawn.force.norm(), 0.01 * drawn.force.norm());
    EXPECT_NEAR(turned.max_pressure.value, drawn.max_pressure.value, 0.01 * drawn.max_pressure.value);
}

/// Without contact with itself the clip would let the roller through, farther than that is large: it is found all the same.
TEST(SelfContact, HoldsWhatWouldBeLostWithout) {
    const Result r = analyze(read_scene_text(R"({"abut": 1, "analysis": "plane_stress", "thickness": 10, "materials": {
        "pom": {"E": 2800, "nu": 0.37}, "steel": {"E": 210000, "nu": 0.3}}, "parts": [
        {"name": "clip", "material": "pom", "geometry": {"difference": [{"rectangle": {"min": [0, 0], "max": [50, 10]}, "name": "o"},
            {"rectangle": {"min": [15, 4.9], "max": [60, 5.1]}}]}},
        {"name": "load", "material": "steel", "geometry": {"circle": {"center": [45, 15], "radius": 5}}}],
        "supports": [{"on": "clip/o/bottom", "fix": ["x", "y"]}, {"part": "load", "rigid": {"translation": [0, null], "rotation": 0}}],
        "loads": [{"part": "load", "force": [0, -600]}], "accuracy": {"level": "draft"}})",
                                             "."),
                             {});
    ASSERT_EQ(r.status, "ok") << r.message;
    ASSERT_EQ(r.contacts.size(), 2u);
    EXPECT_GT(std::abs(r.contacts[1].force.y()), 500);
    EXPECT_LT(r.parts[1].max_displacement.value, 0.5);
}

TEST(SelfContact, WhatStaysOpenIsNotLookedAt) {
    const Result open = clip({0.1});
    ASSERT_EQ(open.status, "ok") << open.message;
    EXPECT_TRUE(open.contacts.empty());
    EXPECT_TRUE(clip({1, 0, false, R"(, "contacts": {"detect": false})"}).contacts.empty());
}

TEST(SelfContact, ARuleForTheFacesCounts) {
    const Result ignored =
        clip({1, 0, false, R"(, "contacts": {"pairs": [{"between": ["clip/*", "clip/*"], "kind": "ignore"}]})"});
    for (const ContactResult& c : ignored.contacts) EXPECT_EQ(c.status, "open");
    const Result rough = clip({1, 0, false, R"(, "contacts": {"friction": 0.3})"});
    ASSERT_EQ(rough.status, "ok") << rough.message;
    EXPECT_NEAR(pressed(rough).friction->coefficient, 0.3, 0);
}

}  // namespace abut::self_contact_test
