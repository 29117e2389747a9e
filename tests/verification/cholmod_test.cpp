// SPDX-License-Identifier: GPL-3.0-or-later
// CHOLMOD as an oracle: every example scene with its factors in place of ours.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "src/analysis/analysis.hpp"
#include "src/motion/placement.hpp"
#include "src/results/result.hpp"
#include "src/scene/load_cases.hpp"
#include "src/scene/read_scene.hpp"
#include "src/scene/scene.hpp"

namespace abut::cholmod_test {
namespace {

std::vector<std::string> scenes() {
    std::vector<std::string> files;
    for (const char* folder : {"/data/scenes", "/data/verification"})
        for (const auto& entry : std::filesystem::directory_iterator(std::string(ABUT_SOURCE_DIR) + folder))
            if (entry.path().extension() == ".json") files.push_back(entry.path().string());
    std::sort(files.begin(), files.end());
    return files;
}

double relative_difference(double a, double b, double scale) {
    return scale == 0 ? std::abs(a - b) : std::abs(a - b) / scale;
}

/// Does the answer say that the contacts which carry load leave this part a motion?
bool is_free(const Result& result, const std::string& part) {
    if (!result.under_load) return false;
    const std::vector<PartMobility>& parts = result.under_load->parts;
    return std::any_of(parts.begin(), parts.end(), [&](const PartMobility& m) { return m.part == part && !m.free.empty(); });
}

/// Whether a row at a contact's end carries nothing or next to nothing, rounding decides; the next grids' knots go by the end.
/// Loads that differ by 1e-12 change such peaks by up to this much, with either solver.
constexpr double next_to_nothing = 1e-6;

/// The largest relative difference of two answers: forces of contacts, displacements of parts, and peaks of contacts. Pressures
/// are derivatives of displacements: what rounding leaves of these counts by a model's size over the contact's length.
double difference(const Result& a, const Result& b, double size) {
    double largest = 0, force = 0, moved = 0;
    for (const ContactResult& c : a.contacts)  // closed rings press on each other without a resultant
        force = std::max({force, c.force.norm(), c.max_pressure.value * c.contact_length});
    for (const PartResult& p : a.parts) moved = std::max(moved, p.max_displacement.value);
    for (std::size_t k = 0; k < a.contacts.size(); ++k) {
        largest = std::max(largest, relative_difference((a.contacts[k].force - b.contacts[k].force).norm(), 0, force));
        const double of_size = std::min(1.0, a.contacts[k].contact_length / size);
        const double peak = a.contacts[k].max_pressure.value;
        const double of_peak = relative_difference(peak, b.contacts[k].max_pressure.value, peak);
        if (of_peak > next_to_nothing) largest = std::max(largest, of_size * of_peak);
    }
    for (std::size_t i = 0; i < a.parts.size(); ++i) {
        if (is_free(a, a.parts[i].name)) continue;  // rounding decides where such a part stands
        largest =
            std::max(largest, relative_difference(a.parts[i].max_displacement.value, b.parts[i].max_displacement.value, moved));
    }
    return largest;
}

class Cholmod : public testing::TestWithParam<std::string> {};

TEST_P(Cholmod, FactorsGiveTheAnswersOfOurs) {
    Scene scene = read_scene(GetParam());
    if (!scene.cases.empty()) scene = scene_of_case(scene, scene.cases.back());
    if (has_friction(scene.contacts)) GTEST_SKIP() << "what sticks and what slips is not unique: rounding decides";
    const Result ours = analyze(scene, {});
    scene.accuracy.by_cholmod = true;
    const Result theirs = analyze(scene, {});
    ASSERT_EQ(ours.status, theirs.status);
    ASSERT_EQ(ours.contacts.size(), theirs.contacts.size());
    EXPECT_EQ(ours.solver.grids, theirs.solver.grids);
    // Both solve the same equations: the rounding of n unknowns times the condition of the scaled matrices
    const double rounding = std::numeric_limits<double>::epsilon() * std::sqrt(ours.unknowns) * ours.solver.condition_estimate;
    geometry::Box2 model;
    for (const ScenePart& part : scene.parts) model.extend(bounding_box(part.part));
    EXPECT_LE(difference(ours, theirs, model.diagonal()), rounding);
}

INSTANTIATE_TEST_SUITE_P(Examples, Cholmod, testing::ValuesIn(scenes()), [](const auto& scene) {
    const std::filesystem::path file = scene.param;
    return file.parent_path().filename().string() + "_" + file.stem().string();
});

}  // namespace
}  // namespace abut::cholmod_test
