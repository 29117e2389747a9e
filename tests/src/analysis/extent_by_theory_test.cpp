// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/extent_by_theory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "src/analysis/adaptive.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/src/io/temporary_folder.hpp"
#include "tests/verification/scene_answers.hpp"
#include "tests/verification/true_errors.hpp"

namespace abut::extent_by_theory_test {
namespace {

/// Solved once, on uniform cells.
Outcome on_cells(Scene scene, double cell_size) {
    scene.accuracy.cell_size = cell_size;
    Stopwatches seconds;
    return solve_adaptively(scene, resolve_conditions(scene), {}, seconds);
}

/// A disc of radius 1 about x = 0.37, pressed down on a plate of that thickness.
Scene disc_on(double thickness, double force) {
    const TemporaryFolder folder;
    return read_scene(folder.write("scene.json", R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3}}, "parts": [
        {"name": "disc", "material": "m", "geometry": {"circle": {"center": [0.37, 1], "radius": 1}}},
        {"name": "plate", "material": "m", "geometry": {"rectangle": {"min": [-2, "-t"], "max": [2, 0]}}}],
        "parameters": {"t": 1, "P": 1},
        "supports": [{"on": "plate/bottom", "fix": ["x", "y"]}, {"part": "disc", "rigid": {"translation": [0, null], "rotation": 0}}],
        "loads": [{"part": "disc", "force": [0, "-P"]}]})"),
                      {{"t", thickness}, {"P", force}});
}

}  // namespace

TEST(ExtentByTheory, OfHalfACylinderInOneCell) {
    const Scene scene = test::adaptive_scene({"verification/hertz_001.json"});
    for (double cell_size : {0.02, 0.05, 0.1, 0.25}) {
        SCOPED_TRACE(cell_size);
        const Outcome out = on_cells(scene, cell_size);
        ASSERT_EQ(out.solved.stretches[0].size(), 1u);
        const PressedStretch found = out.solved.stretches[0][0], moved = contacts_by_theory(scene, out.solved).stretches[0][0];
        EXPECT_GT(found.end, 1.2 * 0.01);
        EXPECT_NEAR(moved.end, 0.01, 2e-4);
        EXPECT_EQ(moved.begin, found.begin);
    }
}

TEST(ExtentByTheory, PressureOfHalfACylinderIsHertz) {
    const Scene scene = test::adaptive_scene({"verification/hertz_001.json"});
    const Outcome out = on_cells(scene, 0.1);
    const TheoryOfContacts theory = contacts_by_theory(scene, out.solved);
    EXPECT_TRUE(theory.is_close);
    ASSERT_TRUE(theory.pressure[0]);
    ASSERT_EQ(theory.pressure[0]->stretches.size(), 1u);
    const PlaneStretch& stretch = theory.pressure[0]->stretches[0];
    // the pressure on these cells reaches ten times as far, to where normals lean by 0.1: half a per cent of the force
    for (double u : {0.0, 0.5, 0.9})
        EXPECT_NEAR(pressure_at(stretch, stretch.middle + 0.01 * u), 500 * std::sqrt(1 - u * u), 0.005 * 500) << u;
    // another solution is as far from it as it is from Hertz
    const Outcome finer = test::solved_to(scene, 0.01);
    const PressureChange away = change_from(finer.passes.back().contacts[0], *theory.pressure[0]);
    EXPECT_LT(away.inside, 0.01 * away.norm);
    EXPECT_NEAR(away.peak_before, 500, 1);
}

/// On fine cells, too, and where the first solution had another force: half the load, and the pressure by theory is that of the
/// whole one again.
TEST(ExtentByTheory, PressuresAreRenewedByForcesOfTheLastSolution) {
    const Scene half = test::adaptive_scene({"verification/hertz_001.json", {{"P", 0.5 * 3.92699081698724}}});
    const Scene whole = test::adaptive_scene({"verification/hertz_001.json"});
    TheoryOfContacts theory = contacts_by_theory(half, on_cells(half, 0.1).solved);
    ASSERT_TRUE(theory.pressure[0]);
    const Outcome out = test::solved_to(whole, 0.01);
    const PassRecord& last = out.passes.back();
    const PressureChange stale = change_from(last.contacts[0], *theory.pressure[0]);
    EXPECT_GT(stale.inside, 0.2 * stale.norm);
    renew_pressures(whole, out.solved, theory);
    ASSERT_TRUE(theory.pressure[0]);
    const PressureChange away = change_from(last.contacts[0], *theory.pressure[0]);
    EXPECT_LT(away.inside, 0.01 * away.norm);
    EXPECT_NEAR(away.peak_before, 500, 1);
}

/// A layer as thick as the contact is wide presses otherwise than a half plane.
TEST(ExtentByTheory, HasNoPressureOfThinParts) {
    const Scene scene = disc_on(0.05, 10);
    const Outcome out = on_cells(scene, 0.1);
    ASSERT_FALSE(out.solved.stretches[0].empty());
    const TheoryOfContacts theory = contacts_by_theory(scene, out.solved);
    EXPECT_FALSE(theory.is_close);
    EXPECT_FALSE(theory.pressure[0]);
}

TEST(ExtentByTheory, OfACylinderOnAPlaneInPlaneStrain) {
    const Scene scene = test::adaptive_scene({"verification/cylinder_on_plane.json", {{"Q", 5}}, Analysis::plane_strain});
    const Outcome out = on_cells(scene, 0.1);
    // a^2 = 4 P R / (pi E*)
    const double a = std::sqrt(4 * 5 / (std::numbers::pi * 1e5 / (2 * (1 - 0.3 * 0.3))));
    EXPECT_NEAR(contacts_by_theory(scene, out.solved).stretches[0][0].end, a, 0.02 * a);
}

TEST(ExtentByTheory, OfAWedge) {
    const Scene scene = test::adaptive_scene({"verification/wedge.json"});
    const Outcome out = on_cells(scene, 0.1);
    EXPECT_NEAR(contacts_by_theory(scene, out.solved).stretches[0][0].end, 0.02, 0.02 * 0.02);
}

/// A hundredth of the flat's half width beyond it: the load of Ciavarella, Hills and Monno's closed form.
TEST(ExtentByTheory, OfAFlatWithFillets) {
    const double b = 0.02, R = 1, a = 1.01 * b, t = std::asin(b / a), sine = std::sin(t);
    const double load = 1e5 / (1 + 1e-4) * b * b / (2 * R) * ((std::numbers::pi - 2 * t) / (2 * sine * sine) - 1 / std::tan(t));
    const Scene scene = test::adaptive_scene({"verification/filleted_punch.json", {{"R", R}, {"P", load}}});
    const Outcome out = on_cells(scene, 0.005);
    const PressedStretch found = out.solved.stretches[0][0], moved = contacts_by_theory(scene, out.solved).stretches[0][0];
    EXPECT_GT(std::abs(found.end - a), 0.5 * (a - b));
    EXPECT_NEAR(moved.end, a, 0.05 * (a - b));
    EXPECT_EQ(moved.begin, found.begin);
}

/// A part of thickness 3 on one of thickness 1 is three times as stiff; 1/E* = (1 + 1/3) / E'.
TEST(ExtentByTheory, OfPartsOfUnequalThickness) {
    Scene scene = test::adaptive_scene({"verification/cylinder_on_plane.json", {{"Q", 5}}});
    scene.parts[0].thickness = 3;  // the load is a pressure: three times the force
    const Outcome out = on_cells(scene, 0.1);
    const double a = std::sqrt(4 * 3 * 5 / (std::numbers::pi * 1e5 / (1 + 1.0 / 3)));
    EXPECT_NEAR(contacts_by_theory(scene, out.solved).stretches[0][0].end, a, 0.02 * a);
}

/// Cells of the whole cylinder stand unevenly about the line of contact: the middle is where the gap is lowest.
TEST(ExtentByTheory, AboutTheLowestPlace) {
    const Scene scene = disc_on(2, 0.01);
    const Outcome out = on_cells(scene, 0.23);
    const double a = std::sqrt(4 * 0.01 / (std::numbers::pi * 0.5e5));
    const PressedStretch moved = contacts_by_theory(scene, out.solved).stretches[0][0];
    EXPECT_NEAR(moved.end - moved.begin, 2 * a, 0.02 * a);
    const Vec2 begin = pair_at(scene, out.solved.contacts[0], moved.begin).on1.x;
    const Vec2 end = pair_at(scene, out.solved.contacts[0], moved.end).on1.x;
    EXPECT_NEAR(0.5 * (begin.x() + end.x()), 0.37, 0.02 * a);
}

TEST(ExtentByTheory, LeavesWhatItDoesNotApplyTo) {
    // a contact of many cells; one of flat faces
    const test::EstimateCase wide{"verification/cylinder_on_plane.json", {{"Q", 5000}}}, flat{"scenes/vise.json"};
    for (const auto& [source, cell_size] : {std::pair{wide, 0.04}, {flat, 0.3}}) {
        SCOPED_TRACE(source.scene);
        const Scene scene = test::adaptive_scene(source);
        const Outcome out = on_cells(scene, cell_size);
        ASSERT_FALSE(out.solved.stretches[0].empty());
        const auto moved = contacts_by_theory(scene, out.solved).stretches;
        for (std::size_t k = 0; k < moved.size(); ++k)
            for (std::size_t r = 0; r < moved[k].size(); ++r) {
                EXPECT_EQ(moved[k][r].begin, out.solved.stretches[k][r].begin);
                EXPECT_EQ(moved[k][r].end, out.solved.stretches[k][r].end);
            }
    }
}

/// Fillets of a thousandth of a punch: the first solution has it pressed as far as the fillets are looked at. Turned as drawn.
TEST(ExtentByTheory, FilletsBelowTheFirstCellsAreSeen) {
    const auto peak = [](double degrees) {
        const double a = degrees * std::numbers::pi / 180;
        const std::string place = R"(, "place": {"rotate": )" + test::number(degrees) + "}}";
        const Result r =
            test::answer(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "thickness": 10, "parts": [
            {"name": "base", "material": "m", "geometry": {"rectangle": {"min": [-40, -20], "max": [40, 0]}})" +
                         place + R"(, {"name": "punch", "material": "m", "geometry": {"union": [
                {"polygon": [[-9.98, 0], [9.98, 0], [9.98, 15], [-9.98, 15]]},
                {"polygon": [[-10, 0.02], [10, 0.02], [10, 15], [-10, 15]]},
                {"circle": {"center": [-9.98, 0.02], "radius": 0.02}}, {"circle": {"center": [9.98, 0.02], "radius": 0.02}}]})" +
                         place + R"(], "supports": [{"on": "base/bottom", "fix": ["x", "y"]}],
            "loads": [{"part": "punch", "force": )" +
                         test::pair_text(8000 * std::sin(a), -8000 * std::cos(a)) + R"(}], "accuracy": {"level": "draft"}})");
        EXPECT_EQ(r.status, "ok") << r.message;
        return r.contacts.at(0).max_pressure.value;
    };
    const double drawn = peak(0);
    EXPECT_GT(drawn, 1000);
    for (double degrees : {8.0, 13.0, 17.0, 61.0, 83.0}) EXPECT_NEAR(peak(degrees), drawn, 0.05 * drawn) << degrees;
}

}  // namespace abut::extent_by_theory_test
