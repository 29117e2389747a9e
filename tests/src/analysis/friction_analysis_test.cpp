// SPDX-License-Identifier: GPL-3.0-or-later
// Friction in whole analyses: a block that is pressed on another and pushed along it, until some of its face slips.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/analysis/analysis.hpp"
#include "src/plan/plan.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::friction_analysis_test {
namespace {

/// size: of everything, with the unit of length; force: likewise.
struct Blocks {
    std::string contacts = R"({"friction": 0.4})", more{};
    double size = 1, force = 1, push = 25;
    bool swapped = false;
};

std::string rectangle(const std::string& name, double size, double x0, double y0, double x1, double y1) {
    const auto t = [&](double v) { return std::to_string(v * size); };
    return R"({"name": ")" + name + R"(", "material": "m", "geometry": {"rectangle": {"min": [)" + t(x0) + "," + t(y0) +
           R"(], "max": [)" + t(x1) + "," + t(y1) + "]}}}";
}

Scene scene_of(const Blocks& b) {
    const std::string base = rectangle("base", b.size, 0, 0, 4, 2), top = rectangle("top", b.size, 0.5, 2, 3.5, 4);
    const double stress = b.force / (b.size * b.size);
    return read_scene_text(R"({"abut": 1, "materials": {"m": {"E": )" + std::to_string(1e5 * stress) + R"(, "nu": 0.3}},
        "parts": [)" + (b.swapped ? top + "," + base : base + "," + top) +
                               R"(], "supports": [{"on": "base/bottom", "fix": ["x", "y"]}],
        "loads": [{"name": "press", "on": "top/top", "traction": [0, )" +
                               std::to_string(-100 * stress) + R"(]},
                  {"name": "push", "on": "top/top", "traction": [)" +
                               std::to_string(b.push * stress) + R"(, 0]}],
        "accuracy": {"cell_size": )" +
                               std::to_string(0.25 * b.size) + R"(}, "contacts": )" + b.contacts + b.more + "}",
                           "blocks.json");
}

Result answer(const Blocks& b) {
    return analyze(scene_of(b), {});
}

double beyond_bound(const ContactResult& c) {
    double worst = 0;
    for (std::size_t k = 0; k < c.profile.shear.size(); ++k)
        worst = std::max(worst, std::abs(c.profile.shear[k]) - c.friction->coefficient * c.profile.pressure[k]);
    return worst;
}

bool is_effect_on(const std::vector<Effect>& effects) {
    return std::find_if(effects.begin(), effects.end(), [](const Effect& e) { return e.name == "friction"; })->on;
}

}  // namespace

TEST(FrictionAnalysis, SlipsWhereItMustAndHoldsTheRest) {
    const Result r = answer({});
    ASSERT_EQ(r.status, "ok") << r.message;
    const ContactResult& c = r.contacts.at(0);
    ASSERT_TRUE(c.friction);
    EXPECT_NEAR(c.friction->shear_force, 3 * 25, 1e-7)
        << "on the second part, along the first's normal turned left: to the left";
    EXPECT_NEAR(c.friction->normal_force, 3 * 100, 1e-7);
    EXPECT_NEAR(*c.friction->utilisation, 25.0 / 40, 1e-9);
    EXPECT_NEAR(c.friction->slip_length + c.friction->stick_length, c.contact_length, 1e-9);
    EXPECT_GT(c.friction->stick_length, 0.1);
    EXPECT_GT(c.friction->dissipated, 0);
    EXPECT_LT(beyond_bound(c), 1e-9);
    EXPECT_LT(r.equilibrium.relative_residual, 1e-9);
    EXPECT_LT(r.equilibrium.relative_moment_residual, 1e-9);
    EXPECT_LT((c.force - Vec2(3 * 25, -3 * 100)).norm(), 1e-6) << "on the base, shear included";
    ASSERT_EQ(c.profile.slip.size(), c.profile.s.size());
    ASSERT_EQ(c.profile.state.size(), c.profile.s.size());
    const std::string csv = contact_csv(c);
    EXPECT_EQ(csv.find("edge,s,x,y,pressure,gap,shear,slip,state\n"), 0U);
    EXPECT_NE(csv.find(",slip\n"), std::string::npos);
}

TEST(FrictionAnalysis, OfNothingIsNoneToTheBit) {
    const std::string held = R"(, "output": {"probes": [{"part": "top", "at": [1, 3]}]})";
    const Blocks blocks{R"({})", held, 1, 1, 0};
    Scene none = scene_of(blocks);
    none.supports.push_back(read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1, "nu": 0}}, "parts": [)" +
                                                rectangle("top", 1, 0, 0, 1, 1) +
                                                R"(], "supports": [{"part": "top", "rigid": {"translation": [0, null]}}]})",
                                            "support.json")
                                .supports.at(0));
    Scene zero = none;
    zero.contacts.friction = 0;
    const Result a = analyze(none, {}), b = analyze(zero, {});
    ASSERT_EQ(a.status, "ok") << a.message;
    EXPECT_EQ(a.contacts[0].profile.pressure, b.contacts[0].profile.pressure);
    EXPECT_EQ(a.probes[0].displacement, b.probes[0].displacement);
    EXPECT_FALSE(a.contacts[0].friction);
    EXPECT_TRUE(a.contacts[0].profile.slip.empty());
    EXPECT_EQ(contact_csv(a.contacts[0]).find("edge,s,x,y,pressure,gap\n"), 0U);
    EXPECT_FALSE(is_effect_on(a.effects));
    zero.contacts.friction = 0.1;
    EXPECT_TRUE(is_effect_on(plan_effects(zero)));
    zero.contacts.detect = false;
    EXPECT_FALSE(is_effect_on(plan_effects(zero))) << "no pair can touch";
}

TEST(FrictionAnalysis, KnowsNoUnitsAndNoOrderOfParts) {
    const Result r = answer({}), other_units = answer({R"({"friction": 0.4})", {}, 1000, 64});
    const ContactResult &a = r.contacts.at(0), &b = other_units.contacts.at(0);
    // the thickness is one of the unit of length in both
    EXPECT_NEAR(b.friction->shear_force / 0.064, a.friction->shear_force, 1e-7);
    EXPECT_NEAR(b.friction->slip_length / 1000, a.friction->slip_length, 1e-6);
    EXPECT_NEAR(b.friction->dissipated / 64, a.friction->dissipated, 1e-6 * a.friction->dissipated);
    Blocks swapped;
    swapped.swapped = true;
    const Result exchanged = answer(swapped);
    const ContactResult& c = exchanged.contacts.at(0);
    EXPECT_NEAR(c.friction->shear_force, a.friction->shear_force, 1e-7) << "both the other part and the other direction";
    EXPECT_NEAR(c.friction->slip_length, a.friction->slip_length, 1e-6);
    EXPECT_NEAR(c.friction->dissipated, a.friction->dissipated, 1e-6 * a.friction->dissipated);
}

TEST(FrictionAnalysis, HoldsNoMoreThanItCan) {
    const Result r = answer({R"({"friction": 0.24})"});
    EXPECT_EQ(r.status, "failed");
    EXPECT_NE(r.message.find("top slides along (1, 0)"), std::string::npos) << r.message;
    EXPECT_NE(r.message.find("A coefficient of friction of 0.25 would hold it, 0.24 does not"), std::string::npos) << r.message;
    EXPECT_EQ(answer({R"({"friction": 0.26})"}).status, "ok");
}

/// Two discs on a floor that carry a third one rest where friction exceeds tan 15 degrees, 0.268. Below they part, until the
/// third one lies between them.
TEST(FrictionAnalysis, DiscsThatPartRestSideBySide) {
    const auto discs = [](double friction) {
        const auto disc = [](const std::string& name, double x, double y) {
            return R"({"name": ")" + name + R"(", "material": "steel", "geometry": {"circle": {"center": [)" +
                   std::to_string(x) + "," + std::to_string(y) + R"(], "radius": 10}}})";
        };
        return analyze(read_scene_text(R"({"abut": 1, "units": {"length": "mm", "force": "N"}, "parts": [
            {"name": "base", "material": "steel", "geometry": {"rectangle": {"min": [-60, -30], "max": [60, 0]}}},)" +
                                           disc("l", -10.005, 10) + "," + disc("r", 10.005, 10) + "," +
                                           disc("t", 0, 10 + std::sqrt(400 - 10.005 * 10.005)) + R"(],
            "supports": [{"on": "base/bottom", "fix": ["x", "y"]}], "loads": [{"part": "l", "force": [0, -100]}, {"part": "r", "force": [0, -100]}, {"part": "t", "force": [0, -100]}],
            "contacts": {"friction": )" + std::to_string(friction) +
                                           R"(}, "accuracy": {"level": "draft"}})",
                                       "discs.json"),
                       {});
    };
    const Result parting = discs(0.15);
    ASSERT_EQ(parting.status, "ok") << parting.message;
    EXPECT_TRUE(test::warns(parting.warnings, "would hold it, 0.15 does not"));
    EXPECT_NEAR(parting.contacts.at(2).force.y(), -100, 1e-6) << "on the floor";
    EXPECT_EQ(discs(0.3).status, "ok");
}

/// Four courses of bricks, pushed and let go: what was pressed while they were pushed takes part when they are let go, although
/// other faces are pressed then. So many rows are not all taken.
TEST(FrictionAnalysis, AWallThatHeldHoldsWhenItIsLetGo) {
    std::string bricks;
    const auto add = [&](int row, int k, int from, int to) {
        bricks += R"(, {"name": "b)" + std::to_string(row) + "_" + std::to_string(k) +
                  R"(", "material": "b", "geometry": {"rectangle": {"min": )" + test::pair_text(from, 60 * row) +
                  R"(, "max": )" + test::pair_text(to, 60 * (row + 1)) + "}}}";
    };
    for (int row = 0; row < 4; ++row)
        for (int k = 0; k < 3 + row % 2; ++k)
            add(row, k, std::max(0, 200 * k - 100 * (row % 2)), std::min(600, 200 * (k + 1) - 100 * (row % 2)));
    const std::vector<Result> steps = test::answer_of_cases(R"({"abut": 1, "thickness": 100,
        "materials": {"m": {"E": 2.1e5, "nu": 0.3, "density": 0}, "b": {"E": 1e4, "nu": 0.2, "density": 2e-9}}, "parts": [
        {"name": "floor", "material": "m", "geometry": {"rectangle": {"min": [-200, -50], "max": [800, 0]}}})" +
                                                            bricks +
                                                            R"(], "supports": [{"on": "floor/bottom", "fix": ["x", "y"]}],
        "loads": [{"name": "g", "gravity": [0, -9810]}, {"name": "h", "on": "b3_0/left", "force": [15, 0]}],
        "contacts": {"friction": 0.6}, "accuracy": {"level": "draft"}, "steps": [{"name": "rest", "loads": {"g": 1}},
        {"name": "push", "loads": {"g": 1, "h": 1}}, {"name": "let go", "loads": {"g": 1}}]})");
    ASSERT_EQ(steps.size(), 3U);
    for (const Result& r : steps) {
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_FALSE(test::warns(r.warnings, "depends on the way of the loads")) << "not followed";
    }
}

TEST(FrictionAnalysis, RemembersFromStepToStep) {
    Blocks blocks;
    blocks.more = R"(, "steps": [{"name": "press", "loads": {"press": 1}}, {"name": "push", "loads": {"press": 1, "push": 1}},
        {"name": "let go", "loads": {"press": 1}}, {"name": "lift", "loads": {"press": 0.5}}])";
    const std::vector<CaseResult> steps = analyze_cases(scene_of(blocks), {});
    ASSERT_EQ(steps.size(), 4U);
    const auto friction = [&](std::size_t k) { return *steps[k].result.contacts.at(0).friction; };
    for (const CaseResult& step : steps) {
        ASSERT_EQ(step.result.status, "ok") << step.name << ": " << step.result.message;
        EXPECT_GE(step.result.contacts.at(0).friction->dissipated, 0) << step.name;
        EXPECT_LT(beyond_bound(step.result.contacts.at(0)), 1e-9) << step.name;
        EXPECT_TRUE(step.result.solver.increments) << step.name;
    }
    EXPECT_NEAR(friction(1).shear_force, 75, 1e-7);
    EXPECT_NEAR(friction(2).shear_force, 0, 1e-7);
    const auto largest = [&](std::size_t k) {
        double most = 0;
        const ContactProfile& p = steps[k].result.contacts.at(0).profile;
        for (std::size_t i = 0; i < p.shear.size(); ++i)
            most = std::max(most, std::abs(p.shear[i] + p.shear[p.shear.size() - 1 - i]));
        return most;
    };
    EXPECT_LT(largest(0), 0.1 * largest(2)) << "pressed alone it is the same on both sides; pushed and let go it is not";
}

/// A wedge of 10 degrees on each side, friction 0.3: let go of, it stays jammed, and holds a pull that is far below what frees
/// it.
TEST(FrictionAnalysis, TheFirstStepsFindTheGridsOfAll) {
    const std::vector<CaseResult> steps =
        analyze_cases(read_scene(ABUT_SOURCE_DIR "/data/verification/mindlin_cycle.json"), {});
    ASSERT_EQ(steps.size(), 11U);
    for (const CaseResult& step : steps) {
        EXPECT_TRUE(step.result.accuracy.reached) << step.name;
        EXPECT_EQ(step.result.unknowns, steps.front().result.unknowns);
        EXPECT_GE(step.result.passes.size(), 2U) << "an estimate compares two grids";
    }
    EXPECT_LT(steps.back().result.passes.size(), steps.front().result.passes.size());
}

TEST(FrictionAnalysis, WorkIsTheSameInOneStepAsInTen) {
    // What is pressed and pushed in proportion slips in proportion: all of it is known from the end.
    const auto work = [](int n) {
        Blocks blocks;
        for (int k = 1; k <= n; ++k) {
            const std::string factor = std::to_string(1.0 * k / n);
            blocks.more += (k == 1 ? R"(, "steps": [)" : ", ") + std::string(R"({"name": "s)") + std::to_string(k) +
                           R"(", "loads": {"press": )" + factor + R"(, "push": )" + factor + "}}";
        }
        blocks.more += "]";
        double sum = 0;
        for (const CaseResult& step : analyze_cases(scene_of(blocks), {}))
            sum += step.result.contacts.at(0).friction->dissipated;
        return sum;
    };
    const double in_one = work(1);
    EXPECT_GT(in_one, 0);
    EXPECT_NEAR(work(10), in_one, 1e-3 * in_one);
}

TEST(FrictionAnalysis, KeepsWhatIsLockedInWhereNothingLoadsAPartAnyMore) {
    const auto steps_with = [](const std::string& let_go) {
        const Scene scene = read_scene_text(
            R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 2e5, "nu": 0.3}}, "parameters": {"t": 0.17632698070846498},
            "parts": [
            {"name": "wedge", "material": "m", "geometry": {"polygon": [[-5, 0], [5, 0], ["5+40*t", 40], ["-5-40*t", 40]]}},
            {"name": "left", "material": "m", "geometry": {"polygon": [[-40, 8], ["-5-8*t", 8], ["-5-30*t", 30], [-40, 30]]}},
            {"name": "right", "material": "m", "geometry": {"polygon": [["5+8*t", 8], [40, 8], [40, 30], ["5+30*t", 30]]}}],
            "supports": [{"on": "left/e3", "fix": ["x", "y"]}, {"on": "right/e1", "fix": ["x", "y"]}],
            "loads": [{"name": "P", "on": "wedge/e2", "force": [0, -1000]}], "contacts": {"friction": 0.3},
            "accuracy": {"level": "draft"},
            "steps": [{"name": "in", "loads": {"P": 1}}, {"name": "let go", "loads": {"P": )" +
                let_go + R"(}}, {"name": "pulled", "loads": {"P": -0.1}}]})",
            "wedge.json");
        return analyze_cases(scene, {});
    };
    const std::vector<CaseResult> nothing = steps_with("0"), little = steps_with("0.001");
    ASSERT_EQ(nothing.size(), 3U);
    const auto force = [](const CaseResult& step) { return step.result.contacts.at(0).force.norm(); };
    EXPECT_GT(force(little[1]), 500);
    EXPECT_NEAR(force(nothing[1]), force(little[1]), 0.01 * force(little[1]));
    EXPECT_EQ(nothing[2].result.status, "ok") << nothing[2].result.message;
    EXPECT_NEAR(force(nothing[2]), force(little[2]), 0.01 * force(little[2]));
}

/// A block on springs of 400 in all, each way, that 100 push down and 20 aside. From 0.1 above the ground it has gone two
/// fifths of its way aside before it touches.
TEST(FrictionAnalysis, ContactsThatTheLoadsCloseStickWhereTheyTouch) {
    const auto scene = [](const std::string& gap, const std::string& steps) {
        return read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 2e5, "nu": 0.3}},
            "parts": [{"name": "ground", "material": "rigid", "geometry": {"rectangle": {"min": [-3, -1], "max": [3, 0]}}},
                      {"name": "block", "material": "m", "geometry": {"rectangle": {"min": [-1, )" +
                                   gap + R"(], "max": [1, "2 + )" + gap + R"("]}}}],
            "supports": [{"part": "ground", "rigid": {"translation": [0, 0], "rotation": 0}},
                         {"on": "block/left", "spring": {"normal": 200}}, {"on": "block/top", "spring": {"normal": 200}},
                         {"part": "block", "rigid": {"rotation": 0}}],
            "loads": [{"name": "down", "part": "block", "force": [0, -100]}, {"name": "aside", "part": "block", "force": [20, 0]}],
            "contacts": {"friction": 0.5}, "accuracy": {"level": "draft"})" +
                                   steps + "}",
                               "friction.json");
    };
    const auto shear = [](const Result& r) {
        EXPECT_EQ(r.status, "ok") << r.message;
        return std::abs(r.contacts.at(0).friction->shear_force);
    };
    EXPECT_NEAR(shear(analyze(scene("0.1", ""), {})), 12, 0.02);
    EXPECT_NEAR(shear(analyze(scene("0", ""), {})), 20, 0.02);
    const std::vector<CaseResult> steps = analyze_cases(scene("0.1", R"(, "steps": [{"name": "close", "loads": {"down": 1}},
        {"name": "pull", "loads": {"down": 1, "aside": 1}}])"),
                                                        {});
    ASSERT_EQ(steps.size(), 2U);
    EXPECT_NEAR(shear(steps[0].result), 0, 0.02);
    EXPECT_NEAR(shear(steps[1].result), 20, 0.02);
    EXPECT_GT(*steps[0].result.solver.increments, 2) << "where it touches is looked for";
}

/// A stack that is pressed on from above only once its weightless upper block has come down; the middle one is pulled along
/// from the first load on.
TEST(FrictionAnalysis, LoadsOnTheWayThatNothingBalancesSpeakAgainstTheAnswer) {
    const auto scene = [](const std::string& gap) {
        return read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 2e5, "nu": 0.3}},
            "parts": [{"name": "ground", "material": "rigid", "geometry": {"rectangle": {"min": [-3, -1], "max": [3, 0]}}},
                      {"name": "middle", "material": "m", "geometry": {"rectangle": {"min": [-1, 0], "max": [1, 1]}}},
                      {"name": "top", "material": "m", "geometry": {"rectangle": {"min": [-1, "1 + )" +
                                   gap + R"("], "max": [1, "2 + )" + gap + R"("]}}}],
            "supports": [{"part": "ground", "rigid": {"translation": [0, 0], "rotation": 0}},
                         {"on": "top/top", "spring": {"normal": 200}}, {"part": "top", "rigid": {"translation": [0, null], "rotation": 0}}],
            "loads": [{"part": "top", "force": [0, -100]}, {"part": "middle", "force": [20, 0]}],
            "contacts": {"friction": 0.5}, "accuracy": {"level": "draft"}})",
                               "friction.json");
    };
    const auto is_told = [](const Result& r) {
        EXPECT_EQ(r.status, "ok") << r.message;
        return std::any_of(r.reasons.begin(), r.reasons.end(), [](const Reason& why) { return why.kind == "load_path"; });
    };
    EXPECT_FALSE(is_told(analyze(scene("0"), {})));
    EXPECT_TRUE(is_told(analyze(scene("0.1"), {}))) << "up to two fifths of the loads nothing presses on the middle block";
}

/// Two rollers between plates, one drawn smaller and lower: it is touched late and above first, and nothing holds it until
/// then. Friction hardly matters: forces are those that rollers have without.
TEST(FrictionAnalysis, ARollerThatIsTouchedLateIsWhereItWasDrawn) {
    const Result r = analyze(read_scene_text(R"({"abut": 1, "analysis": "plane_strain", "thickness": 10,
        "materials": {"steel": {"E": 210000, "nu": 0.3}},
        "parts": [{"name": "bed", "material": "rigid", "geometry": {"rectangle": {"min": [-60, -10], "max": [60, 0]}}},
                  {"name": "lid", "material": "rigid", "geometry": {"rectangle": {"min": [-60, 20], "max": [60, 30]}}},
                  {"name": "small", "material": "steel", "geometry": {"circle": {"center": [-30, 9.997], "radius": 9.996}}},
                  {"name": "large", "material": "steel", "geometry": {"circle": {"center": [0, 10], "radius": 10}}}],
        "supports": [{"part": "bed", "rigid": {"translation": [0, 0], "rotation": 0}},
                     {"part": "lid", "rigid": {"translation": [0, null], "rotation": 0}}],
        "loads": [{"part": "lid", "force": [300, -6000]}], "contacts": {"friction": 0.2}, "accuracy": {"level": "draft"}})",
                                             "rollers.json"),
                             {});
    ASSERT_EQ(r.status, "ok") << r.message;
    ASSERT_EQ(r.contacts.size(), 4U);
    for (const std::size_t k : {0, 2}) EXPECT_NEAR(r.contacts[k].friction->normal_force, 1477, 0.01 * 1477);
    for (const std::size_t k : {1, 3}) EXPECT_NEAR(r.contacts[k].friction->normal_force, 4523, 0.01 * 4523);
    for (const ContactResult& c : r.contacts) EXPECT_LT(std::abs(c.friction->shear_force), 0.01);
}

/// Six tubes heaped between walls under their weight. Their contacts are a hundredth as wide as the first cells, into whose
/// mean gaps bodies would sink farther than they yield, rolling and slipping on the way.
TEST(FrictionAnalysis, HeapsRestWhereTheyTouch) {
    const auto heap = [](const std::string& level) {
        std::string discs;
        for (int row = 0; row < 3; ++row)
            for (int k = 0; k < 3 - row; ++k)
                discs += R"({"name": "d)" + std::to_string(row) + std::to_string(k) +
                         R"(", "material": "S", "geometry": {"circle": {"center": )" +
                         test::pair_text(10 + 10 * row + 20 * k, 10 + 10 * std::sqrt(3.0) * row) + R"(, "radius": 10}}}, )";
        return test::answer(
            R"({"abut": 1, "materials": {"S": {"E": 210000, "nu": 0.3, "density": 7.85e-9}}, "thickness": 10,
            "parts": [)" +
            discs +
            R"({"name": "floor", "material": "S", "geometry": {"rectangle": {"min": [-20, -20], "max": [80, 0]}}},
            {"name": "left", "material": "S", "geometry": {"rectangle": {"min": [-20, 0], "max": [0, 60]}}},
            {"name": "right", "material": "S", "geometry": {"rectangle": {"min": [60, 0], "max": [80, 60]}}}],
            "supports": [{"on": ["floor/bottom", "left/left", "right/right"], "fix": ["x", "y"]}],
            "loads": [{"gravity": [0, -9810]}], "contacts": {"friction": 0.2}, "accuracy": {"level": ")" +
            level + "\"}}");
    };
    const Result r = heap("standard"), draft = heap("draft");
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_TRUE(r.accuracy.reached);
    EXPECT_LT(r.solver.contact_iterations, 2000) << "9000 where they sink";
    const auto force = [](const Result& result, const std::string& a, const std::string& b) {
        for (const ContactResult& c : result.contacts)
            if (c.parts[0] == a && c.parts[1] == b) return c.force;
        return Vec2(NAN, NAN);
    };
    const double weight = 9810 * 7.85e-9 * std::numbers::pi * 100 * 10;
    const Vec2 left = force(r, "d00", "floor"), middle = force(r, "d01", "floor"), right = force(r, "d02", "floor"),
               from_left = force(r, "d00", "left"), from_right = force(r, "d02", "right");
    EXPECT_NEAR(left.y() + middle.y() + right.y() + from_left.y() + from_right.y(), 6 * weight, 1e-3 * weight);
    EXPECT_NEAR(from_left.x(), -from_right.x(), 0.01 * weight);
    EXPECT_NEAR(left.y(), right.y(), 0.01 * weight);
    EXPECT_NEAR(left.y(), force(draft, "d00", "floor").y(), 0.05 * weight);
}

namespace {

/// The length that sticks, within twice the error that is stated of it, and that no larger than 0.15 of the contact.
void expect_stick(const ContactResult& c, double half_over_a) {
    ASSERT_TRUE(c.friction && c.friction->stick_length_error);
    const double truth = half_over_a * c.contact_length;
    EXPECT_LE(std::abs(c.friction->stick_length - truth), 2 * *c.friction->stick_length_error) << half_over_a;
    EXPECT_LE(*c.friction->stick_length_error, 0.15 * c.contact_length) << half_over_a;
}

}  // namespace

/// Cattaneo and Mindlin: what sticks is sqrt(1 - share) of the contact. Under a rigid cylinder (F14) a traction comes to its
/// bound without a kink, and small errors of it move the border far.
TEST(FrictionAnalysis, LengthsThatStickAreWithinTheirErrors) {
    const std::string folder = std::string(ABUT_SOURCE_DIR) + "/data/verification/";
    for (const double share : {0.1, 0.35, 0.5, 0.9, 0.97}) {
        Scene scene = read_scene(folder + "cattaneo.json");
        for (auto& load : scene.cases[1].factors)
            if (load.first == "shear") load.second = share / 0.5;
        scene.cases.resize(2);
        expect_stick(analyze_cases(scene, {}).at(1).result.contacts.at(0), std::sqrt(1 - share));
    }
    for (const double target : {0.05, 0.01, 0.002}) {
        Scene scene = read_scene(folder + "friction_indenter.json");
        scene.accuracy.target = target;
        expect_stick(analyze(scene, {}).contacts.at(0), 0.42984);
    }
}

/// A block between two plates, one rough, is pushed: it slides on the other, as friction lets it, and not on the rough one.
TEST(FrictionAnalysis, RoughFacesHoldBesideOthersThatSlip) {
    const std::vector<CaseResult> steps =
        analyze_cases(read_scene_text(R"({"abut": 1, "thickness": 10, "materials": {"steel": {"E": 210000, "nu": 0.3}},
        "parts": [{"name": "bed", "material": "rigid", "geometry": {"rectangle": {"min": [-60, -10], "max": [60, 0]}}},
                  {"name": "block", "material": "steel", "geometry": {"rectangle": {"min": [-10, 0], "max": [10, 10]}}},
                  {"name": "lid", "material": "rigid", "geometry": {"rectangle": {"min": [-60, 10], "max": [60, 20]}}}],
        "supports": [{"part": "bed", "rigid": {"translation": [0, 0], "rotation": 0}},
                     {"part": "lid", "rigid": {"translation": [null, null], "rotation": 0}},
                     {"on": "block/left", "spring": {"normal": 100}}],
        "loads": [{"name": "n", "part": "lid", "force": [0, -1000]}, {"name": "q", "on": "block/right", "force": [400, 0]}],
        "contacts": {"friction": 0.1, "pairs": [{"between": ["block/*", "lid/*"], "friction": "rough"}]},
        "accuracy": {"level": "draft"},
        "steps": [{"name": "press", "loads": {"n": 1}}, {"name": "push", "loads": {"n": 1, "q": 1}}]})",
                                      "s.json"),
                      {});
    ASSERT_EQ(steps.size(), 2U);
    for (const CaseResult& step : steps) {
        ASSERT_EQ(step.result.status, "ok") << step.result.message;
        EXPECT_LT(step.result.solver.contact_residual, 1e-6);
    }
    const std::vector<ContactResult>& contacts = steps[1].result.contacts;
    EXPECT_NEAR(contacts.at(0).friction->shear_force, 100, 0.1);
    EXPECT_NEAR(contacts.at(1).friction->shear_force, 0, 0.1);
    EXPECT_EQ(contacts.at(1).friction->slip_length, 0);
}

}  // namespace abut::friction_analysis_test
