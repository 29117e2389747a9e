// SPDX-License-Identifier: GPL-3.0-or-later
// Honesty of the estimated errors: estimate over true error, true ones against closed forms where those are ten times better,
// else against abut's own solution for a target twenty times finer.
//
// Measured over the whole sweep (targets 5, 2, 1, 0.5 and 0.2 %):
//   contact pressure, L2 (17 scenes, corners left out)     0.70 to 1.91, all 85 inside [1/2, 2]
//   stress, energy norm, without contact, smooth           0.7 to 1.6 (closed forms 1.1 to 1.6)
//   stress, energy norm, with contact                      75 of 80 inside [1/2, 2]; 0.31 to 0.46 in four runs at 5 and 2 %
//                                                          and 3.0 where the energies that make the truth agree by chance
//   stress, without limit at a corner (cook, L)            0.26 to 0.53: too low, its own cells see too little of it
//   peaks (65 with a limit)                                0.69 to 71, 22 inside [1/2, 2]: never too low by more than 2; far
//   too
//                                                          high where the true error is by chance a hundredth of the pressure's
//   forces that statics leave open (vise, four pins)       0.25 to 11, geometric mean 1.3: true errors change sign, and
//                                                          are small by chance where the estimate is far too high
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "src/analysis/analysis.hpp"
#include "src/scene/read_scene.hpp"
#include "src/verification/verify_contact_answers.hpp"
#include "tests/verification/true_errors.hpp"

namespace abut::estimate_test {
namespace {

using test::EstimateCase;

constexpr double dishonest = 2;
constexpr double closer = 0.02;  // what is taken for the truth: than the finest solution
const std::vector<double> all_targets{0.05, 0.02, 0.01, 0.005, 0.002};

std::string name_of(const EstimateCase& c, double target) {
    std::string name = c.scene + (c.analysis ? ", other analysis" : "");
    for (const auto& [parameter, value] : c.parameters) name += ", " + parameter + " " + std::to_string(value);
    return name + ", target " + std::to_string(target);
}

/// doubt: the estimated error of what the truth was found with.
void expect_honest(double estimate, double truth, double doubt = 0, double least = 1 / dishonest, double most = dishonest) {
    ASSERT_LT(doubt, 0.5 * truth) << "the reference is too coarse";
    EXPECT_GT(estimate, least * (truth - doubt)) << "too low: " << estimate << " for " << truth;
    EXPECT_LT(estimate, most * (truth + doubt)) << "too high: " << estimate << " for " << truth;
}

void expect_honest_contact(const EstimateCase& c, const std::vector<double>& targets, double most = dishonest) {
    const Scene scene = test::adaptive_scene(c);
    const Outcome reference = test::solved_to(scene, closer * targets.back());
    for (double target : targets) {
        SCOPED_TRACE(name_of(c, target));
        const Outcome out = test::solved_to(scene, target);
        const ErrorEstimate& estimate = out.errors.back();
        ASSERT_TRUE(estimate.contact_pressure && estimate.peak);
        EXPECT_TRUE(out.end != PathEnd::reached || *estimate.contact_pressure <= target);
        const test::TrueErrors truth = test::errors_against(out, reference);
        expect_honest(*estimate.contact_pressure, truth.contact_pressure, *reference.errors.back().contact_pressure,
                      1 / dishonest, most);
        EXPECT_GE(*estimate.peak, truth.peak / dishonest);
    }
}

/// least: see the table above.
void expect_honest_stress(const EstimateCase& c, const std::vector<double>& targets, double least) {
    const Scene scene = test::adaptive_scene(c);
    const Outcome reference = test::solved_to(scene, closer * targets.back());
    for (double target : targets) {
        SCOPED_TRACE(name_of(c, target));
        const Outcome out = test::solved_to(scene, target);
        ASSERT_TRUE(out.errors.back().stress);
        expect_honest(*out.errors.back().stress, test::errors_against(out, reference).stress, 0, least);
    }
}

void expect_honest_stress(const std::string& file, const test::StressField& exact) {
    const Scene scene = test::adaptive_scene({file});
    for (double target : all_targets) {
        SCOPED_TRACE(file + ", target " + std::to_string(target));
        const Outcome out = test::solved_to(scene, target);
        ASSERT_TRUE(out.errors.back().stress);
        const double truth = test::stress_error(out, exact);
        expect_honest(*out.errors.back().stress, truth);
        EXPECT_LE(truth, target);
    }
}

Result analyzed_to(Scene scene, double target) {
    scene.accuracy.target = target;
    AnalyzeOptions options;
    options.threads = 1;
    return analyze(scene, options);
}

/// E3: tension 1 along x, hole of radius 1.
Eigen::Vector3d kirsch(const Vec2& x) {
    const double r2 = 1 / x.squaredNorm(), r4 = r2 * r2, t = std::atan2(x.y(), x.x());
    return {1 - r2 * (1.5 * std::cos(2 * t) + std::cos(4 * t)) + 1.5 * r4 * std::cos(4 * t),
            -r2 * (0.5 * std::cos(2 * t) - std::cos(4 * t)) - 1.5 * r4 * std::cos(4 * t),
            -r2 * (0.5 * std::sin(2 * t) + std::sin(4 * t)) + 1.5 * r4 * std::sin(4 * t)};
}

/// E4: pressure 100 in a ring of radii 1 and 2.
Eigen::Vector3d lame(const Vec2& x) {
    const double mean = 100.0 / 3, half = 400.0 / 3 / x.squaredNorm(), t = 2 * std::atan2(x.y(), x.x());
    return {mean - half * std::cos(t), mean + half * std::cos(t), -half * std::sin(t)};
}

}  // namespace

TEST(Estimates, StressBesideAHoleAgainstKirsch) {
    expect_honest_stress("verification/kirsch.json", kirsch);
}

TEST(Estimates, StressOfARingAgainstLame) {
    expect_honest_stress("verification/ring_quarter.json", lame);
}

/// Cook's membrane: no limit of the stress at the held corners. The work of the load is known to seven digits (E8), and under
/// given loads the error of the stresses, squared, is that of the energy.
TEST(Estimates, StressWithoutLimitAtCorners) {
    constexpr double exact = 0.5 * 24.041606;
    const Scene scene = test::adaptive_scene({"verification/cook_standard.json"});
    for (double target : all_targets) {
        SCOPED_TRACE(target);
        const Outcome out = test::solved_to(scene, target);
        ASSERT_TRUE(out.errors.back().stress);
        expect_honest(*out.errors.back().stress, std::sqrt(1 - out.passes.back().energy / exact));
        EXPECT_EQ(out.end, PathEnd::reached);
        EXPECT_LE(*out.errors.back().stress, target);
    }
}

TEST(Estimates, PressureAgainstHertz) {
    const Scene scene = test::adaptive_scene({"verification/hertz_001.json"});
    const Hertz exact{0.01, 500};
    for (double target : {0.05, 0.01, 0.002}) {
        SCOPED_TRACE(target);
        const Outcome out = test::solved_to(scene, target);
        ASSERT_TRUE(out.errors.back().contact_pressure);
        const double truth = test::pressure_error(scene, out, [&](double x) { return exact.pressure(x); });
        expect_honest(*out.errors.back().contact_pressure, truth);
        // the measure can fail
        const double shifted = test::pressure_error(scene, out, [&](double x) { return 1.03 * exact.pressure(x); });
        EXPECT_GT(shifted, truth);
    }
}

TEST(Estimates, PressuresOfOneContactOfEachKind) {
    const std::vector<double> targets{0.02, 0.005};
    for (const EstimateCase& c : std::vector<EstimateCase>{{"scenes/case_b.json"},
                                                           {"verification/pin_in_hole.json"},
                                                           {"verification/shrink_fit.json"},
                                                           {"verification/wedge.json"},
                                                           {"verification/filleted_punch.json"},
                                                           {"scenes/vise.json"},
                                                           {"scenes/case_a.json"}})
        expect_honest_contact(c, targets);
}

TEST(Estimates, ForcesThatStaticsLeaveOpen) {
    constexpr double least = 0.2, most = 12;  // see the table above
    double sum = 0;
    int n = 0;
    for (const char* file : {"scenes/vise.json", "scenes/four_pin_beam.json"}) {
        const Scene scene = test::adaptive_scene({file});
        const Result reference = analyzed_to(scene, 2e-4);
        for (double target : all_targets) {
            const Result r = analyzed_to(scene, target);
            ASSERT_EQ(r.contacts.size(), reference.contacts.size());
            for (std::size_t k = 0; k < r.contacts.size(); ++k) {
                const ContactResult &contact = r.contacts[k], &exact = reference.contacts[k];
                ASSERT_TRUE(contact.errors && exact.errors);
                const double truth = (contact.force - exact.force).norm() / exact.force.norm();
                const double with_doubt = truth + exact.errors->force;  // the reference is no closer itself
                EXPECT_GT(contact.errors->force / truth, least) << file << ", target " << target << ", contact " << k;
                EXPECT_LT(contact.errors->force / with_doubt, most) << file << ", target " << target << ", contact " << k;
                sum += std::log(contact.errors->force / with_doubt);
                ++n;
            }
        }
    }
    EXPECT_LT(std::abs(sum / n), std::log(dishonest));
}

TEST(Estimates, StressWithContactAndWithout) {
    expect_honest_stress({"scenes/case_c.json"}, {0.02, 0.005}, 1 / dishonest);
    expect_honest_stress({"verification/cantilever.json"}, {0.02, 0.005}, 1 / dishonest);
}

TEST(LongEstimates, PressuresOfHertzLikeContacts) {
    for (const EstimateCase& c : std::vector<EstimateCase>{{"verification/hertz_001.json"},
                                                           {"verification/cylinder_on_plane.json"},
                                                           {"verification/cylinder_on_plane.json", {{"E1", 1e9}}},
                                                           {"verification/cylinder_on_plane.json", {}, Analysis::plane_strain},
                                                           {"verification/roller_on_block.json"},
                                                           {"scenes/case_b.json"},
                                                           {"scenes/case_b.json", {}, Analysis::plane_strain},
                                                           {"scenes/case_c.json"},
                                                           {"scenes/case_c.json", {}, Analysis::plane_strain},
                                                           {"scenes/cam_follower.json"}})
        expect_honest_contact(c, all_targets);
}

TEST(LongEstimates, PressuresOfPinsRingsAndCorners) {
    for (const EstimateCase& c : std::vector<EstimateCase>{{"verification/pin_in_hole.json"},
                                                           {"verification/pin_in_hole.json", {{"dR", 0.01}}},
                                                           {"verification/pin_in_hole.json", {{"dR", 0}}},
                                                           {"verification/shrink_fit.json"},
                                                           {"verification/wedge.json"},
                                                           {"scenes/vise.json"}})
        expect_honest_contact(c, all_targets);
    // a flat of two first cells: the change between grids of which one still missed its end is 3.2 times the error
    expect_honest_contact({"verification/filleted_punch.json"}, {0.05}, 4);
    expect_honest_contact({"verification/filleted_punch.json"}, {0.02, 0.01, 0.005, 0.002});
    // 2e-4 off at 0.2 %, beside corners, where no finer solution is known better
    expect_honest_contact({"scenes/case_a.json"}, {0.05, 0.02, 0.01, 0.005});
    // First cells that miss the middle of the flat lead to grids far finer than was asked for, as fine as any reference gets:
    // all that is known is that errors are not stated too low.
    const Scene small = test::adaptive_scene({"verification/filleted_punch.json", {{"R", 1}, {"P", 0.013}}});
    const Outcome reference = test::solved_to(small, closer * 0.002);
    for (double target : {0.05, 0.02, 0.01}) {
        const Outcome out = test::solved_to(small, target);
        EXPECT_GE(*out.errors.back().contact_pressure, test::errors_against(out, reference).contact_pressure / dishonest);
    }
}

/// A sleeve between plate and pin, all of one radius: its wall asks for cells far smaller than those that plate and pin have.
/// Never too low; the peak's, and with it the pressure's, is too high where grids shift the ripples of an even pressure.
TEST(LongEstimates, PressuresOfThinSleeves) {
    const std::string rest = R"scene(,
        "materials": {"steel": {"E": 200000, "nu": 0.3}, "aluminium": {"E": 70000, "nu": 0.33}},
        "parts": [
          {"name": "plate", "material": "steel", "geometry": {"difference": [
            {"rectangle": {"min": [-40, -40], "max": [40, 40]}, "name": "p"}, {"circle": {"center": [0, 0], "radius": 10}}]}},
          {"name": "sleeve", "material": "aluminium", "geometry": {"difference": [
            {"circle": {"center": [0, 0], "radius": 10}}, {"circle": {"center": [0, 0], "radius": "10-wall"}}]}},
          {"name": "pin", "material": "steel", "geometry": {"circle": {"center": [0, 0], "radius": "10-wall"}}}],
        "supports": [{"on": "plate/p/bottom", "fix": ["x", "y"]}],
        "loads": [{"part": "pin", "force": ["1000*cos(angle*pi/180)", "1000*sin(angle*pi/180)"]}]})scene";
    for (const auto& [wall, angle] : std::vector<std::array<double, 2>>{{0.05, -17}, {0.1, -50}, {0.2, 60}}) {
        SCOPED_TRACE("wall " + std::to_string(wall) + ", angle " + std::to_string(angle));
        const std::string parameters = R"({"wall": )" + std::to_string(wall) + R"(, "angle": )" + std::to_string(angle) + "}";
        const Scene scene = read_scene_text(R"({"abut": 1, "parameters": )" + parameters + rest, "sleeve.json");
        const Outcome reference = test::solved_to(scene, 0.0003), out = test::solved_to(scene, 0.01);
        const test::TrueErrors truth = test::errors_against(out, reference);
        const double doubt = *reference.errors.back().contact_pressure;
        ASSERT_LT(doubt, 0.5 * truth.contact_pressure) << "the reference is too coarse";
        EXPECT_GE(*out.errors.back().contact_pressure, (truth.contact_pressure - doubt) / dishonest);
    }
}

TEST(LongEstimates, Stress) {
    expect_honest_stress({"verification/cantilever.json"}, all_targets, 1 / dishonest);
    expect_honest_stress({"verification/radial_body_force.json"}, all_targets, 1 / dishonest);
    expect_honest_stress({"verification/cook.json"}, {0.05, 0.02, 0.01}, 1 / dishonest);
    for (const char* scene :
         {"verification/hertz_001.json", "scenes/case_b.json", "scenes/case_c.json", "scenes/cam_follower.json"})
        expect_honest_stress({scene}, {0.02, 0.01, 0.005}, 1 / dishonest);
}

}  // namespace abut::estimate_test
