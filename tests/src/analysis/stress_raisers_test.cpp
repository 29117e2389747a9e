// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/stress_raisers.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/analysis/adaptive.hpp"
#include "src/analysis/analysis.hpp"
#include "src/analysis/error_estimate.hpp"
#include "src/analysis/stress_error.hpp"
#include "src/plan/plan.hpp"
#include "src/scene/read_scene.hpp"
#include "src/scene/selection.hpp"

namespace abut::stress_raisers_test {
namespace {

/// One part under a load, on its first grids.
Scene loaded(const std::string& polygon, const std::string& held, const std::string& pulled) {
    return read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}},
        "parts": [{"name": "p", "material": "m", "geometry": {"polygon": )" +
                               polygon + R"(}}], "supports": [{"on": "p/)" + held +
                               R"(", "symmetry": true}, {"part": "p", "rigid": {"translation": [null, 0], "rotation": null}}],
        "loads": [{"on": "p/)" +
                               pulled + R"(", "pressure": -1}]})",
                           "test.json");
}

Outcome on_first_grids(const Scene& scene) {
    Stopwatches seconds;
    Scene one = scene;
    one.accuracy.adapt = false;
    return solve_adaptively(one, resolve_conditions(one), {}, seconds);
}

}  // namespace

TEST(StressRaisers, AReentrantCornerIsRefined) {
    const Scene scene = loaded("[[0, 0], [10, 0], [10, 4], [4, 4], [4, 10], [0, 10]]", "e5", "e1");
    const Outcome out = on_first_grids(scene);
    WantedSizes wanted(1);
    ASSERT_TRUE(add_stress_raisers(out.solved, out.stress, wanted));
    ASSERT_FALSE(wanted[0].empty());
    double nearest = 1e9, before = 0;
    for (const WantedSize& w : wanted[0]) nearest = std::min(nearest, (w.points[0] - Vec2(4, 4)).norm());
    const solver::SplineSpace& space = out.solved.grids[0].input.space;
    for (std::size_t i = 0; i + 1 < space.x.breakpoints.size(); ++i)
        before = std::max(before, space.x.breakpoints[i + 1] - space.x.breakpoints[i]);
    EXPECT_LT(nearest, before);
    for (const WantedSize& w : wanted[0]) EXPECT_LE(w.size, 0.5 * before);
}

TEST(StressRaisers, AUniformStressHasNone) {
    const Outcome out = on_first_grids(loaded("[[0, 0], [10, 0], [10, 4], [0, 4]]", "e3", "e1"));
    const std::vector<double> errors =
        element_errors(out.solved.grids[0].input, out.solved.solution.displacement[0], out.stress[0]);
    for (double e : errors) EXPECT_LT(e, 1e-20);
}

TEST(StressRaisers, ElementErrorsAddUpToTheEnergys) {
    const Outcome out = on_first_grids(loaded("[[0, 0], [10, 0], [10, 4], [4, 4], [4, 10], [0, 10]]", "e5", "e1"));
    double sum = 0;
    for (double e : element_errors(out.solved.grids[0].input, out.solved.solution.displacement[0], out.stress[0])) sum += e;
    EXPECT_NEAR(sum / out.passes[0].energy, energy_errors(out.solved, out.stress)->front() / out.passes[0].energy, 1e-12);
}

/// Errors e of the energy on two grids, of which the smoothed stresses see a fraction: any.
TEST(EnergyErrorOfTwoGrids, KnowsWhatTheSmoothedStressesMiss) {
    for (double seen : {0.1, 0.25, 0.5, 0.9})
        for (double first : {0.3, 1e-2, 1e-5})
            for (double ratio : {0.02, 0.3, 0.7}) {
                const double exact = 7, second = ratio * first;
                const EnergyOnGrid before{exact * (1 - first), seen * first}, now{exact * (1 - second), seen * second};
                EXPECT_NEAR(energy_error_of(before, now) / second, 1, 2 * first) << seen << ' ' << first << ' ' << ratio;
            }
    // grids that are no finer tell nothing
    EXPECT_EQ(energy_error_of({1, 0.010}, {1.001, 0.009}), 0.009);
    EXPECT_EQ(energy_error_of({1, 0.010}, {1.001, 0.020}), 0.020);
}

/// Beside contact the pressure is aimed at, and a largest stress that is known badly is worth another grid: around a bore it is
/// as large all the way.
TEST(LargestStress, OfAShrinkFitIsKnown) {
    const Result r = analyze(read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 70000, "nu": 0.33}},
        "parts": [{"name": "ring", "material": "m", "geometry": {"difference": [{"circle": {"center": [3, 4], "radius": 35}},
                       {"circle": {"center": [3, 4], "radius": 20}}]}},
                  {"name": "shaft", "material": "m", "geometry": {"difference": [
                       {"circle": {"center": [3, 4], "radius": 20}}, {"circle": {"center": [3, 4], "radius": 8}}]}}],
        "analysis": "plane_stress",
        "supports": [{"part": "shaft", "rigid": {"translation": [0, 0], "rotation": 0}}],
        "contacts": {"pairs": [{"between": ["ring/*", "shaft/*"], "interference": 0.02}]}})",
                                             "test.json"),
                             {});
    EXPECT_EQ(r.reasons.size(), 0u);
    // Lame
    const double p = r.contacts[0].max_pressure.value, hoop = p * (35 * 35 + 20 * 20) / (35 * 35 - 20 * 20);
    const double exact = std::sqrt(p * p + hoop * hoop + p * hoop), found = r.parts[0].max_von_mises.value;
    ASSERT_TRUE(r.parts[0].max_von_mises_error);
    EXPECT_LT(*r.parts[0].max_von_mises_error, 0.1);
    EXPECT_NEAR(found, exact, *r.parts[0].max_von_mises_error * exact + r.contacts[0].errors->peak * exact);
}

TEST(LargestStress, OfEvenPressureIsRounding) {
    const Result r = analyze(read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3, "expansion": 1.2e-5}},
        "analysis": "plane_strain", "parts": [{"name": "p", "material": "m", 
             "geometry": {"rectangle": {"min": [0, 0], "max": [40, 20]}}}],
        "supports": [{"on": ["p/left", "p/right"], "fix": ["x"]}, {"on": ["p/bottom", "p/top"], "fix": ["y"]}], "loads": [{"part": "p", "temperature": 30}]})",
                                             "test.json"),
                             {});
    EXPECT_EQ(r.reasons.size(), 0u);
    EXPECT_LT(r.parts[0].max_von_mises.value, 1e-9);
}

}  // namespace abut::stress_raisers_test
