// SPDX-License-Identifier: GPL-3.0-or-later
// Assemblies of many contacts against Hertz' closed form and statics: a column of discs, a box of discs.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "tests/verification/scene_answers.hpp"

namespace abut::many_contacts_test {
namespace {

constexpr double modulus = 2e5, ratio = 0.3;
constexpr double half_plane = modulus / (1 - ratio * ratio);  // E' of one body in plane strain

std::string part(const std::string& name, const std::string& geometry) {
    return R"({"name": ")" + name + R"(", "material": "m", "geometry": )" + geometry + "}";
}
std::string disc(const std::string& name, double x, double y) {
    return part(name, R"({"circle": {"center": )" + test::pair_text(x, y) + R"(, "radius": 1}})");
}
std::string block(const std::string& name, double x0, double y0, double x1, double y1) {
    return part(name, R"({"rectangle": {"min": )" + test::pair_text(x0, y0) + R"(, "max": )" + test::pair_text(x1, y1) + "}}");
}
std::string scene(const std::string& parts, const std::string& supports, const std::string& loads, const std::string& level) {
    return R"({"abut": 1, "analysis": "plane_strain", "materials": {"m": {"E": 2e5, "nu": 0.3}}, "parts": [)" + parts +
           R"(], "supports": [)" + supports + R"(, {"part": "lid", "rigid": {"translation": [0, null], "rotation": 0}}],
           "loads": [)" +
           loads + R"(], "accuracy": {"level": ")" + level + R"("}})";
}

/// Hertz' largest pressure of a line contact; curvature: of both bodies, added.
double largest_pressure(double force, double curvature) {
    return std::sqrt(force * curvature * half_plane / 2 / std::numbers::pi);
}

TEST(ManyContacts, EveryContactOfAColumnIsHertz) {
    constexpr int n = 10;
    constexpr double force = 100;
    std::string parts = block("floor", -2, -2, 2, 0) + ", " + block("lid", -2, 2 * n, 2, 2 * n + 2);
    for (int k = 0; k < n; ++k) parts += ", " + disc("d" + std::to_string(k), 0, 2 * k + 1);
    const Result r = test::answer(
        scene(parts, R"({"on": "floor/bottom", "fix": ["x", "y"]})", R"({"part": "lid", "force": [0, -100]})", "standard"));
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_TRUE(r.accuracy.reached) << r.accuracy.why;
    ASSERT_EQ(r.contacts.size(), n + 1U);
    for (const ContactResult& c : r.contacts) {
        const bool on_flat = c.parts[0] == "floor" || c.parts[1] == "floor" || c.parts[0] == "lid" || c.parts[1] == "lid";
        EXPECT_NEAR(std::abs(c.force.y()), force, 1e-8 * force);
        // contacts of a hundredth of the radius are half planes to their square; the rest is the accuracy asked for
        const double expected = largest_pressure(force, on_flat ? 1 : 2);
        EXPECT_NEAR(c.max_pressure.value, expected, 0.012 * expected) << c.parts[0] << " " << c.parts[1];
    }
}

/// Rows of n discs in a box, every second one shifted by a radius: all contacts hang together, many carry nothing.
std::string box(int n) {
    const double h = std::sqrt(3.0), width = 2 * n + 1, top = 2 + h * (n - 1);
    std::string parts = block("floor", -1, -1, width + 1, 0) + ", " + block("left", -1, 0, 0, top) + ", " +
                        block("right", width, 0, width + 1, top) + ", " + block("lid", 0.01, top, width - 0.01, top + 1);
    for (int row = 0; row < n; ++row)
        for (int k = 0; k < n; ++k)
            parts += ", " + disc("d" + std::to_string(row) + "_" + std::to_string(k), 1 + 2 * k + row % 2, 1 + h * row);
    return scene(parts, R"({"on": ["floor/bottom", "left/left", "right/right"], "fix": ["x", "y"]})",
                 R"({"part": "lid", "force": [0, -400]})", "draft");
}

TEST(ManyContacts, EveryDiscOfAPackingIsInBalance) {
    const Result r = test::answer(box(4));
    ASSERT_EQ(r.status, "ok") << r.message;
    EXPECT_TRUE(r.solver.converged);
    EXPECT_LT(r.equilibrium.relative_residual, 1e-9);
    std::map<std::string, Vec2> sum;
    double on_lid = 0;
    for (const ContactResult& c : r.contacts) {
        for (std::size_t side : {0U, 1U}) sum.emplace(c.parts[side], Vec2(0, 0));
        sum[c.parts[0]] += c.force;
        sum[c.parts[1]] -= c.force;
    }
    for (const auto& [name, force] : sum) {
        if (name == "lid") on_lid = force.y();
        if (name[0] == 'd') { EXPECT_LT(force.norm(), 1e-9 * 400) << name; }
    }
    EXPECT_NEAR(on_lid, 400, 1e-9 * 400);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

/// Rigid discs that fill the box have nowhere to go where the lid is moved down: an end that names two of them.
TEST(ManyContacts, AJammedPackingOfRigidDiscsNamesWhatIsPushedTogether) {
    const std::string moved = replaced(box(3), "[0, null]", "[0, -0.01]"),
                      rigid = replaced(moved, R"("m", "geometry": {"circle")", R"("rigid", "geometry": {"circle")");
    const Result r = test::answer(rigid);
    EXPECT_EQ(r.status, "failed");
    EXPECT_NE(r.message.find("the rigid parts d"), std::string::npos) << r.message;
    EXPECT_NE(r.message.find("are pushed into each other by"), std::string::npos) << r.message;
    const Result elastic = test::answer(moved);
    EXPECT_EQ(elastic.status, "ok") << elastic.message;
    EXPECT_LT(elastic.equilibrium.relative_residual, 1e-9);
}

}  // namespace
}  // namespace abut::many_contacts_test
