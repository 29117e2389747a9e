// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of nearly incompressible parts.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "src/analysis/analysis.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/verification/hertz_error.hpp"

namespace abut::test::incompressible_contact_test {
namespace {

/// Hertz' two cylinders, a hundredth of the radius in contact (data/verification/hertz_001.json), in plane strain with an E
/// that keeps E / (1 - nu^2): the same contact whatever nu is.
Result hertz(double nu, int degree) {
    Scene scene = read_scene(std::string(ABUT_SOURCE_DIR) + "/data/verification/hertz_001.json", {});
    scene.analysis = Analysis::plane_strain;
    scene.materials.at(0).nu = nu;
    scene.materials.at(0).E *= 1 - nu * nu;
    scene.accuracy.degree = degree;
    return analyze(scene, {});
}

TEST(IncompressibleContact, HertzAtAnyRatio) {
    constexpr double a = 0.01, p0 = 500, force = 3.92699081698724;
    for (double nu : {0.3, 0.49, 0.4999})
        for (int degree : {2, 3}) {
            SCOPED_TRACE("nu " + std::to_string(nu) + ", degree " + std::to_string(degree));
            const Result r = hertz(nu, degree);
            ASSERT_EQ(r.status, "ok") << r.message;
            ASSERT_EQ(r.contacts.size(), 1u);
            EXPECT_LT(hertz_error(r.contacts[0].profile, a, p0), 0.01);
            EXPECT_NEAR(r.contacts[0].contact_length, a, 0.01 * a);
            EXPECT_NEAR(r.contacts[0].max_pressure.value, p0, 0.01 * p0);
            EXPECT_NEAR(r.contacts[0].force.y(), force, 1e-7 * force);
            EXPECT_LT(r.equilibrium.relative_residual, 1e-8);
            for (const std::string& warning : r.warnings) EXPECT_EQ(warning.find("incompressible"), std::string::npos);
        }
}

}  // namespace
}  // namespace abut::test::incompressible_contact_test
