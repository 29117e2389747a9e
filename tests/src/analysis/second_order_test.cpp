// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/second_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "src/analysis/analysis.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::second_order_test {
namespace {

const std::string steel = R"({"abut": 1, "thickness": 10, "materials": {"steel": {"E": 210000, "nu": 0.3}}, )";

Result analyzed(const std::string& members) {
    return analyze(read_scene_text(steel + members + "}", "scene.json"), {});
}

/// What is said of the second order; empty: nothing.
std::string told(const Result& r) {
    EXPECT_EQ(r.status, "ok") << r.message;
    for (const std::string& w : r.warnings)
        if (w.find("balanced where") != std::string::npos || w.find("tip over or buckle") != std::string::npos) return w;
    return "";
}

/// The number before "%" in it.
double percents(const std::string& text) {
    const std::size_t percent = text.find(" %");
    EXPECT_NE(percent, std::string::npos) << text;
    return percent == std::string::npos ? -1 : std::stod(text.substr(text.rfind(' ', percent - 1) + 1));
}

bool is_held_against_it(const Result& r) {
    return std::any_of(r.reasons.begin(), r.reasons.end(),
                       [](const Reason& reason) { return reason.text.find("balanced") != std::string::npos; });
}

/// A post of 500 x 10 that stands on its end, pressed by a share of its buckling load, with a side load at its top.
Result post(double share) {
    const double buckling = M_PI * M_PI * 210000 * 10 * 1000 / 12 / (4 * 500.0 * 500.0);
    return analyzed(
        R"("parts": [{"name": "post", "material": "steel", "geometry": {"rectangle": {"min": [-5, 0], "max": [5, 500]}}}],
        "supports": [{"on": "post/bottom", "fix": ["x", "y"]}], "accuracy": {"target": 0.02},
        "loads": [{"on": "post/top", "force": [20, )" +
        std::to_string(-share * buckling) + "]}]");
}

TEST(SecondOrder, ColumnsBelowTheirBucklingLoad) {
    for (const double share : {0.2, 0.5, 0.8}) {
        // [Timoshenko61, section 1.11]: a cantilever with an axial and a side load
        const double u = M_PI / 2 * std::sqrt(share), growth = 3 * (std::tan(u) - u) / (u * u * u) - 1;
        const Result r = post(share);
        EXPECT_NEAR(percents(told(r)), 100 * growth, 15 * growth + 1) << share;
        EXPECT_TRUE(is_held_against_it(r));
    }
    EXPECT_NE(told(post(1.3)).find("may tip over or buckle"), std::string::npos);
    EXPECT_EQ(told(post(0.002)), "");
}

TEST(SecondOrder, StrutsThatAreStraight) {
    const double length = 300, buckling = M_PI * M_PI * 210000 * 10 * 125 / 12 / (length * length);
    const auto strut = [&](double share) {
        return analyzed(R"("parts": [
            {"name": "foot", "material": "steel", "geometry": {"circle": {"center": [0, -0.02], "radius": 5}}},
            {"name": "strut", "material": "steel", "geometry": {"difference": [{"union": [{"rectangle": {"min": [-2.5, 0], "max": [2.5, 300]}},
               {"circle": {"center": [0, 0], "radius": 10}}, {"circle": {"center": [0, 300], "radius": 10}}]},
               {"circle": {"center": [0, 0], "radius": 5.02}}, {"circle": {"center": [0, 300], "radius": 5.02}}]}},
            {"name": "pin", "material": "steel", "geometry": {"circle": {"center": [0, 300.02], "radius": 5}}}],
            "supports": [{"part": "foot", "rigid": {"translation": [0, 0], "rotation": 0}}, {"part": "pin", "rigid": {"translation": [0, null], "rotation": 0}}],
            "accuracy": {"level": "draft"}, "loads": [{"part": "pin", "force": [0, )" +
                        std::to_string(-share * buckling) + "]}]");
    };
    EXPECT_NE(told(strut(1.5)).find("part strut may tip over or buckle"), std::string::npos) << told(strut(1.5));
    EXPECT_EQ(told(strut(0.7)), "");
    EXPECT_EQ(told(strut(-3)), "");
}

TEST(SecondOrder, StringsThatArePulled) {
    const Result r = post(-5);  // 1 / (1 + 5) of the side load's bending is left, about
    EXPECT_NEAR(percents(told(r)), 83, 5);
}

TEST(SecondOrder, BeamsWhoseEndsCannotComeCloser) {
    const auto bent = [](double pressure) {
        return analyzed(
            R"("parts": [{"name": "beam", "material": "steel", "geometry": {"rectangle": {"min": [0, 0], "max": [1000, 10]}}}],
            "supports": [{"on": ["beam/left", "beam/right"], "fix": ["x", "y"]}], "accuracy": {"target": 0.02},
            "loads": [{"on": "beam/top", "pressure": )" +
            std::to_string(pressure) + "}]");
    };
    // w = w_lin / (1 + 0.75 (w / h)^2), by the first approximation that the ends' pull gives; w_lin = p L^4 / 384 E I' here
    const double h = 10, w_lin = 10, p = w_lin * 384 * 210000 * h * h * h / 12 / 1e12;
    double w = w_lin;
    for (int k = 0; k < 50; ++k) w = 0.5 * (w + w_lin / (1 + 0.75 * w * w / (h * h)));
    EXPECT_NEAR(percents(told(bent(p))), 100 * (1 - w / w_lin), 15);
    EXPECT_EQ(told(bent(0.01 * p)), "");
}

TEST(SecondOrder, APropThatASpringHolds) {
    const auto prop = [](double spring) {
        return analyzed(R"("parts": [
            {"name": "foot", "material": "steel", "geometry": {"circle": {"center": [0, -0.02], "radius": 8}}, "level": 1},
            {"name": "prop", "material": "steel", "level": 1, "geometry": {"difference": [{"slot": {"from": [0, 0], "to": [0, 300], "radius": 16}},
               {"circle": {"center": [0, 0], "radius": 8.02}}, {"circle": {"center": [0, 300], "radius": 8.02}}]}},
            {"name": "pin", "material": "steel", "geometry": {"circle": {"center": [0, 300.02], "radius": 8}}, "level": [1, 2]},
            {"name": "slide", "material": "steel", "level": 2, "geometry": {"difference": [{"name": "q", "rectangle": {"min": [-30, 270], "max": [30, 330]}},
               {"circle": {"center": [0, 300.04], "radius": 8.02}}]}}],
            "supports": [{"part": "foot", "rigid": {"translation": [0, 0], "rotation": 0}}, {"part": "pin", "rigid": {"rotation": 0}},
                         {"part": "slide", "rigid": {"rotation": 0}}, {"on": "slide/q/right", "spring": {"normal": )" +
                        std::to_string(spring / 600) +
                        R"(}}], "loads": [{"part": "slide", "force": [2, -5000]}], "accuracy": {"level": "draft"})");
    };
    // the prop's own stiffness is -F / L = -16.7 N/mm
    EXPECT_NE(told(prop(10)).find("may tip over or buckle"), std::string::npos) << told(prop(10));
    EXPECT_NEAR(percents(told(prop(25))), 200, 20);
    EXPECT_EQ(told(prop(2500)), "");
}

TEST(SecondOrder, ARollerRollsWithoutResistance) {
    const auto bridge = [](double spring) {
        return analyzed(
            R"("parts": [{"name": "floor", "material": "steel", "geometry": {"rectangle": {"min": [-220, -30], "max": [220, 0]}}},
            {"name": "beam", "material": "steel", "geometry": {"rectangle": {"min": [-220, 100], "max": [220, 130]}}},
            {"name": "roller", "material": "steel", "geometry": {"circle": {"center": [0, 50], "radius": 50}}}],
            "supports": [{"on": "floor/bottom", "fix": ["x", "y"]}, {"part": "beam", "rigid": {"rotation": 0}},
                         {"on": "beam/right", "spring": {"normal": )" +
            std::to_string(spring / 300) + R"(}}],
            "loads": [{"part": "beam", "force": [0, -5000]}, {"on": "beam/right", "force": [10, 0]}],
            "contacts": {"friction": "rough"}, "accuracy": {"level": "draft"})");
    };
    // the contacts' places move along: F / 2 R = 50 N/mm too much beside the spring
    EXPECT_NEAR(percents(told(bridge(50))), 100, 20);
    EXPECT_EQ(told(bridge(50000)), "");
}

TEST(SecondOrder, ADiscThatIsTurnedStaysAsLargeAsItIs) {
    const Result r = analyzed(
        R"("parts": [{"name": "plate", "material": "steel", "geometry": {"rectangle": {"min": [-80, -30], "max": [80, 0]}}},
        {"name": "disc", "material": "steel", "geometry": {"circle": {"center": [0, 60], "radius": 60}}}],
        "supports": [{"on": "plate/bottom", "fix": ["x", "y"]}, {"part": "disc", "rigid": {"translation": [0, -0.02], "rotation": 0.3}}])");
    EXPECT_TRUE(std::any_of(r.warnings.begin(), r.warnings.end(), [](const std::string& w) {
        return w.find("the force of contact 1 changes by about") != std::string::npos;
    })) << told(r);
}

/// How much of something is said to change, in percent; 0: nothing.
double told_of(const Result& r, const std::string& what) {
    for (const std::string& w : r.warnings)
        if (const std::size_t begin = w.find(what + " change"); begin != std::string::npos) return percents(w.substr(begin));
    return 0;
}

/// A plunger between the round noses of two arms of one part, whose motions cancel out in the mean: it spreads them along
/// (a + u)^2 + h^2 = (R + r)^2, and its force turns.
TEST(SecondOrder, ArmsThatAPlungerSpreads) {
    const double a = 15 * std::cos(M_PI / 6), before = 7.5, u_linear = before / a;
    const std::string x = std::to_string(a), in = std::to_string(a - 2), out = std::to_string(a + 2);
    const auto arm = [&](const std::string& left, const std::string& right, const std::string& nose) {
        return R"({"rectangle": {"min": [)" + left + R"(, -120], "max": [)" + right + R"(, 0]}}, {"circle": {"center": [)" +
               nose + R"(, 0], "radius": 5}}, )";
    };
    const Result r =
        analyzed(R"("parts": [{"name": "arms", "material": "steel", "geometry": {"union": [)" + arm(in, out, x) +
                 arm("-" + out, "-" + in, "-" + x) + R"({"rectangle": {"min": [-)" + out + R"(, -140], "max": [)" + out +
                 R"(, -120]}}]}},
        {"name": "plunger", "material": "rigid", "geometry": {"circle": {"center": [0, 7.5], "radius": 10}}}],
        "supports": [{"on": {"part": "arms", "near": [0, -140]}, "fix": ["x", "y"]},
                     {"part": "plunger", "rigid": {"translation": [0, -1], "rotation": 0}}])");
    const double now = before - 1, u = std::sqrt(15 * 15 - now * now) - a;
    EXPECT_NEAR(told_of(r, "displacements of part arms"), 100 * (1 - u / u_linear), 1);
    // along the plunger, of the force of one nose
    const double along = 2 * u * now / (a + u), along_linear = 2 * u_linear * before / a,
                 largest = u_linear / std::cos(M_PI / 6);
    EXPECT_NEAR(told_of(r, "contacts on part arms"), 100 * (along_linear - along) / largest, 3);
}

/// Round faces that slide along each other open by s^2 / 2 (R1 + R2): against the disc drawn where it is led to.
TEST(SecondOrder, RoundOverRound) {
    const auto force = [](const Vec2& drawn, const Vec2& led) {
        const auto text = [](const Vec2& v) { return std::to_string(v.x()) + ", " + std::to_string(v.y()); };
        return analyzed(
            R"("parts": [{"name": "lower", "material": "steel", "geometry": {"circle": {"center": [0, -20], "radius": 20}}},
            {"name": "upper", "material": "steel", "geometry": {"circle": {"center": [)" +
            text(drawn) + R"(], "radius": 20}}}],
            "supports": [{"part": "lower", "rigid": {"translation": [0, 0], "rotation": 0}},
                         {"part": "upper", "rigid": {"translation": [)" +
            text(led) + R"(], "rotation": 0}}])");
    };
    const Result there = force({0.3, 20 - 0.001125}, {0, -0.000875}), led = force({0, 20}, {0.3, -0.002});
    const double right = there.contacts.at(0).force.norm(), by_normals = led.contacts.at(0).force.norm();
    EXPECT_NEAR(std::max(told_of(led, "contacts on part lower"), told_of(led, "the force of contact 1")),
                100 * (1 - right / by_normals), 3);
}

/// A pendulum that stands on springs, whatever else the scene holds that a larger force presses.
TEST(SecondOrder, SmallForcesBesideLargeOnes) {
    for (const double beside : {0.0, 1e4, 1e8}) {
        const Result r =
            analyze(read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 2e5, "nu": 0.3}, "hard": {"E": 1e13, "nu": 0.3}},
            "parts": [{"name": "b", "material": "rigid", "geometry": {"rectangle": {"min": [-5, 0], "max": [5, 200]}}},
                      {"name": "block", "material": "hard", "geometry": {"rectangle": {"min": [200, 0], "max": [300, 100]}}}],
            "supports": [{"on": "b/bottom", "spring": {"normal": 24, "tangential": 24}}, {"on": "block/bottom", "fix": ["x", "y"]}],
            "loads": [{"on": "b/top", "force": [0.04, -4]}, {"on": "block/top", "force": [0, )" +
                                        std::to_string(-beside) + "]}]}",
                                    "s.json"),
                    {});
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_TRUE(std::any_of(r.reasons.begin(), r.reasons.end(), [](const Reason& reason) {
            return reason.text.find("displacements of part b change by about 67 %") != std::string::npos;
        })) << beside;
    }
}

/// Leaves that rough faces hold at sharp corners, where strains are of the order of a hundred: by hand the forces between them
/// turn by less than 1 % of themselves.
TEST(SecondOrder, StrainsAtCornersTellNothing) {
    const Result r = analyze(read_scene_text(R"({"abut": 1, "thickness": 20, "materials": {"m": {"E": 210000, "nu": 0.3}},
        "parts": [{"name": "l1", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [100, 4]}}},
                  {"name": "l2", "material": "m", "geometry": {"rectangle": {"min": [0, -4], "max": [70, 0]}}},
                  {"name": "l3", "material": "m", "geometry": {"rectangle": {"min": [0, -8], "max": [40, -4]}}}],
        "supports": [{"on": ["l1/left", "l2/left", "l3/left"], "fix": ["x", "y"]}],
        "loads": [{"on": {"part": "l1", "box": [[98, 3.9], [100, 4.1]]}, "force": [0, -50]}],
        "contacts": {"friction": "rough"}})",
                                             "s.json"),
                             {});
    ASSERT_EQ(r.status, "ok") << r.message;
    for (const Reason& reason : r.reasons)
        EXPECT_TRUE(reason.kind != "turned_force" && reason.kind != "displacement") << reason.text;
}

TEST(SecondOrder, HalfModelsAndStiffPartsCallForNothing) {
    for (const char* name : {"case_b", "pin_bracket", "clevis", "vise"}) {
        const Result r = analyze(read_scene(std::string(ABUT_SOURCE_DIR) + "/data/scenes/" + name + ".json"), {});
        EXPECT_EQ(told(r), "") << name;
    }
    // half of a roller on half of a block: the faces of both turn and move aside by what they press each other in by
    const Result half = analyzed(R"("parts": [
        {"name": "roller", "material": "steel", "geometry": {"intersection": [{"circle": {"center": [0, 10], "radius": 10}},
            {"rectangle": {"min": [0, 0], "max": [10, 10]}}]}},
        {"name": "block", "material": "steel", "geometry": {"rectangle": {"min": [0, -40], "max": [40, 0]}}}],
        "supports": [{"on": ["roller/left", "block/left", "block/bottom"], "symmetry": true}],
        "loads": [{"on": "roller/top", "pressure": 50}])");
    EXPECT_EQ(told(half), "");
}

}  // namespace
}  // namespace abut::second_order_test
