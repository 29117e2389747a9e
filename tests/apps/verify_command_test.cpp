// SPDX-License-Identifier: GPL-3.0-or-later
// `abut verify` from outside: exit status, table, JSON, list, and what it refuses.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/apps/command_line.hpp"

namespace {

using namespace abut_tests;

/// E2's scene in a data folder of its own, with one text in it replaced.
void copy_cantilever(const fs::path& folder, const std::string& from, const std::string& to) {
    std::string text = read(fs::path(ABUT_SOURCE_DIR) / "data/verification/cantilever.json");
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, from.size(), to);
    fs::create_directories(folder / "verification");
    std::ofstream(folder / "verification/cantilever.json") << text;
}

TEST_F(CommandLine, VerifyPassesAndFindsItsScenesFromAnywhere) {
    const Outcome run = abut({"verify", "E2-quadratic"});
    EXPECT_EQ(run.status, 0) << joined(run.errors);
    EXPECT_TRUE(run.errors.empty()) << joined(run.errors);
    expect_words(run.output, {"problem", "quantity", "value", "reference", "rel. error", "tolerance", "unknowns", "seconds"});
    EXPECT_TRUE(any_line_has(lines_of(run.output), {"E2-quadratic", "v(48, 0)", "-0.0089", "pass"})) << run.output;
    EXPECT_EQ(run.output.find("MISSED"), std::string::npos);
}

TEST_F(CommandLine, VerifySaysWhatMissesAndExitsWithOne) {
    copy_cantilever(folder_, "\"P\": 1000", "\"P\": 1010");
    const Outcome run = abut({"verify", "E2-quadratic", "--data", folder_.string()});
    EXPECT_EQ(run.status, 1);
    EXPECT_TRUE(any_line_has(lines_of(run.output), {"v(48, 0)", "MISSED"})) << run.output;
    expect_words(run.output, {"0 of 4 quantities"});
}

TEST_F(CommandLine, VerifyOfASceneThatCannotBeReadIsWrongInput) {
    copy_cantilever(folder_, "\"supports\"", "\"suports\"");
    const Outcome run = abut({"verify", "E2-quadratic", "--data", folder_.string()});
    expect_refused(run, 1);
    expect_words(joined(run.errors), {"suports", "cantilever.json"});
}

TEST_F(CommandLine, VerifyJsonParses) {
    const Outcome run = abut({"verify", "--json", "E2-quadratic", "hold-slope"});
    EXPECT_EQ(run.status, 0) << joined(run.errors);
    const auto j = nlohmann::json::parse(run.output);
    ASSERT_EQ(j.size(), 6U);
    EXPECT_TRUE(j[4]["tolerance"].is_null()) << "recorded only";
    for (const auto& row : j)
        for (const char* key :
             {"name", "quantity", "value", "reference", "relative_error", "tolerance", "pass", "unknowns", "seconds"})
            EXPECT_TRUE(row.contains(key)) << key;
    EXPECT_EQ(j[0]["name"], "E2-quadratic");
    EXPECT_EQ(j[0]["pass"], true);
    EXPECT_GT(j[0]["unknowns"], 0);
}

TEST_F(CommandLine, VerifyListsWithoutSolving) {
    const Outcome all = abut({"verify", "--list"});
    EXPECT_EQ(all.status, 0);
    EXPECT_GT(lines_of(all.output).size(), 20U);
    expect_words(all.output, {"dissertation"});
    EXPECT_EQ(lines_of(abut({"verify", "dissertation", "--list"}).output).size(), 1U);
    const Outcome group = abut({"verify", "E8", "--list"});
    for (const std::string& line : lines_of(group.output)) EXPECT_EQ(line.rfind("E8-", 0), 0U) << line;
    EXPECT_FALSE(group.output.empty());
}

TEST_F(CommandLine, VerifyRefusesWhatItDoesNotKnow) {
    Outcome run = abut({"verify", "E2-quadratik"});
    expect_refused(run, 1);
    expect_words(joined(run.errors), {"'E2-quadratik'", "did you mean 'E2-quadratic'", "--list"});

    run = abut({"verify", "dissertation", "E99"});
    expect_refused(run, 1);
    expect_words(joined(run.errors), {"'E99'"});

    run = abut({"verify", "E2", "--data", folder_.string()});
    expect_refused(run, 1);
    expect_words(joined(run.errors), {"--data", "verification"});
}

}  // namespace
