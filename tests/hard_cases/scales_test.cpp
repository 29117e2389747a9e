// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes whose lengths, stiffnesses or details are far apart: right to the method's error, or refined with a note; never a
// crash, never silent nonsense.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "src/analysis/analysis.hpp"
#include "tests/hard_cases/part_problem.hpp"
#include "tests/hard_cases/shapes.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::test::scales_test {
namespace {

/// A plate with a hole, held on its left, pulled on its right, whose grid is turned so that supports are Nitsche's.
Result scaled_plate(double length, double E, const Vec2& offset) {
    const auto at = [&](double x, double y) { return pair_text(length * (x + offset.x()), length * (y + offset.y())); };
    return answer(R"({"abut": 1, "materials": {"m": {"E": )" + number(E) + R"(, "nu": 0.3}},
        "parts": [{"name": "a", "material": "m", "geometry": {"difference": [{"rectangle": {"min": )" +
                  at(0, 0) + R"(, "max": )" + at(2, 1) + R"(}}, {"circle": {"center": )" + at(0.8, 0.45) + R"(, "radius": )" +
                  number(0.2 * length) + R"(}}]}}],
        "supports": [{"on": "a/left", "fix": ["x", "y"]}],
        "loads": [{"on": "a/right", "traction": [)" +
                  number(1e-3 * E) + "," + number(-3e-4 * E) + R"(]}],
        "accuracy": {"grids": {"a": {"cells": [19, 13], "angle": 12}}},
        "output": {"probes": [{"part": "a", "at": )" +
                  at(2, 1) + R"(}, {"part": "a", "at": )" + at(0.8, 0.66) + R"(}, {"part": "a", "at": )" + at(1.999, 0.001) +
                  "}]}}");
}

/// Largest difference of displacements over length and of stresses over E.
double difference(const Result& a, double length, double E, const Result& reference) {
    double worst = 0, u = 0, s = 0;
    for (std::size_t k = 0; k < reference.probes.size(); ++k) {
        const ProbeResult &p = a.probes.at(k), &q = reference.probes[k];
        u = std::max(u, q.displacement.norm());
        s = std::max(s, std::abs(q.stress.xx));
        worst = std::max(
            {worst, (p.displacement / length - q.displacement).norm() / u, std::abs(p.stress.xx / E - q.stress.xx) / s});
    }
    return worst;
}

TEST(Scales, UnitsAndStiffnessDoNotMatter) {
    constexpr double rounding = 1e-9;
    const Result reference = scaled_plate(1, 1, {0, 0});
    ASSERT_EQ(reference.status, "ok") << reference.message;
    EXPECT_GT(difference(reference, 1, 1.01, reference), rounding);  // a difference shows
    for (double length : {1e-3, 1.0, 1e3})
        for (double E : {1e-3, 1.0, 2.1e5, 1e12}) {
            const Result r = scaled_plate(length, E, {0, 0});
            ASSERT_EQ(r.status, "ok") << r.message;
            EXPECT_LT(difference(r, length, E, reference), rounding) << length << " " << E;
        }
}

TEST(Scales, PartsMayLieFarFromTheOrigin) {
    const Result reference = scaled_plate(1, 1, {0, 0});
    for (double offset : {1e3, 1e6}) {
        const Result r = scaled_plate(1, 1, {offset, -0.7 * offset});
        ASSERT_EQ(r.status, "ok") << r.message;
        // the coordinates' own rounding, as strain of a cell
        EXPECT_LT(difference(r, 1, 1, reference), 1e-13 * offset * 100) << offset;
    }
}

/// A cantilever of 1 x 1000 under a shear force at its end.
Result long_beam(int degree) {
    return answer(R"({"abut": 1, "materials": {"m": {"E": 1e9, "nu": 0.3}},
        "parts": [{"name": "a", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [1000, 1]}}}],
        "supports": [{"on": "a/left", "fix": ["x", "y"]}], "loads": [{"on": "a/right", "force": [0, -1]}],
        "accuracy": {"degree": )" +
                  std::to_string(degree) + R"(},
        "output": {"probes": [{"part": "a", "at": [1000, 0.5]}]}})");
}

/// Against the beam's deflection 4 F L^3 / E h^3. Default grids have 30 cells along whatever their shape: at degree 2 the
/// answer is 16 % too stiff, without a note; on record.
TEST(Scales, AspectRatioOfAThousand) {
    constexpr double beam = 4;
    const Result quadratic = long_beam(2), cubic = long_beam(3);
    ASSERT_EQ(cubic.status, "ok") << cubic.message;
    ASSERT_EQ(quadratic.status, "ok") << quadratic.message;
    RecordProperty("degree_2", number(-quadratic.probes.at(0).displacement.y() / beam));
    EXPECT_NEAR(-cubic.probes.at(0).displacement.y() / beam, 1, 1e-3);
}

Result slit_u(const std::string& accuracy, double slot) {
    const double a = 1 - slot / 2, b = 1 + slot / 2;
    return answer(
        R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}}, "parts": [{"name": "u", "material": "m", "geometry": {"polygon": [[0, 0], [2, 0], [2, 5], )" +
        pair_text(b, 5) + "," + pair_text(b, 1) + "," + pair_text(a, 1) + "," + pair_text(a, 5) + R"(, [0, 5]]}}],
        "supports": [{"on": "u/e0", "fix": ["x", "y"]}],
        "loads": [{"on": "u/e1", "pressure": -0.1}, {"on": "u/e7", "pressure": -0.1}],
        "accuracy": )" +
        accuracy + R"(,
        "output": {"probes": [{"part": "u", "at": [2, 5]}, {"part": "u", "at": [0, 5]}]}})");
}

/// The arms of a U beside a slot of a thousandth of a cell: pulled apart they bend one by one. What is off comes from the
/// slot's root: a function whose support reaches round it is not taken apart, so that the slot ends up to p/4 of a cell early,
/// an error of order h. At the given cells of 0.25 the arms are 11 % (degree 2) and 17 % (degree 3) too stiff.
TEST(Scales, SlotOfAThousandthOfACell) {
    constexpr double slot = 2.5e-4;
    const auto opening = [&](const std::string& accuracy) {
        const Result r = slit_u(accuracy, slot);
        EXPECT_EQ(r.status, "ok") << r.message;
        const double right = r.probes.at(0).displacement.x(), left = -r.probes.at(1).displacement.x();
        EXPECT_NEAR(left / right, 1, 1e-6);
        return right;
    };
    const double h1 = opening(R"({"cell_size": 0.1})"), h2 = opening(R"({"cell_size": 0.05})"), reference = 2 * h2 - h1;
    EXPECT_NEAR(opening(R"({"cell_size": 0.2})") / reference, 1, 0.1);
    EXPECT_NEAR(h1 / reference, 1, 0.05);
    EXPECT_NEAR(opening("{}") / reference, 1, 0.03);
    EXPECT_NEAR(opening(R"({"level": "fine"})") / reference, 1, 0.02);
    EXPECT_NEAR(opening(R"({"degree": 3})") / reference, 1, 0.05);
}

Result holes(double h, double gap, double radius, bool present, int degree = 2) {
    const double x = radius + gap / 2;
    std::string geometry = R"({"rectangle": {"min": [-2, -1], "max": [2, 1]}})";
    if (present)
        geometry = R"({"difference": [)" + geometry + R"(, {"circle": {"center": )" + pair_text(-x, 0.013) + R"(, "radius": )" +
                   number(radius) + R"(}}, {"circle": {"center": )" + pair_text(x, 0.013) + R"(, "radius": )" + number(radius) +
                   "}}]}";
    return answer(
        R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}}, "parts": [{"name": "a", "material": "m", "geometry": )" +
        geometry +
        R"(}], "supports": [{"on": "a/left", "symmetry": true}, {"part": "a", "rigid": {"translation": [null, 0], "rotation": null}}],
        "loads": [{"on": "a/right", "traction": [1, 0]}],
        "accuracy": {"degree": )" +
        std::to_string(degree) + R"(, "cell_size": )" + number(h) + R"(},
        "output": {"probes": [{"part": "a", "at": [2, 0.9]}, {"part": "a", "at": [1.7, 0.1]}, {"part": "a", "at": [0.05, 0.8]}]}})");
}

/// Two holes with a ligament of a thousandth of a cell between them.
TEST(Scales, HolesAThousandthOfACellApart) {
    const Result fine = holes(0.06, 2e-4, 0.4, true, 3);
    ASSERT_EQ(fine.status, "ok") << fine.message;
    for (double h : {0.2, 0.13}) {
        const Result r = holes(h, 1e-3 * h, 0.4, true);
        ASSERT_EQ(r.status, "ok") << r.message;
        for (std::size_t k = 0; k < 2; ++k) {
            EXPECT_NEAR(r.probes[k].displacement.x() / fine.probes[k].displacement.x(), 1, 0.01);
        }
    }
}

/// A hole smaller than a cell is there: the plate gives way by what the area's share asks for, and the fine grid's answer comes
/// out.
TEST(Scales, HoleSmallerThanACell) {
    const Result fine = holes(0.05, 0.5, 0.05, true, 3), without = holes(0.3, 0.5, 0.05, false);
    ASSERT_EQ(fine.status, "ok") << fine.message;
    const double effect = fine.probes.at(0).displacement.x() / without.probes.at(0).displacement.x() - 1;
    for (double h : {0.3, 0.17}) {
        const Result r = holes(h, 0.5, 0.05, true);
        ASSERT_EQ(r.status, "ok") << r.message;
        const double coarse = r.probes.at(0).displacement.x() / without.probes.at(0).displacement.x() - 1;
        EXPECT_GT(coarse, 0.1 * effect);
        EXPECT_LT(coarse, 1.1 * effect);
    }
}

std::string thin_bar(const std::string& accuracy) {
    return R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}}, "parts": [{"name": "a", "material": "m",
        "geometry": {"place": {"of": {"rectangle": {"min": [0, 0], "max": [10, 0.1]}}, "rotate": 31}}}],
        "supports": [{"on": "a/left", "fix": ["x", "y"]}], "loads": [{"on": "a/right", "traction": [0.857167, 0.515038]}],
        "output": {"probes": [{"part": "a", "at": [8.5457, 5.1930]}]})" +
           accuracy + "}";
}

/// A bar across the grid, thinner than its cells.
TEST(Scales, PartThinnerThanACell) {
    const double exact = 10 * 1.0 / 1000;  // along the bar; the clamped end takes 1e-3 of it away
    const Result free = answer(thin_bar(""));
    ASSERT_EQ(free.status, "ok") << free.message;
    EXPECT_NEAR(free.probes.at(0).displacement.norm() / exact, 1, 0.01);
    // where the scene insists on cells that are too large, it is told so
    for (double h : {0.5, 0.25, 0.11}) {
        const Result coarse = answer(thin_bar(R"(, "accuracy": {"cell_size": )" + number(h) + "}"));
        if (coarse.status == "ok")
            EXPECT_NEAR(coarse.probes.at(0).displacement.norm() / exact, 1, 0.02);
        else
            EXPECT_NE(coarse.message.find("too coarse"), std::string::npos) << coarse.message;
    }
}

/// A wedge of one degree, two cells thick at most: where its tip is thinner than cells there is either no space, and the text
/// says so, or an answer that refinement improves, in the tip, too. (Condition numbers grow with the distance over which the
/// tip is extended: 1e6 to 1e9 at degree 1, 1e12 to 1e15 at degree 4, where rounding then leaves 1e-5 of the displacement.)
TEST(Scales, WedgeOfOneDegree) {
    for (int degree = 1; degree <= 4; ++degree)
        for (const Vec2& shift : {Vec2(0.1, 0.2), Vec2(0.9, 0.7), Vec2(0.5, 1e-6)}) {
            SCOPED_TRACE("degree " + std::to_string(degree));
            PartProblem p;
            p.part = polygon({{0, 0}, {1, 0}, {1, std::tan(M_PI / 180)}});
            p.exact = plane_waves(elasticity_of(p), {{{1, 0.4}, {2.3, 1.1}, 0.4}});
            p.degree = degree;
            const auto on_cells = [&](double h) { return solve_part(p, even_grid(p, h, h * shift)); };
            EXPECT_NE(on_cells(0.1).failure.find("too coarse"), std::string::npos);
            const PartAnswer coarse = on_cells(0.02), fine = on_cells(0.005);
            ASSERT_EQ(coarse.failure + fine.failure, "");
            EXPECT_LT(coarse.largest_stress, 0.5);
            EXPECT_LT(fine.largest_stress, 0.3 * coarse.largest_stress);
            // degree 4 on the fine grid leaves nothing but rounding
            const double rounding = std::numeric_limits<double>::epsilon() * fine.condition;
            EXPECT_LT(fine.largest_displacement, std::max(0.5 * coarse.largest_displacement, rounding)) << rounding;
        }
}

/// The same through the program: its own grid, and a grid that the wedge's tip is much thinner than.
TEST(Scales, WedgeOfOneDegreeThroughTheProgram) {
    for (const std::string accuracy : {"{}", R"({"degree": 3})", R"({"cell_size": 0.3})", R"({"cell_size": 5})"}) {
        const Result r =
            answer(R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}}, "parts": [{"name": "w", "material": "m",
            "geometry": {"polygon": [[0, 0], [57.29, 0], [57.29, 1]]}}],
            "supports": [{"on": "w/e1", "fix": ["x", "y"]}], "loads": [{"on": "w/e2", "pressure": 1e-4}],
            "output": {"probes": [{"part": "w", "at": [20, 0.1]}]}, "accuracy": )" +
                   accuracy + "}");
        if (r.status == "ok") {
            // no more than the rounding that the answer itself tells of
            EXPECT_LT(r.equilibrium.relative_residual, std::numeric_limits<double>::epsilon() * r.solver.condition_estimate);
            EXPECT_TRUE(std::isfinite(r.probes.at(0).stress.xx));
        } else {
            EXPECT_NE(r.message.find("part w"), std::string::npos) << r.message;
        }
    }
}

}  // namespace
}  // namespace abut::test::scales_test
