// SPDX-License-Identifier: GPL-3.0-or-later
// Made-up assemblies against finite elements that share nothing with abut: quadratic triangles on meshes refined round the
// contacts, mortar with linear pressures, the gap along the master's own normal (independent_fe/values.json: values, meshes,
// doubt).
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "src/scene/read_scene.hpp"
#include "tests/generated/sound.hpp"

namespace abut::independent_fe_test {
namespace {

using Json = nlohmann::json;

constexpr double of_forces = 0.01, of_peaks = 0.02;

std::vector<Json> scenes() {
    std::ifstream file(std::string(ABUT_SOURCE_DIR) + "/tests/verification/independent_fe/values.json");
    return Json::parse(file).at("scenes").get<std::vector<Json>>();
}

void expect_near(double value, double truth, double tolerance, const std::string& what) {
    EXPECT_NEAR(value, truth, tolerance * std::abs(truth)) << what << ", off by " << 100 * (value / truth - 1) << " %";
}

/// All zones between two parts together.
void expect_contact(const Result& r, const Json& truth, double doubt) {
    const std::string name = truth.at("parts").dump();
    const auto parts = truth.at("parts").get<std::array<std::string, 2>>();
    Vec2 force{0, 0};
    double peak = 0;
    bool at_corner = false;
    for (const ContactResult& c : r.contacts) {
        if (c.parts != parts) continue;
        force += c.force;
        peak = std::max(peak, c.max_pressure.value);
        at_corner |= c.errors && c.errors->at_corner;
    }
    if (truth.contains("force")) expect_near(force.norm(), truth["force"].get<double>(), of_forces + doubt, name + " force");
    if (truth.contains("peak") && !at_corner) expect_near(peak, truth["peak"].get<double>(), of_peaks + doubt, name + " peak");
}

class IndependentFe : public testing::TestWithParam<Json> {};

TEST_P(IndependentFe, HasTheSameForcesPeaksAndEnergy) {
    const Json& truth = GetParam();
    const Scene scene = read_scene_text(truth.at("scene").dump(), "assembly.json");
    const test::Answer answer = test::answer_of(scene);
    ASSERT_FALSE(answer.refused) << answer.message;
    const double doubt = truth.at("doubt").get<double>();
    for (const Json& c : truth.at("contacts")) expect_contact(answer.result, c, doubt);
    expect_near(answer.result.strain_energy, truth.at("energy").get<double>(), of_forces + doubt, "energy");
}

INSTANTIATE_TEST_SUITE_P(OfScene, IndependentFe, testing::ValuesIn(scenes()), [](const auto& scene) {
    std::string name = scene.param.at("name").template get<std::string>();
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
});

}  // namespace
}  // namespace abut::independent_fe_test
