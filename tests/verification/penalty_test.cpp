// SPDX-License-Identifier: GPL-3.0-or-later
// The penalty formulation through scenes: its keys, its law, and its differences from mortar and between its pairings.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/verification/verify.hpp"
#include "src/verification/verify_contact_answers.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::penalty_test {
namespace {

const std::string data = ABUT_SOURCE_DIR "/data";

/// Two blocks on aligned grids with cells of 0.25, pressed together.
std::string blocks(const std::string& contacts) {
    return R"({"abut": 1, "materials": {"soft": {"E": 1000, "nu": 0.3}, "hard": {"E": 4000, "nu": 0.2}}, "parts": [
        {"name": "lower", "material": "soft", "geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}}},
        {"name": "upper", "material": "hard", "geometry": {"rectangle": {"min": [0, 1], "max": [1, 2]}}}],
        "supports": [{"on": ["lower/left", "lower/bottom", "upper/left"], "symmetry": true}],
        "loads": [{"on": "upper/top", "pressure": 8}], "contacts": )" +
           contacts + R"(, "accuracy": {"cell_size": 0.25}})";
}

struct Law {
    std::string contacts;
    double beta;
};

TEST(PenaltyScene, PressesWithItsFactorTimesTheStifferModulusOverItsLength) {
    const std::vector<Law> laws{{R"({"formulation": "penalty"})", 50 * 4000 / 0.25},
                                {R"({"formulation": "penalty", "penalty": 10})", 10 * 4000 / 0.25},
                                {R"({"formulation": "penalty", "penalty_length": 1})", 50 * 4000},
                                {R"({"formulation": "penalty", "penalty": 7, "penalty_length": 0.5})", 7 * 4000 / 0.5}};
    for (const Law& law : laws) {
        const Result r = test::answer(blocks(law.contacts));
        ASSERT_EQ(r.status, "ok") << r.message;
        EXPECT_LT(pressure_error(r.contacts.at(0), 8), 1e-9) << law.contacts;
        EXPECT_NEAR(r.contacts[0].max_penetration * law.beta, 8, 1e-8) << law.contacts;
        EXPECT_EQ(r.contacts[0].status, "closed");
        EXPECT_NEAR(r.contacts[0].force.y(), -8, 1e-9);
        EXPECT_LT(r.equilibrium.relative_residual, 1e-9);
    }
}

TEST(PenaltyScene, MortarDoesNotPenetrate) {
    for (const char* contacts : {"{}", R"({"formulation": "mortar"})", R"({"formulation": "auto"})"})
        EXPECT_LT(test::answer(blocks(contacts)).contacts.at(0).max_penetration, 1e-12) << contacts;
}

TEST(PenaltyScene, ItsKeysBelongToIt) {
    for (const char* contacts : {R"({"penalty": 50})", R"({"formulation": "mortar", "penalty_length": 1})"}) try {
            test::answer(blocks(contacts));
            ADD_FAILURE() << contacts << " was accepted";
        } catch (const InputError& error) {
            EXPECT_NE(one_line(error.problems().at(0)).find("belongs to the penalty formulation"), std::string::npos)
                << contacts;
        }
    for (const char* contacts : {R"({"formulation": "penalty", "penalty": 0})",
                                 R"({"formulation": "penalty", "penalty_length": -1})", R"({"formulation": "penelty"})"})
        EXPECT_THROW(test::answer(blocks(contacts)), InputError) << contacts;
}

/// Penalties that grow tenfold come tenfold closer to mortar.
TEST(PenaltyScene, ApproachesMortar) {
    const std::string scene = "verification/bars_with_gap.json";
    double last = 0;
    for (double factor : {5.0, 50.0, 500.0}) {
        const Result r = answer_of({scene, {}, {}, PenaltyOptions{factor, 1}}, data);
        const double away = 1.6 - r.contacts.at(0).force.norm();
        EXPECT_GT(away, 0);
        if (last > 0) { EXPECT_NEAR(last / away, 10, 0.5); }
        last = away;
    }
}

/// Master normal and middle curve part by (a/R)^2 = 0.8 % at most where a/R = 0.09.
TEST(PenaltyScene, PairingsDifferByTheSquareOfTheContactsAngle) {
    std::vector<double> peaks;
    for (Pairing pairing : {Pairing::middle, Pairing::master}) {
        const Result r = answer_of({"verification/dissertation_b.json", {}, {}, PenaltyOptions{50, 1, pairing}}, data);
        ASSERT_EQ(r.status, "ok");
        peaks.push_back(r.contacts.at(0).max_pressure.value);
        EXPECT_LT(r.equilibrium.relative_residual, 1e-9);
        EXPECT_NEAR(r.contacts[0].force.y(), 250, 1e-6);
    }
    const auto [least, most] = std::minmax_element(peaks.begin(), peaks.end());
    EXPECT_LT(*most / *least - 1, 0.008);
    EXPECT_GT(*most / *least - 1, 1e-6) << "an option without effect";
}

/// The dissertation's points, in the first part's cells alone, miss uniform pressure on grids turned against each other.
TEST(PenaltyScene, UniformPressureNeedsPointsBetweenBothGridsLines) {
    const std::string scene = "verification/contact_patch.json";
    const Result both = answer_of({scene, {}, {}, PenaltyOptions{500, 1}}, data);
    const Result first = answer_of({scene, {}, {}, PenaltyOptions{500, 1, Pairing::master, false}}, data);
    EXPECT_LT(pressure_error(both.contacts.at(0), 100), 1e-9);
    EXPECT_GT(pressure_error(first.contacts.at(0), 100), 0.01);
}

}  // namespace
}  // namespace abut::penalty_test
