// SPDX-License-Identifier: GPL-3.0-or-later
// Energies and displacements of parts whose stress has no limit somewhere, or jumps: the stated error against grids of 0.002
// there.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include "src/analysis/analysis.hpp"
#include "src/scene/read_scene.hpp"
#include "src/scene/scene.hpp"

namespace abut::singular_test {
namespace {

struct Shape {
    std::vector<Vec2> corners;
    std::size_t held, pulled;
    Vec2 force;
    std::vector<Vec2> singular;
};

const Shape l_shape{
    {{-10, -10}, {30, -10}, {30, 0}, {0, 0}, {0, 30}, {-10, 30}}, 1, 4, {-1000, 0}, {{0, 0}, {30, -10}, {30, 0}}};
const Shape half_held{{{-10, 0}, {0, 0}, {10, 0}, {10, 10}, {-10, 10}}, 0, 2, {500, 1000}, {{0, 0}, {-10, 0}}};
const Shape notched{{{-20, -10}, {20, -10}, {20, 5}, {2, 5}, {0, 0}, {-2, 5}, {-20, 5}}, 6, 1, {1000, 0}, {{0, 0}}};
const Shape pressed{{{-20, -15}, {20, -15}, {20, 0}, {7.1, 0}, {-6.3, 0}, {-20, 0}}, 0, 3, {0, -1000}, {{7.1, 0}, {-6.3, 0}}};

Vec2 turned(const Vec2& p, double degrees) {
    const double a = degrees * std::numbers::pi / 180;
    return {std::cos(a) * p.x() - std::sin(a) * p.y(), std::sin(a) * p.x() + std::cos(a) * p.y()};
}

std::string text_of(const Vec2& p) {
    std::ostringstream text;
    text.precision(17);
    text << "[" << p.x() << ", " << p.y() << "]";
    return text.str();
}

Result solved(const Shape& shape, double degrees, double cell, bool is_fine = false) {
    std::ostringstream text;
    text << R"({"abut": 1, "analysis": "plane_strain", "materials": {"m": {"E": 1e5, "nu": 0.3}},
        "parts": [{"name": "b", "material": "m", "geometry": {"polygon": [)";
    for (std::size_t i = 0; i < shape.corners.size(); ++i)
        text << (i > 0 ? ", " : "") << text_of(turned(shape.corners[i], degrees));
    text << R"(]}}], "supports": [{"fix": ["x", "y"], "on": "b/e)" << shape.held << R"("}], "loads": [{"on": "b/e)"
         << shape.pulled << R"(", "force": )" << text_of(turned(shape.force, degrees)) << R"(}], "accuracy": {"cell_size": )"
         << cell << R"(, "adapt": false, "refine": [)";
    bool is_first = true;
    for (const Vec2& p : is_fine ? shape.singular : std::vector<Vec2>())
        for (const auto& [radius, size] : {std::pair(0.5, 0.1), std::pair(0.1, 0.01), std::pair(0.02, 0.002)}) {
            text << (is_first ? "" : ", ") << R"({"near": )" << text_of(turned(p, degrees)) << R"(, "radius": )" << radius
                 << R"(, "cell_size": )" << size << "}";
            is_first = false;
        }
    text << "]}}";
    Result result = analyze(read_scene_text(text.str(), "scene.json"), {});
    EXPECT_EQ(result.status, "ok") << result.message;
    return result;
}

class Singular : public testing::TestWithParam<Shape> {};

TEST_P(Singular, StatedErrorsOfTheEnergyAreOfTheTrueOnesSize) {
    const double truth = solved(GetParam(), 0, 0.5, true).strain_energy;
    for (double degrees : {0.0, 30.0, 45.0})
        for (double cell : {2.0, 1.0}) {
            const Result result = solved(GetParam(), degrees, cell);
            const double error = 1 - result.strain_energy / truth;
            EXPECT_GT(*result.error_estimate.energy, 0.3 * error) << degrees << " degrees, cells of " << cell << ": " << error;
            EXPECT_LT(*result.error_estimate.energy, 4 * error) << degrees << " degrees, cells of " << cell << ": " << error;
        }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Singular, testing::Values(l_shape, half_held, notched, pressed));

/// Three discs in a box whose walls stand free: pressures reach their target long before the walls' feet are resolved.
std::string discs_in_box(double degrees) {
    std::ostringstream text;
    const auto part = [&](const char* name, const Vec2& center, double radius) {
        text << R"(, {"name": ")" << name << R"(", "material": "m", "geometry": {"circle": {"center": )"
             << text_of(turned(center, degrees)) << R"(, "radius": )" << radius << "}}}";
    };
    text << R"({"abut": 1, "analysis": "plane_strain", "materials": {"m": {"E": 1e5, "nu": 0.3}},
        "supports": [{"fix": ["x", "y"], "on": "box/e0"}], "loads": [{"part": "top", "force": )"
         << text_of(turned({0, -5000}, degrees))
         << R"(}], "parts": [{"name": "box", "material": "m", "geometry": {"polygon": [)";
    const char* separator = "";
    for (const Vec2& p :
         {Vec2(-10, -10), Vec2(58, -10), Vec2(58, 30), Vec2(48, 30), Vec2(48, 0), Vec2(0, 0), Vec2(0, 30), Vec2(-10, 30)}) {
        text << separator << text_of(turned(p, degrees));
        separator = ", ";
    }
    text << "]}}";
    part("left", {11, 11}, 11);
    part("right", {37, 11}, 11);
    part("top", {24, 11 + std::sqrt(22.0 * 22 - 13 * 13)}, 11);
    text << "]}";
    return text.str();
}

TEST(Singular, WallsOfABoxBendAlikeHoweverItIsTurned) {
    const Result drawn = analyze(read_scene_text(discs_in_box(0), "scene.json"), {});
    const Result turned = analyze(read_scene_text(discs_in_box(30), "scene.json"), {});
    ASSERT_EQ(drawn.status, "ok") << drawn.message;
    ASSERT_EQ(turned.status, "ok") << turned.message;
    const double stated = *drawn.error_estimate.energy + *turned.error_estimate.energy;
    EXPECT_LT(stated, 0.04);
    EXPECT_NEAR(drawn.strain_energy / turned.strain_energy, 1, stated);
    for (std::size_t i = 0; i < drawn.parts.size(); ++i) {
        const PartResult &a = drawn.parts[i], &b = turned.parts[i];
        EXPECT_NEAR(a.max_displacement.value / b.max_displacement.value, 1,
                    *a.max_displacement_error + *b.max_displacement_error)
            << a.name;
    }
}

/// Two warm strips, bonded to each other and clamped together at one end.
Result bimetal(const std::string& accuracy) {
    const std::string text = R"({"abut": 1, "analysis": "plane_stress", "thickness": 10, "materials": {
        "alu": {"E": 70000, "nu": 0.33, "expansion": 2.3e-05}, "steel": {"E": 210000, "nu": 0.3, "expansion": 1.2e-05}}, "parts": [
        {"name": "s1", "material": "alu", "geometry": {"rectangle": {"min": [0, 0], "max": [60, 2]}, "name": "r"}},
        {"name": "s2", "material": "steel", "geometry": {"rectangle": {"min": [0, 2], "max": [60, 4]}, "name": "r"}}],
        "supports": [{"on": ["s1/r/left", "s2/r/left"], "fix": ["x", "y"]}],
        "loads": [{"part": "s1", "temperature": 90}, {"part": "s2", "temperature": 60}],
        "contacts": {"pairs": [{"between": ["s1/r/top", "s2/r/bottom"], "kind": "bonded"}]}, "accuracy": {)" +
                             accuracy + "}}";
    return analyze(read_scene_text(text, "scene.json"), {});
}

/// Cells at the ends of a bond stay as small as they have to be, from grid to grid: uniform cells of 0.125 and 0.0625 give
/// 19.775 and 19.770.
TEST(Singular, EndsOfBondsKeepTheirCells) {
    const Result finest = bimetal(R"("target": 3e-4)");
    ASSERT_EQ(finest.status, "ok") << finest.message;
    EXPECT_NEAR(finest.strain_energy, 19.767, 0.003);
    const int last = finest.passes.back().unknowns;
    EXPECT_GT(last, finest.passes.at(1).unknowns);
    const Vec2 force = finest.contacts.at(0).force;
    for (const char* level : {"draft", "standard", "fine"}) {
        const Result r = bimetal(R"("level": ")" + std::string(level) + R"(")");
        ASSERT_EQ(r.status, "ok") << r.message;
        const ContactResult& bond = r.contacts.at(0);
        EXPECT_LT((bond.force - force).norm(), 1.5 * bond.errors.value().force * force.norm()) << level;
    }
}

}  // namespace
}  // namespace abut::singular_test
