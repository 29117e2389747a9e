// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of the largest displacements: of parts that lift off they go by where contacts end, elsewhere by the cells there.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/verification/scene_answers.hpp"

namespace abut::displacement_errors_test {
namespace {

/// A beam that a cylinder presses on a soft pad on a table: both lift off at their ends. copies: of it, side by side.
Result on_pad(int copies, const std::string& level) {
    std::string parts, supports, loads;
    const auto rectangle = [](double x0, double y0, double x1, double y1) {
        return R"("geometry": {"rectangle": {"min": )" + test::pair_text(x0, y0) + R"(, "max": )" + test::pair_text(x1, y1) +
               "}}}";
    };
    for (int k = 0; k < copies; ++k) {
        const std::string n = std::to_string(k), comma = k > 0 ? ", " : "";
        const double x = 200 * k;
        parts += comma + R"({"name": "table)" + n + R"(", "material": "steel", )" + rectangle(x - 60, -20, x + 60, 0) +
                 R"(, {"name": "pad)" + n + R"(", "material": "soft", )" + rectangle(x - 40, 0, x + 40, 1) +
                 R"(, {"name": "beam)" + n + R"(", "material": "steel", )" + rectangle(x - 30, 1, x + 30, 5) +
                 R"(, {"name": "roller)" + n + R"(", "material": "steel", "geometry": {"circle": {"center": )" +
                 test::pair_text(x + 3, 11) + R"(, "radius": 6}}})";
        supports += comma + R"({"on": "table)" + n + R"(/bottom", "fix": ["x", "y"]}, {"part": "roller)" + n +
                    R"(", "rigid": {"translation": [0, null], "rotation": 0}})";
        loads += comma + R"({"part": "roller)" + n + R"(", "force": [0, -300]})";
    }
    return test::answer(R"({"abut": 1, "materials": {"steel": {"E": 210000, "nu": 0.3}, "soft": {"E": 3000, "nu": 0.38}},
        "parts": [)" + parts +
                        R"(], "supports": [)" + supports + R"(], "loads": [)" + loads + R"(], "accuracy": {"level": ")" +
                        level + R"("}})");
}

}  // namespace

TEST(DisplacementErrors, AreNotStatedTooLowWherePartsLiftOff) {
    const Result r = on_pad(1, "draft"), finer = on_pad(1, "fine");
    ASSERT_EQ(r.status, "ok") << r.message;
    ASSERT_EQ(finer.status, "ok") << finer.message;
    for (std::size_t k = 0; k < r.parts.size(); ++k) {
        const double truth = finer.parts[k].max_displacement.value;
        ASSERT_TRUE(r.parts[k].max_displacement_error && finer.parts[k].max_displacement_error);
        EXPECT_LE(std::abs(r.parts[k].max_displacement.value / truth - 1),
                  2 * *r.parts[k].max_displacement_error + *finer.parts[k].max_displacement_error)
            << r.parts[k].name;
    }
}

/// A quarter of a hollow cylinder under pressure inside, in plane strain, or of a hollow sphere.
PartResult pressed_from_inside(double radius, double outer, bool is_sphere, const std::string& level) {
    const auto circle = [](double r) { return R"({"circle": {"center": [0, 0], "radius": )" + test::number(r) + "}}"; };
    const std::string kind = is_sphere ? "axisymmetric" : "plane_strain",
                      left = is_sphere ? "" : R"(, {"on": "s/left", "symmetry": true})";
    const Result r = test::answer(R"({"abut": 1, "analysis": ")" + kind + R"(", "materials": {"m": {"E": 1e5, "nu": 0.3}},
        "parts": [{"name": "s", "material": "m", "geometry": {"difference": [{"intersection": [)" +
                                  circle(outer) + R"(, {"rectangle": {"min": [0, 0], "max": [11, 11]}}]}, {"name": "hole", )" +
                                  circle(radius).substr(1) + R"(]}}],
        "supports": [{"on": "s/bottom", "symmetry": true})" +
                                  left + R"(], "loads": [{"on": "s/hole/circle", "pressure": 10}], "accuracy": {"level": ")" +
                                  level + R"("}})");
    EXPECT_EQ(r.status, "ok") << r.message;
    return r.parts.at(0);
}

/// Lame's solutions, the largest displacement at the inner radius.
TEST(DisplacementErrors, AreNotStatedTooLowOfSmoothStresses) {
    constexpr double outer = 10, E = 1e5, nu = 0.3, pressure = 10;
    for (const double a : {1.0, 2.0, 5.0, 9.0})
        for (const bool is_sphere : {true, false})
            for (const char* level : {"draft", "standard"}) {
                const double n = is_sphere ? 3 : 2, ratio = std::pow(outer / a, n);
                const double truth = pressure * a / (E * (ratio - 1)) *
                                     (is_sphere ? 1 - 2 * nu + 0.5 * (1 + nu) * ratio : (1 + nu) * (1 - 2 * nu + ratio));
                const PartResult r = pressed_from_inside(a, outer, is_sphere, level);
                ASSERT_TRUE(r.max_displacement_error);
                const double error = std::abs(r.max_displacement.value / truth - 1);
                EXPECT_LE(error, 1.2 * *r.max_displacement_error) << a << " " << is_sphere << " " << level;
                EXPECT_LE(*r.max_displacement_error, 10 * error + 1e-4) << a << " " << is_sphere << " " << level;
            }
}

TEST(DisplacementErrors, AreThoseOfEachAssemblyWhereSeveralStandSideBySide) {
    const Result one = on_pad(1, "draft"), two = on_pad(2, "draft");
    ASSERT_EQ(two.status, "ok") << two.message;
    ASSERT_EQ(two.solver.groups, 2);
    for (std::size_t k = 0; k < two.parts.size(); ++k) {
        const PartResult& alone = one.parts[k % one.parts.size()];
        EXPECT_NEAR(*two.parts[k].max_displacement_error, *alone.max_displacement_error, 0.01 * *alone.max_displacement_error)
            << two.parts[k].name;
    }
}

/// A bar held by friction all along (nu = 0, pressure by a prescribed closing) is pulled at its end and let go. It slips back
/// on half the length, and half of its displacement stays: without a load, so that no energy knows of it.
TEST(DisplacementErrors, KnowOfWhatFrictionKeeps) {
    const std::vector<Result> steps = test::answer_of_cases(R"({"abut": 1, "materials": {"S": {"E": 210000, "nu": 0}},
        "parts": [{"name": "bar", "material": "S", "geometry": {"rectangle": {"min": [0, 0], "max": [100, 1]}}},
                  {"name": "base", "material": "rigid", "geometry": {"rectangle": {"min": [-10, -10], "max": [110, 0]}}}],
        "supports": [{"part": "base", "rigid": {"translation": [0, 0], "rotation": 0}},
                     {"on": "bar/top", "displacement": {"y": -2.380952380952381e-05}}],
        "loads": [{"name": "P", "on": "bar/right", "force": [60, 0]}], "contacts": {"friction": 0.3},
        "steps": [{"name": "clamp", "loads": {"P": 0}}, {"name": "pull", "loads": {"P": 1}},
                  {"name": "release", "loads": {"P": 0}}]})");
    ASSERT_EQ(steps.size(), 3u);
    ASSERT_EQ(steps.back().status, "ok") << steps.back().message;
    const PartResult &pulled = steps[1].parts.front(), &released = steps[2].parts.front();
    const double truth = pulled.max_displacement.value / 2, error = std::abs(released.max_displacement.value / truth - 1);
    EXPECT_LE(error, *released.max_displacement_error + *pulled.max_displacement_error);
    EXPECT_LE(*released.max_displacement_error, 0.05);
}

}  // namespace abut::displacement_errors_test
