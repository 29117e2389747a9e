// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that do not interact are problems of their own: two Hertz pairs in one scene give, bit for bit, what two scenes give.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/verification/scene_answers.hpp"

namespace abut::groups_test {
namespace {

/// Quarter of a cylinder on a block, its left side at x.
struct Pair {
    std::string name;
    double x, radius, pressure;
};

std::string scene_of(const std::vector<Pair>& pairs, const std::string& more_parts = "") {
    std::string parts, held, loads;
    for (const Pair& p : pairs) {
        const std::string comma = parts.empty() ? "" : ", ", r = test::number(p.radius);
        parts += comma + R"({"name": ")" + p.name + R"(cylinder", "material": "m", "geometry": {"intersection": [
                   {"circle": {"center": )" +
                 test::pair_text(p.x, p.radius) + R"(, "radius": )" + r + R"(}}, {"rectangle": {"min": )" +
                 test::pair_text(p.x, 0) + R"(, "max": )" + test::pair_text(p.x + p.radius, p.radius) + R"(}}]}},
                 {"name": ")" +
                 p.name + R"(block", "material": "m", "geometry": {"rectangle": {"min": )" + test::pair_text(p.x, -4) +
                 R"(, "max": )" + test::pair_text(p.x + 4, 0) + "}}}";
        held += comma + "\"" + p.name + R"(cylinder/left", ")" + p.name + R"(block/left", ")" + p.name + R"(block/bottom")";
        loads += comma + R"({"on": ")" + p.name + R"(cylinder/top", "pressure": )" + test::number(p.pressure) + "}";
    }
    return R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3}}, "parts": [)" + parts + more_parts +
           R"(], "supports": [{"on": [)" + held + R"(], "symmetry": true}], "loads": [)" + loads + "]}";
}

const Pair first{"a", 0, 1, 250}, second{"b", 100, 2, 600};

void expect_same(const Result& whole, std::size_t contact, std::size_t part, const Result& alone) {
    ASSERT_EQ(alone.contacts.size(), 1U);
    const ContactResult &x = whole.contacts.at(contact), &y = alone.contacts[0];
    EXPECT_EQ(x.parts, y.parts);
    EXPECT_EQ(x.force, y.force);
    EXPECT_EQ(x.max_pressure.value, y.max_pressure.value);
    EXPECT_EQ(x.error_estimate, y.error_estimate);
    EXPECT_EQ(x.contact_length, y.contact_length);
    ASSERT_GT(x.profile.pressure.size(), 20U);
    EXPECT_EQ(x.profile.pressure, y.profile.pressure);
    EXPECT_EQ(x.profile.gap, y.profile.gap);
    EXPECT_EQ(x.profile.s, y.profile.s);
    for (std::size_t k : {0U, 1U}) {
        EXPECT_EQ(whole.parts.at(part + k).unknowns, alone.parts.at(k).unknowns);
        EXPECT_EQ(whole.parts.at(part + k).max_displacement.value, alone.parts.at(k).max_displacement.value);
        EXPECT_EQ(whole.parts.at(part + k).max_von_mises.value, alone.parts.at(k).max_von_mises.value);
    }
}

TEST(Groups, TwoHertzPairsAreTwoScenes) {
    const Result whole = test::answer(scene_of({first, second})), a = test::answer(scene_of({first})),
                 b = test::answer(scene_of({second}));
    for (const Result* r : {&whole, &a, &b}) ASSERT_EQ(r->status, "ok") << r->message;
    ASSERT_EQ(whole.contacts.size(), 2U);
    EXPECT_EQ(whole.solver.groups, 2);
    EXPECT_EQ(whole.solver.contact_problems, 2);
    expect_same(whole, 0, 0, a);
    expect_same(whole, 1, 2, b);
    EXPECT_EQ(whole.unknowns, a.unknowns + b.unknowns);
    EXPECT_EQ(whole.multipliers, a.multipliers + b.multipliers);
    EXPECT_EQ(whole.solver.factorizations, a.solver.factorizations + b.solver.factorizations);
    EXPECT_EQ(whole.solver.grids, std::max(a.solver.grids, b.solver.grids));
    EXPECT_NEAR(whole.strain_energy, a.strain_energy + b.strain_energy, 1e-14 * whole.strain_energy);
    EXPECT_LT(whole.equilibrium.relative_residual, 1e-9);
    EXPECT_GT(std::abs(a.contacts[0].max_pressure.value / b.contacts[0].max_pressure.value - 1), 0.01);  // unlike pairs
}

TEST(Groups, TheOrderOfPartsDoesNotMatter) {
    const Result whole = test::answer(scene_of({second, first})), a = test::answer(scene_of({first}));
    ASSERT_EQ(whole.status, "ok") << whole.message;
    expect_same(whole, 1, 2, a);
}

TEST(Groups, AMechanismInOneIsNamed) {
    const Result r = test::answer(scene_of({first}, R"(, {"name": "loose", "material": "m",
        "geometry": {"circle": {"center": [500, 0], "radius": 1}}}, {"name": "free", "material": "m",
        "geometry": {"circle": {"center": [600, 0], "radius": 1}}})"));
    ASSERT_EQ(r.status, "ok") << r.message;  // nothing acts on them
    EXPECT_FALSE(r.parts[2].solved);
    std::string text = scene_of({first}, R"(, {"name": "loose", "material": "m",
        "geometry": {"circle": {"center": [500, 0], "radius": 1}}})");
    text.insert(text.size() - 2, R"(, {"part": "loose", "force": [0, 1]})");
    const Result driven = test::answer(text);
    EXPECT_EQ(driven.status, "failed");
    EXPECT_NE(driven.message.find("loose slides along"), std::string::npos) << driven.message;
}

}  // namespace
}  // namespace abut::groups_test
