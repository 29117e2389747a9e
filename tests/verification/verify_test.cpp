// SPDX-License-Identifier: GPL-3.0-or-later
// The registry of `abut verify`, its comparison and its texts; and each of its problems: what it says must be within tolerance.
#include "src/verification/verify.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "src/verification/verify_dissertation.hpp"

namespace abut::verify_test {
namespace {

namespace fs = std::filesystem;

const std::string data = ABUT_SOURCE_DIR "/data";

TEST(VerifyRegistry, UsesEverySceneOfItsFolderAndNoOther) {
    std::set<std::string> used, there;
    for (const VerifyProblem& problem : verify_problems())
        for (const VerifyRun& run : problem.runs) {
            EXPECT_TRUE(fs::is_regular_file(data + "/" + run.scene)) << problem.name << ": " << run.scene;
            used.insert(run.scene);
        }
    for (const DissertationTable& table : dissertation_tables())
        for (const auto& run : table.runs) {
            if (!run) continue;
            EXPECT_TRUE(fs::is_regular_file(data + "/" + run->scene)) << table.name << ": " << run->scene;
            used.insert(run->scene);
        }
    for (const auto& file : fs::directory_iterator(data + "/verification"))
        there.insert("verification/" + file.path().filename().string());
    EXPECT_GT(there.size(), 15U);
    for (const std::string& scene : there) EXPECT_TRUE(used.count(scene)) << scene << " is no problem's";
}

TEST(VerifyRegistry, NamesAreUniqueAndProblemsSayWhatTheyCompare) {
    std::set<std::string> names;
    for (const VerifyProblem& problem : verify_problems()) {
        EXPECT_TRUE(names.insert(problem.name).second) << problem.name;
        EXPECT_FALSE(problem.about.empty()) << problem.name;
        EXPECT_EQ(problem.runs.empty(), problem.name.rfind("E14", 0) == 0) << problem.name;
        EXPECT_FALSE(problem.quantities.empty()) << problem.name;
        for (const Quantity& q : problem.quantities)
            EXPECT_TRUE(q.scale > 0 || q.reference != 0) << problem.name << " " << q.what << ": relative to what?";
    }
}

TEST(VerifyRegistry, FindsProblemsByNameAndByGroup) {
    EXPECT_EQ(chosen_problems({}).size(), verify_problems().size());
    const auto one = chosen_problems({"E2-cubic"});
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(one[0].name, "E2-cubic");
    const auto group = chosen_problems({"E2", "E2-cubic"});
    EXPECT_EQ(group.size(), 6U) << "each once";
    for (const VerifyProblem& problem : group) EXPECT_EQ(problem.name.rfind("E2-", 0), 0U) << problem.name;
}

TEST(VerifyRegistry, RefusesEachUnknownNameWithTheNearest) {
    try {
        chosen_problems({"E2", "E2-cubik", "E99"});
        FAIL() << "accepted";
    } catch (const InputError& error) {
        ASSERT_EQ(error.problems().size(), 2U);
        EXPECT_NE(one_line(error.problems()[0]).find("did you mean 'E2-cubic'"), std::string::npos);
        EXPECT_NE(one_line(error.problems()[1]).find("'E99'"), std::string::npos);
    }
}

Quantity quantity(double reference, std::optional<double> tolerance, double scale = 0) {
    return {"q", {}, reference, tolerance, scale};
}

TEST(VerifyComparison, JudgesBothSidesOfItsTolerance) {
    EXPECT_TRUE(compared(quantity(-2, 0.01), -2.019).pass);
    EXPECT_FALSE(compared(quantity(-2, 0.01), -2.021).pass);
    EXPECT_FALSE(compared(quantity(-2, 0.01), 2).pass) << "the sign counts";
    EXPECT_TRUE(compared(quantity(0, 1e-9, 1), 0.9e-9).pass);
    EXPECT_FALSE(compared(quantity(0, 1e-9, 1), -1.1e-9).pass);
    EXPECT_NEAR(compared(quantity(3, 0.01), 3.03).relative_error, 0.01, 1e-14);
    EXPECT_NEAR(compared(quantity(0.5, 0.1, 1), 0.45).relative_error, 0.05, 1e-14);
}

TEST(VerifyComparison, WhatIsNoNumberMisses) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(compared(quantity(1, 0.01), nan).pass);
    EXPECT_FALSE(compared(quantity(1, std::nullopt), nan).pass);
    EXPECT_TRUE(compared(quantity(1, std::nullopt), 17).pass) << "recorded, not judged";
}

/// A problem with its references made wrong by twice their tolerance.
TEST(VerifyComparison, AWrongReferenceFails) {
    VerifyProblem problem = chosen_problems({"E2-cubic"}).at(0);
    for (const VerifyRow& row : verify(problem, data)) EXPECT_TRUE(row.pass) << row.quantity << " " << row.relative_error;
    for (Quantity& q : problem.quantities) q.reference += 2 * *q.tolerance * (q.scale > 0 ? q.scale : std::abs(q.reference));
    for (const VerifyRow& row : verify(problem, data)) EXPECT_FALSE(row.pass) << row.quantity;
}

/// Other loads than those that the reference is for.
TEST(VerifyComparison, AnotherProblemsAnswerFails) {
    VerifyProblem problem = chosen_problems({"E2-cubic"}).at(0);
    problem.runs[0].parameters["P"] = 1010;
    for (const VerifyRow& row : verify(problem, data)) EXPECT_FALSE(row.pass) << row.quantity;
}

TEST(VerifyComparison, AnAnalysisThatFailsGivesNoValue) {
    VerifyProblem problem = chosen_problems({"hold-slope"}).at(0);
    problem.expects_failure = false;
    const auto rows = verify(problem, data);
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_FALSE(rows[0].pass);
    EXPECT_TRUE(std::isnan(rows[0].value));
    EXPECT_NE(rows[0].failure.find("slides"), std::string::npos) << rows[0].failure;
}

TEST(VerifyComparison, AParameterThatTheSceneDoesNotHaveIsRefused) {
    VerifyProblem problem = chosen_problems({"E2-quadratic"}).at(0);
    problem.runs[0].parameters["Nx"] = 8;
    EXPECT_THROW(verify(problem, data), InputError);
}

std::vector<VerifyRow> sample_rows() {
    VerifyRow row = compared(quantity(-2, 0.01), -2.05);
    row.name = "E0-sample";
    row.unknowns = 12;
    row.seconds = 0.5;
    VerifyRow failed = compared(quantity(1, std::nullopt), std::numeric_limits<double>::quiet_NaN());
    return {row, failed};
}

TEST(VerifyText, JsonHasTheKeysOfTheContract) {
    const auto j = nlohmann::ordered_json::parse(verify_json(sample_rows()));
    ASSERT_EQ(j.size(), 2U);
    std::vector<std::string> keys;
    for (const auto& [key, value] : j[0].items()) keys.push_back(key);
    EXPECT_EQ(keys, (std::vector<std::string>{"name", "quantity", "value", "reference", "relative_error", "tolerance", "pass",
                                              "unknowns", "seconds"}));
    EXPECT_EQ(j[0]["value"], -2.05);
    EXPECT_EQ(j[0]["pass"], false);
    EXPECT_TRUE(j[1]["value"].is_null());
    EXPECT_TRUE(j[1]["tolerance"].is_null());
}

TEST(VerifyText, TableShowsWhatMissed) {
    const std::string table = verify_table(sample_rows());
    EXPECT_NE(table.find("MISSED"), std::string::npos) << table;
    EXPECT_NE(table.find("E0-sample"), std::string::npos) << table;
    EXPECT_NE(table.find("0 of 2 quantities"), std::string::npos) << table;
}

/// Longer than half a second, by measurement.
bool is_long(const std::string& name) {
    static const std::set<std::string> names{"E3-fine", "C1-cam", "S-D", "S-D-rigid"};
    return names.count(name) > 0;
}

std::vector<std::string> problem_names(bool long_ones) {
    std::vector<std::string> names;
    for (const VerifyProblem& problem : verify_problems())
        if (is_long(problem.name) == long_ones) names.push_back(problem.name);
    return names;
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

class Verification : public ::testing::TestWithParam<std::string> {};

TEST_P(Verification, IsWithinItsTolerances) {
    for (const VerifyRow& row : verify(chosen_problems({GetParam()}).at(0), data))
        EXPECT_TRUE(row.pass) << row.quantity << " = " << row.value << ", not " << row.reference << ": off by "
                              << row.relative_error << " " << row.failure;
}

INSTANTIATE_TEST_SUITE_P(Problems, Verification, ::testing::ValuesIn(problem_names(false)), test_name);
INSTANTIATE_TEST_SUITE_P(Long, Verification, ::testing::ValuesIn(problem_names(true)), test_name);

}  // namespace
}  // namespace abut::verify_test
