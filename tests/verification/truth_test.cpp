// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that were once answered wrongly without a word, against independent finite elements, closed forms and statics
// (truth/expected.json: which, and how well it is known). Forces within 1 %, largest pressures and stresses within 2 % and
// within the error that the answer states, refusals where something slides.
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "src/results/verdict.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/generated/sound.hpp"

namespace abut::truth_test {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

const fs::path own = fs::path(ABUT_SOURCE_DIR) / "tests/verification/truth";
const fs::path all = fs::path(ABUT_SOURCE_DIR) / "../shared/inputs/truth";

constexpr double of_forces = 0.01, of_peaks = 0.02;

std::vector<Json> rows() {
    std::ifstream file(own / "expected.json");
    return Json::parse(file).at("rows").get<std::vector<Json>>();
}

/// Where a row's scene is: with all others, or the copy beside this test; empty where it is in neither.
fs::path scene_of(const Json& row) {
    const std::string name = row.at("scene").get<std::string>() + ".json";
    for (const fs::path& folder : {all, own})
        if (fs::exists(folder / name)) return folder / name;
    return {};
}

void expect_near(double value, double truth, double tolerance, const std::string& what) {
    EXPECT_NEAR(value, truth, tolerance * std::abs(truth)) << what << ", off by " << 100 * (value / truth - 1) << " %";
}

/// Within 2 %, and within what the answer itself says.
void expect_peak(double value, double truth, double doubt, std::optional<double> stated, const std::string& what) {
    expect_near(value, truth, of_peaks + doubt, what);
    if (stated) expect_near(value, truth, *stated + doubt, what + " against its stated error");
}

/// All zones between two parts.
std::vector<const ContactResult*> zones_of(const Result& r, const Json& parts) {
    const auto a = parts.at(0).get<std::string>(), b = parts.at(1).get<std::string>();
    std::vector<const ContactResult*> zones;
    for (const ContactResult& c : r.contacts)
        if ((c.parts[0] == a && c.parts[1] == b) || (c.parts[0] == b && c.parts[1] == a)) zones.push_back(&c);
    return zones;
}

const ContactResult& strongest(const std::vector<const ContactResult*>& zones) {
    return **std::max_element(zones.begin(), zones.end(), [](const ContactResult* a, const ContactResult* b) {
        return a->max_pressure.value < b->max_pressure.value;
    });
}

std::optional<double> stated_peak_error(const ContactResult& c) {
    if (!c.errors || c.errors->at_corner) return std::nullopt;
    return c.errors->peak;
}

/// The largest pressures at x < 0 and at x >= 0, relative to the larger one: a small one beside a large one is not known
/// better.
void expect_sides(const std::vector<const ContactResult*>& zones, const Json& expected, double doubt) {
    std::array<double, 2> found{0, 0};
    for (const ContactResult* c : zones)
        for (std::size_t i = 0; i < c->profile.x.size(); ++i) {
            double& side = found[c->profile.x[i] < 0 ? 0 : 1];
            side = std::max(side, c->profile.pressure[i]);
        }
    const auto truth = expected.get<std::array<double, 2>>();
    const double largest = std::max(truth[0], truth[1]);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(found[k], truth[k], (of_peaks + doubt) * largest) << "side " << k;
}

void expect_zones(std::vector<const ContactResult*> zones, const Json& expected, double doubt) {
    const auto middle = [](const ContactResult* c) { return c->max_pressure.at.x(); };
    std::erase_if(zones, [](const ContactResult* c) { return c->status == "open"; });
    std::sort(zones.begin(), zones.end(), [&](auto* a, auto* b) { return middle(a) < middle(b); });
    ASSERT_EQ(zones.size(), expected.size());
    for (std::size_t k = 0; k < zones.size(); ++k)
        expect_near(zones[k]->force.norm(), expected[k].get<double>(), of_forces + doubt, "zone " + std::to_string(k));
}

void expect_contact(const Result& r, const Json& c) {
    const auto zones = zones_of(r, c.at("parts"));
    const std::string name = c.at("parts").dump();
    const double doubt = c.value("doubt", 0.0);
    ASSERT_FALSE(zones.empty()) << name;
    Vec2 force{0, 0};
    for (const ContactResult* zone : zones) force += zone->force;
    if (c.contains("force")) expect_near(force.norm(), c["force"].get<double>(), of_forces + doubt, name + " force");
    if (c.contains("sideways_at_most")) { EXPECT_LE(std::abs(force.x()), c["sideways_at_most"].get<double>()) << name; }
    if (c.contains("peak")) {
        const ContactResult& at = strongest(zones);
        expect_peak(at.max_pressure.value, c["peak"].get<double>(), doubt, stated_peak_error(at), name + " peak");
    }
    if (c.contains("sides")) expect_sides(zones, c["sides"], doubt);
    if (c.contains("zones")) expect_zones(zones, c["zones"], doubt);
}

void expect_answer(const Result& r, const Json& row) {
    const double doubt = row.value("doubt", 0.0);
    for (const Json& c : row.value("contacts", Json::array())) expect_contact(r, c);
    if (row.contains("energy")) expect_near(r.strain_energy, row["energy"].get<double>(), of_forces + doubt, "energy");
    if (row.contains("probe_y"))
        expect_near(r.probes.at(0).displacement.y(), row["probe_y"].get<double>(), of_forces + doubt, "displacement");
    if (row.contains("von_mises")) {
        double largest = 0;
        for (const PartResult& p : r.parts) largest = std::max(largest, p.max_von_mises.value);
        expect_peak(largest, row["von_mises"].get<double>(), doubt, std::nullopt, "largest stress");
    }
    for (const Reaction& s : r.reactions) {
        if (s.method != "rigid" || !row.contains("hold_at_most")) continue;
        EXPECT_LE(std::abs(s.force.x()), row["hold_at_most"].get<double>()) << s.label;
    }
}

class Truth : public testing::TestWithParam<Json> {};

TEST_P(Truth, IsAnswered) {
    const Json& row = GetParam();
    const fs::path path = scene_of(row);
    if (path.empty()) GTEST_SKIP() << "the scene is not here";
    const Scene scene = read_scene(path.string());
    const auto begin = std::chrono::steady_clock::now();
    const test::Answer answer = test::answer_of(scene);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    EXPECT_LE(taken.count(), row.value("seconds", 60.0));
    if (row.contains("not_yet")) {  // known to be wrong or refused: never without a word
        EXPECT_TRUE(answer.refused || verdict_of(answer.result) == Verdict::solved_but) << row["not_yet"];
        return;
    }
    ASSERT_EQ(answer.refused, row.value("outcome", "solved") == "refused") << answer.message;
    if (answer.refused) return;
    for (const std::string& fault : test::faults_of(scene, answer.result, row.value("balance", 1e-9))) ADD_FAILURE() << fault;
    expect_answer(answer.result, row);
}

INSTANTIATE_TEST_SUITE_P(OfScene, Truth, testing::ValuesIn(rows()), [](const auto& row) {
    std::string name = row.param.at("scene").template get<std::string>();
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
});

/// Every scene of the folder is in the table, and no row names a scene that is nowhere.
TEST(TruthTable, HasEveryScene) {
    if (!fs::exists(all)) GTEST_SKIP() << "the folder is not here";
    std::vector<std::string> in_table, in_folder;
    for (const Json& row : rows()) in_table.push_back(row.at("scene").get<std::string>());
    for (const auto& file : fs::directory_iterator(all))
        if (file.path().extension() == ".json") in_folder.push_back(file.path().stem().string());
    std::sort(in_table.begin(), in_table.end());
    std::sort(in_folder.begin(), in_folder.end());
    EXPECT_EQ(in_table, in_folder);
}

/// The checks can fail.
TEST(TruthTable, SeesAWrongAnswer) {
    const auto row = rows().front();
    const fs::path path = scene_of(row);
    ASSERT_FALSE(path.empty());
    test::Answer answer = test::answer_of(read_scene(path.string()));
    ASSERT_FALSE(answer.refused) << answer.message;
    answer.result.contacts.at(0).force *= 1.03;
    EXPECT_FALSE(test::faults_of(read_scene(path.string()), answer.result).empty());
    EXPECT_NONFATAL_FAILURE(expect_near(1.03, 1, of_forces, "force"), "off by");
}

}  // namespace
}  // namespace abut::truth_test
