// SPDX-License-Identifier: GPL-3.0-or-later
// Bars up to a thousand times as long as thick: right on the grid that abut chooses, and told of where rounding counts.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "src/analysis/analysis.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::slender_test {
namespace {

/// A cantilever of height 1, turned, with a shear load at its end that deflects the tip by 1 as a beam.
Result cantilever(double length, double degrees) {
    const double traction = 1e5 / (4 * std::pow(length, 3)), angle = degrees * M_PI / 180;
    std::ostringstream scene;
    scene.precision(17);
    scene << R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0}}, "parts": [{"name": "b", "material": "m",
        "geometry": {"place": {"of": {"rectangle": {"min": [0, -0.5], "max": [)"
          << length << R"(, 0.5]}}, "rotate": )" << degrees << R"(}}}], "supports": [{"on": "b/left", "fix": ["x", "y"]}],
        "loads": [{"on": "b/right", "traction": [)"
          << -traction * std::sin(angle) << ", " << traction * std::cos(angle)
          << R"(]}], "output": {"probes": [{"part": "b", "at": [)" << (length * (1 - 1e-9)) * std::cos(angle) << ", "
          << (length * (1 - 1e-9)) * std::sin(angle) << "]}]}}";
    return analyze(read_scene_text(scene.str(), "scene.json"), {});
}

bool warns_of_rounding(const Result& r) {
    for (const std::string& w : r.warnings)
        if (w.find("rounding may change this answer") != std::string::npos) return true;
    return false;
}

}  // namespace

TEST(SlenderBars, BendAsBeams) {
    for (const double length : {30.0, 100.0, 300.0, 1000.0})
        for (const double degrees : {0.0, 17.0}) {
            const Result r = cantilever(length, degrees);
            ASSERT_EQ(r.status, "ok") << r.message;
            const double tip = r.probes[0].displacement.norm();
            // 1 + 0.6 / length^2 (Timoshenko, nu = 0)
            EXPECT_NEAR(tip, 1, 0.005) << length << " at " << degrees;
            if (length < 500) { EXPECT_FALSE(warns_of_rounding(r)) << r.solver.condition_estimate; }
        }
}

TEST(SlenderBars, WhereRoundingSpoilsTheAnswerItSaysSo) {
    for (const double length : {3000.0, 10000.0}) {
        const Result r = cantilever(length, 0);
        EXPECT_TRUE(r.status == "failed" || warns_of_rounding(r));
    }
}

}  // namespace abut::slender_test
