// SPDX-License-Identifier: GPL-3.0-or-later
// Bonded edges: two parts that hold together as one, in tension and in shear.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/brep/input_error.hpp"
#include "src/analysis/analysis.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::bonded_test {
namespace {

std::string block(const std::string& name, const std::string& min, const std::string& max) {
    return R"({"name": ")" + name + R"(", "material": "m", "geometry": {"rectangle": {"min": )" + min + R"(, "max": )" + max +
           "}}}";
}

Result analyzed(const std::string& parts, const std::string& rest) {
    return analyze(
        read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}}, "parts": [)" + parts + "], " + rest + "}",
                        "scene.json"),
        {});
}

/// Two halves of a bar, bonded in the middle, on grids that do not match.
const std::string halves = block("a", "[0, 0]", "[2, 1]") + "," + block("b", "[2, 0]", "[4, 1]");
const std::string bonded = R"("contacts": {"pairs": [{"between": ["a/right", "b/left"], "kind": "bonded"}]})";
const std::string grids =
    R"("accuracy": {"grids": {"a": {"cells": [8, 5]}, "b": {"cells": [7, 4], "offset": [0.05, 0.03], "angle": 12}}})";

}  // namespace

TEST(Bonded, CarriesTensionExactly) {
    const Result r = analyzed(halves, bonded + "," + grids + R"(, "supports": [{"on": "a/left", "symmetry": true},
        {"part": "a", "rigid": {"translation": [null, 0], "rotation": null}}],
        "loads": [{"on": "b/right", "traction": [10, 0]}], "output": {"probes": [{"part": "b", "at": [4, 0.5]}]})");
    ASSERT_EQ(r.status, "ok") << r.message;
    ASSERT_EQ(r.contacts.size(), 1U);
    const ContactResult& c = r.contacts[0];
    EXPECT_EQ(c.kind, "bonded");
    EXPECT_EQ(c.status, "closed");
    EXPECT_LT((c.force - Vec2(10, 0)).norm(), 1e-7);  // b pulls a to the right
    for (const double p : c.profile.pressure) EXPECT_NEAR(p, -10, 1e-6);
    ASSERT_EQ(c.profile.shear.size(), c.profile.pressure.size());
    for (const double t : c.profile.shear) EXPECT_NEAR(t, 0, 1e-6);
    EXPECT_NEAR(r.probes[0].displacement.x(), 10.0 * 4 / 1000, 1e-9);
    EXPECT_LT(r.equilibrium.relative_residual, 1e-9);
    ASSERT_EQ(r.warnings.size(), 1U);  // a contact would open there
    EXPECT_EQ(r.warnings[0].find("bonded pair in tension: a/right and b/left are pulled apart with up to 10 at (2, "), 0U)
        << r.warnings[0];
}

TEST(Bonded, BendsAsOnePiece) {
    const std::string held = R"("supports": [{"on": "a/left", "fix": ["x", "y"]}], "loads": [{"on": ")";
    const Result whole =
        analyzed(block("a", "[0, 0]", "[4, 1]"),
                 held + R"(a/right", "traction": [0, -1]}], "output": {"probes": [{"part": "a", "at": [4, 0.5]}]})");
    const Result two =
        analyzed(halves, bonded + "," + grids + "," + held +
                             R"(b/right", "traction": [0, -1]}], "output": {"probes": [{"part": "b", "at": [4, 0.5]}]})");
    ASSERT_EQ(two.status, "ok") << two.message;
    const double expected = whole.probes[0].displacement.y();
    EXPECT_NEAR(two.probes[0].displacement.y(), expected, 0.005 * std::abs(expected));
    EXPECT_LT((two.contacts[0].force - Vec2(0, -1)).norm(), 1e-6);
    EXPECT_NEAR(two.contacts[0].moment, -4, 1e-5);  // of the load, about the origin
    ASSERT_TRUE(two.under_load);
    EXPECT_EQ(two.under_load->degrees_of_freedom, 0);
    EXPECT_EQ(two.under_load->redundant, 0);
}

/// Where it stands the largest stress has no limit, drawn straight or turned: the parts make a re-entrant corner of one body.
TEST(Bonded, EndsInACornerWhereTheOutlinesMeetInOne) {
    for (const int angle : {0, 17}) {
        const auto turned = [&](const std::string& name, const std::string& min, const std::string& max) {
            return R"({"name": ")" + name + R"(", "material": "m", "geometry": {"place": {"rotate": )" + std::to_string(angle) +
                   R"(, "of": {"rectangle": {"min": )" + min + R"(, "max": )" + max + "}}}}}";
        };
        const Result r = analyzed(turned("foot", "[-4, -1]", "[4, 0]") + "," + turned("lug", "[-1, 0]", "[1, 4]"),
                                  R"("contacts": {"pairs": [{"between": ["foot/top", "lug/bottom"], "kind": "bonded"}]},
                                     "supports": [{"on": "foot/bottom", "fix": ["x", "y"]}], "loads": [{"on": "lug/top", "moment": 10}])");
        ASSERT_EQ(r.status, "ok") << r.message;
        const double back = -angle * std::numbers::pi / 180;
        const Vec2 x = r.parts[1].max_von_mises.at,
                   at(std::cos(back) * x.x() - std::sin(back) * x.y(), std::sin(back) * x.x() + std::cos(back) * x.y());
        EXPECT_TRUE(r.parts[1].max_von_mises_at_corner) << angle;
        EXPECT_NEAR(std::abs(at.x()), 1, 0.1) << angle;
        EXPECT_NEAR(at.y(), 0, 0.1) << angle;
    }
}

/// Flush halves make a straight edge, a step that is filled none at all.
TEST(Bonded, EndsInNoCornerWhereTheOutlineGoesOnStraight) {
    const Result flush = analyzed(halves, bonded + R"(, "supports": [{"on": "a/left", "symmetry": true},
        {"part": "a", "rigid": {"translation": [null, 0], "rotation": null}}], "loads": [{"on": "b/right", "moment": 1}])");
    ASSERT_EQ(flush.status, "ok") << flush.message;
    for (const PartResult& part : flush.parts) EXPECT_FALSE(part.max_von_mises_at_corner) << part.name;
    // A square set into the corner of an L: two bonds meet in the corner, both end where the outlines are flush.
    const Result filled = analyzed(
        R"({"name": "l", "material": "m", "geometry": {"polygon": [[0, 0], [4, 0], [4, 2], [2, 2], [2, 4], [0, 4]]}},)" +
            block("square", "[2, 2]", "[4, 4]"),
        R"("contacts": {"pairs": [{"between": ["l/*", "square/*"], "kind": "bonded"}]},
           "supports": [{"on": ["l/e0", "l/e5"], "symmetry": true}],
           "loads": [{"on": "square/right", "traction": [10, 0]}, {"on": "l/e1", "traction": [10, 0]}])");
    ASSERT_EQ(filled.status, "ok") << filled.message;
    EXPECT_FALSE(filled.parts[1].max_von_mises_at_corner) << "nothing of the square is a corner of the whole";
    // One bond pulls, the other carries nothing: that has no estimates of its own, and is not in tension.
    ASSERT_EQ(filled.contacts.size(), 2U);
    EXPECT_FALSE(filled.contacts[0].errors);
    ASSERT_TRUE(filled.contacts[1].errors);
    EXPECT_LT(filled.contacts[1].errors->peak, 1e-6);
    for (const std::string& warning : filled.warnings) EXPECT_EQ(warning.find("l/e2"), std::string::npos) << warning;
}

TEST(Bonded, WithoutItTheSamePartsFallApart) {
    const Result r = analyzed(halves, grids + R"(, "supports": [{"on": "a/left", "fix": ["x", "y"]}],
        "loads": [{"on": "b/right", "traction": [0, -1]}])");
    EXPECT_EQ(r.status, "failed");
    EXPECT_NE(r.message.find("b "), std::string::npos) << r.message;
}

TEST(Bonded, HasNoInterference) {
    try {
        analyzed(halves,
                 R"("contacts": {"pairs": [{"between": ["a/right", "b/left"], "kind": "bonded", "interference": 0.1}]})");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("/contacts/pairs/0/interference"), std::string::npos) << error.what();
    }
}

/// A block whose top layer of that depth is a part of its own, bonded to it; 0: in one piece. more: parts, beginning with a
/// comma.
Result layered(double depth, const std::string& more, const std::string& rest) {
    const std::string y = std::to_string(-depth), joint = R"({"between": ["coat/bottom", "base/top"], "kind": "bonded"})";
    const bool is_whole = depth == 0;
    return analyzed(block("coat", is_whole ? "[-20, -20]" : "[-20, " + y + "]", "[20, 0]") +
                        (is_whole ? "" : "," + block("base", "[-20, -20]", "[20, " + y + "]")) + more,
                    R"("supports": [{"on": ")" + std::string(is_whole ? "coat" : "base") +
                        R"(/bottom", "fix": ["x", "y"]}], "contacts": {"pairs": [)" + (is_whole ? "" : joint) + "]}, " + rest);
}

TEST(Bonded, UnderSmoothPressureALayerIsPartOfTheBlock) {
    const std::string load = R"_("loads": [{"on": "coat/top", "pressure": "exp(-(x/2)^2)"}],
        "output": {"probes": [{"part": "coat", "at": [0, 0]}]})_";
    const Result whole = layered(0, "", load), thin = layered(0.1, "", load), thick = layered(1, "", load);
    for (const Result* r : {&thin, &thick}) {
        ASSERT_EQ(r->status, "ok") << r->message;
        EXPECT_NEAR(r->probes[0].displacement.y() / whole.probes[0].displacement.y(), 1, 0.01);
        EXPECT_NEAR(r->strain_energy / whole.strain_energy, 1, 0.01);
        EXPECT_NE(r->accuracy.of, "contact pressure");
        for (const std::string& warning : r->warnings) EXPECT_EQ(warning.find("slender"), std::string::npos) << warning;
    }
}

TEST(Bonded, UnderADiscALayerIsPartOfTheBlock) {
    const auto pressed = [](double depth) {
        return layered(depth,
                       R"(, {"name": "disc", "material": "m", "geometry": {"circle": {"center": [0, 10], "radius": 10}}})",
                       R"("loads": [{"part": "disc", "force": [0, -0.5]}])");
    };
    const auto contact = [](const Result& r) {
        return *std::find_if(r.contacts.begin(), r.contacts.end(),
                             [](const ContactResult& c) { return c.kind == "contact" && c.status != "open"; });
    };
    const ContactResult whole = contact(pressed(0));
    for (const double depth : {0.05, 0.1, 0.5}) {
        SCOPED_TRACE(depth);
        const Result r = pressed(depth);
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_TRUE(r.accuracy.reached) << r.accuracy.why;
        EXPECT_NEAR(contact(r).max_pressure.value / whole.max_pressure.value, 1, 0.01);
        EXPECT_NEAR(contact(r).contact_length / whole.contact_length, 1, 0.01);
    }
}

/// What is said of the peak of a block that is glued on a base of the same size or a larger one, and pressed.
ContactErrors peak_of_glued(const std::string& base, double modulus) {
    const Result r = analyze(read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}, "top": {"E": )" +
                                                 std::to_string(modulus) + R"(, "nu": 0.3}}, "parts": [)" + base +
                                                 R"(, {"name": "block", "material": "top", "geometry": {"rectangle": {"min":
        [0, 0], "max": [4, 3]}}}], "contacts": {"pairs": [{"between": ["base/top", "block/bottom"], "kind": "bonded"}]},
        "supports": [{"on": "base/bottom", "fix": ["x", "y"]}], "loads": [{"on": "block/top", "traction": [-2, -6]}]})",
                                             "scene.json"),
                             {});
    EXPECT_EQ(r.status, "ok") << r.message;
    return r.contacts.at(0).errors.value();
}

TEST(Bonded, PressuresHaveNoLimitWhereTheBondEndsInAReentrantCornerOrBetweenUnlikeMaterials) {
    const std::string wide = block("base", "[-3, -3]", "[7, 0]"), flush = block("base", "[0, -3]", "[4, 0]");
    EXPECT_TRUE(peak_of_glued(wide, 1000).at_corner);
    EXPECT_FALSE(peak_of_glued(flush, 1000).at_corner);
    EXPECT_TRUE(peak_of_glued(flush, 10000).at_corner);
}

TEST(Bonded, EndsInNoCornerOnAPlaneOfSymmetry) {
    const Result r = analyze(read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3},
        "hard": {"E": 10000, "nu": 0.3}}, "parts": [)" +
                                                 block("base", "[0, -3]", "[4, 0]") +
                                                 R"(, {"name": "block", "material": "hard", "geometry": {"rectangle": {"min":
        [0, 0], "max": [4, 3]}}}], "contacts": {"pairs": [{"between": ["base/top", "block/bottom"], "kind": "bonded"}]},
        "supports": [{"on": "base/bottom", "fix": ["y"]},
            {"on": ["base/left", "block/left", "base/right", "block/right"], "symmetry": true}],
        "loads": [{"on": "block/top", "traction": [0, -6]}]})",
                                             "scene.json"),
                             {});
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_FALSE(r.contacts.at(0).errors.value().at_corner);
    EXPECT_NEAR(r.contacts.at(0).max_pressure.value, 6, 1e-9);
    for (const PartResult& part : r.parts) EXPECT_FALSE(part.max_von_mises_at_corner) << part.name;
    EXPECT_TRUE(r.accuracy.reached);
}

/// Two blocks of one steel that are heated alike: the bond has nothing to carry, and what rounding leaves of that is not told.
TEST(Bonded, WhatCarriesNothingIsKnown) {
    for (const char* analysis : {"plane_strain", "plane_stress"}) {
        const Result r =
            analyze(read_scene_text(R"({"abut": 1, "analysis": ")" + std::string(analysis) +
                                        R"(", "materials": {"m": {"E": 210000, "nu": 0.3, "expansion": 1.2e-5}},
            "parts": [)" + block("a", "[0, 0]", "[40, 10]") +
                                        ", " + block("b", "[0, 10]", "[40, 20]") +
                                        R"(], "contacts": {"pairs": [{"between": ["a/top", "b/bottom"], "kind": "bonded"}]},
            "supports": [{"part": "a", "at": [0, 0], "fix": ["x", "y"]}, {"part": "a", "at": [40, 0], "fix": ["y"]}],
            "loads": [{"part": "a", "temperature": 100}, {"part": "b", "temperature": 100}]})",
                                    "scene.json"),
                    {});
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_TRUE(r.reasons.empty()) << r.reasons.front().text;
        EXPECT_TRUE(r.warnings.empty()) << r.warnings.front();
    }
}

}  // namespace abut::bonded_test
