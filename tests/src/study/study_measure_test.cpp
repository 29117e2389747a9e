// SPDX-License-Identifier: GPL-3.0-or-later
// What a study compares: grids of other sizes, answers against each other, known answers found again.
#include "src/study/study_measure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "src/scene/read_scene.hpp"
#include "src/study/study_reference.hpp"
#include "tests/src/io/temporary_folder.hpp"

namespace abut::study_measure_test {
namespace {

const std::string data = std::string(ABUT_SOURCE_DIR) + "/data";

std::string file_text(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

const VerifyProblem* known(const std::string& path) {
    return known_problem(path, read_scene(path), data);
}

std::vector<double> graded(int cells, double ratio) {
    std::vector<double> lines{-3};
    for (double h = 0.1; static_cast<int>(lines.size()) <= cells; h *= ratio) lines.push_back(lines.back() + h);
    return lines;
}

TEST(StudyGrids, ResizedLinesKeepEndsOrderAndGrading) {
    for (int cells : {1, 2, 7, 40})
        for (double ratio : {0.8, 1.0, 1.3})
            for (double size : {0.35, 0.5, 0.7, 1.0, 1.4, 2.8, 4.0, 100.0}) {
                const std::vector<double> lines = graded(cells, ratio), other = resized_lines(lines, size);
                EXPECT_EQ(other.front(), lines.front());
                EXPECT_EQ(other.back(), lines.back());
                EXPECT_EQ(other.size() - 1, static_cast<std::size_t>(std::max(1L, std::lround(cells / size))));
                EXPECT_EQ(std::adjacent_find(other.begin(), other.end(), std::greater_equal<>()), other.end());
                for (std::size_t i = 0; i + 1 < other.size(); ++i) {  // as large as the old cells there, times the size
                    const double n = static_cast<double>(lines.size() - 1) / static_cast<double>(other.size() - 1);
                    const auto first = static_cast<std::size_t>(n * static_cast<double>(i));
                    const auto last = std::min(lines.size() - 2, static_cast<std::size_t>(n * static_cast<double>(i + 1)));
                    const double h0 = lines[first + 1] - lines[first], h1 = lines[last + 1] - lines[last];
                    EXPECT_GE(other[i + 1] - other[i], n * std::min(h0, h1) * (1 - 1e-9));
                    EXPECT_LE(other[i + 1] - other[i], n * std::max(h0, h1) * (1 + 1e-9));
                }
            }
    EXPECT_EQ(resized_lines(graded(9, 1.2), 1), graded(9, 1.2));
}

StudyAnswer sample_answer(double factor, double shift, int points) {
    StudyAnswer answer;
    answer.energy = 2 * factor;
    answer.stress = 5 * factor;
    answer.probes = {{factor, 0}};
    answer.contacts.push_back({"a/left b/right", {3 * factor, 4 * factor}, factor, {}, {}, {}});
    StudyAnswer::Contact& c = answer.contacts.back();
    for (int k = 0; k <= points; ++k) {  // a parabola along a quarter of a circle
        const double t = static_cast<double>(k) / points, angle = t * std::numbers::pi / 2;
        c.x.push_back(std::cos(angle));
        c.y.push_back(std::sin(angle));
        c.pressure.push_back(factor * std::max(0.0, 1 - std::pow((t - 0.5 - shift) / 0.3, 2)));
    }
    return answer;
}

TEST(StudyDifferences, AreThoseThatWereMade) {
    const StudyAnswer reference = sample_answer(1, 0, 400);
    for (double e : differences(reference, reference)) EXPECT_NEAR(e, 0, 1e-12);
    for (double factor : {0.9, 1.01, 1.5})
        for (double e : differences(sample_answer(factor, 0, 400), reference)) EXPECT_NEAR(e, std::abs(factor - 1), 1e-9);
    EXPECT_EQ(differences(reference, reference).size(), measures_of(reference).size());
}

/// Other points on the same curve make no difference beyond what straight lines between them do; a pressure elsewhere does.
TEST(StudyDifferences, PressuresAreComparedPlaceByPlace) {
    const StudyAnswer reference = sample_answer(1, 0, 400);
    // straight lines over the two kinks are off by at most slope h / 4 for a length of h = 1 / 137: (6.7 / 137 / 4) sqrt(2 /
    // 137) over the root of the integral of the square, 0.57
    EXPECT_LT(differences(sample_answer(1, 0, 137), reference)[0], 2.6e-3);
    const double moved = differences(sample_answer(1, 0.01, 400), reference)[0];
    // of 1 - u^2 moved by d: d sqrt(int 4 u^2 / int (1 - u^2)^2) = d sqrt(2.5), d = 0.01 / 0.3
    EXPECT_NEAR(moved, std::sqrt(2.5) * 0.01 / 0.3, 0.02 * moved);
}

TEST(StudyDifferences, OtherContactsCannotBeCompared) {
    StudyAnswer other = sample_answer(1, 0, 50);
    other.contacts[0].between = "a/left c/right";
    const std::vector<double> list = differences(other, sample_answer(1, 0, 50));
    for (std::size_t k : {0U, 1U, 2U}) EXPECT_TRUE(std::isnan(list[k]));
    EXPECT_EQ(list[3], 0);  // the energy can
}

TEST(StudyReference, FindsTheProblemThatIsThisScene) {
    const auto name = [](const VerifyProblem* p) { return p ? p->name : "none"; };
    EXPECT_EQ(name(known(data + "/verification/hertz_001.json")), "C1-equal");
    EXPECT_EQ(name(known(data + "/verification/pin_in_hole.json")), "C6-pin");  // of the six with other parameters
    EXPECT_EQ(name(known(data + "/scenes/cam_follower.json")), "C1-cam");
    EXPECT_EQ(name(known(data + "/scenes/pin_bracket.json")), "none");
}

TEST(StudyReference, KnowsACopyAndNotASceneThatWasChanged) {
    const TemporaryFolder folder;
    const std::string text = file_text(data + "/verification/pin_in_hole.json");
    ASSERT_NE(known(folder.write("copy.json", text)), nullptr);
    std::string changed = text;
    changed.replace(changed.find("\"Q\": 100"), 8, "\"Q\": 200");
    EXPECT_EQ(known(folder.write("changed.json", changed)), nullptr);
    EXPECT_EQ(known_problem(folder.path("copy.json"), read_scene(folder.path("copy.json")), ""), nullptr);
}

TEST(StudyTransport, EveryNumberComesBackBitForBit) {
    StudyMeasured m;
    m.answer = sample_answer(1.0 / 3, 0.01, 30);
    m.run.message = "a \"message\"\n";
    m.run.unknowns = 1234;
    m.run.stage[3] = 0.1;
    m.run.estimated_error = 1e-3 / 7;
    m.run.passes = {{10, 2, 0.3, std::nullopt}, {20, 4, 0.7, 0.01}};
    m.known_error = {std::numeric_limits<double>::quiet_NaN(), 1e-300, 0.1};
    m.grids = {{"part", 0.1, {0, 1.0 / 3, 1}, {2, 3}}};
    m.problems = {{"here", "what", "hint"}};
    const StudyMeasured back = measured_from(measured_text(m));
    EXPECT_EQ(measured_text(back), measured_text(m));
    EXPECT_EQ(back.answer.contacts[0].pressure, m.answer.contacts[0].pressure);
    EXPECT_EQ(back.grids[0].x, m.grids[0].x);
    EXPECT_TRUE(std::isnan(back.known_error[0]));
    EXPECT_EQ(back.known_error[1], 1e-300);
    EXPECT_EQ(*back.run.estimated_error, 1e-3 / 7);
    EXPECT_FALSE(back.run.passes[0].estimated_error);
    EXPECT_EQ(*back.run.passes[1].estimated_error, 0.01);
    EXPECT_EQ(back.problems[0].hint, "hint");
}

}  // namespace
}  // namespace abut::study_measure_test
