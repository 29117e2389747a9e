// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "geometry/brep/input_error.hpp"
#include "src/io/write_file.hpp"
#include "tests/src/results/synthetic_result.hpp"

namespace abut::result_json_test {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> keys(const Json& j) {
    std::vector<std::string> names;
    for (const auto& [key, value] : j.items()) names.push_back(key);
    return names;
}

using Names = std::vector<std::string>;

TEST(ResultJson, HasTheKeysOfTheContractInItsOrder) {
    const Json j = Json::parse(result_json(synthetic::bracket()));
    EXPECT_EQ(keys(j), (Names{"abut",     "title",         "status",      "build",          "verdict",  "reasons",
                              "unknowns", "degree",        "multipliers", "cells",          "solver",   "timing",
                              "effects",  "strain_energy", "equilibrium", "error_estimate", "accuracy", "parts",
                              "contacts", "mobility",      "reactions",   "probes",         "warnings", "notes"}));
    EXPECT_EQ(keys(j["solver"]), (Names{"grids", "factorizations", "contact_iterations", "condition_estimate", "converged",
                                        "groups", "contact_problems"}));
    EXPECT_EQ(keys(j["effects"][0]), (Names{"name", "on", "why", "parts", "pairs", "seconds", "share", "items"}));
    EXPECT_EQ(keys(j["timing"]), (Names{"import", "geometry", "assembly", "solve", "recovery", "output", "total"}));
    EXPECT_EQ(keys(j["equilibrium"]), (Names{"applied", "reaction", "relative_residual", "relative_moment_residual"}));
    EXPECT_EQ(keys(j["parts"][0]), (Names{"name", "area", "unknowns", "solved", "rigid", "max_displacement", "max_von_mises",
                                          "utilisation", "cells", "self_check"}));
    EXPECT_EQ(keys(j["contacts"][0]), (Names{"parts", "between", "edges", "kind", "interface", "functional_interface", "status",
                                             "initial_gap", "force", "moment", "contact_length", "ends", "max_pressure",
                                             "max_penetration", "error_estimate", "errors", "profile"}));
    EXPECT_EQ(keys(j["contacts"][0]["profile"]), (Names{"edge", "s", "x", "y", "pressure", "gap"}));
    EXPECT_EQ(keys(j["reactions"][0]), (Names{"support", "force", "moment", "method", "why"}));
    EXPECT_EQ(keys(j["probes"][0]), (Names{"part", "at", "displacement", "stress"}));
    EXPECT_EQ(keys(j["probes"][0]["stress"]), (Names{"xx", "yy", "xy", "zz"}));
}

TEST(ResultJson, NumbersReadBackToTheLastBit) {
    Result r = synthetic::bracket();
    r.strain_energy = 0.1 + 0.2;
    r.contacts[0].profile.pressure[7] = 1.0 / 3;
    r.contacts[0].profile.gap[7] = 5e-324;
    const Json j = Json::parse(result_json(r));
    EXPECT_EQ(j["strain_energy"].get<double>(), 0.1 + 0.2);
    EXPECT_EQ(j["contacts"][0]["profile"]["pressure"][7].get<double>(), 1.0 / 3);
    EXPECT_EQ(j["contacts"][0]["profile"]["gap"][7].get<double>(), 5e-324);
    EXPECT_EQ(j["contacts"][0]["profile"]["s"].get<std::vector<double>>(), r.contacts[0].profile.s);
}

TEST(ResultJson, ValuesStandWhereTheyBelong) {
    const Result r = synthetic::bracket();
    const Json j = Json::parse(result_json(r));
    EXPECT_EQ(j["contacts"][0]["edges"], Json::parse(R"([["bracket/hole"], ["pin/circle"]])"));
    EXPECT_EQ(j["contacts"][0]["ends"][1][0].get<double>(), r.contacts[0].ends[1].x());
    EXPECT_EQ(j["contacts"][0]["max_pressure"]["at"][1].get<double>(), r.contacts[0].max_pressure.at.y());
    EXPECT_EQ(j["reactions"][1]["support"], 1);
    EXPECT_EQ(j["error_estimate"]["contact_pressure"], 0.03);
    EXPECT_TRUE(j["error_estimate"]["energy"].is_null());
    EXPECT_EQ(j["cells"], Json::parse(R"({"inner": 1250, "boundary": 280, "outer": 70})"));
}

TEST(ResultJson, WhatIsNotFiniteIsNull) {
    Result r = synthetic::bracket();
    r.strain_energy = std::numeric_limits<double>::quiet_NaN();
    r.contacts[0].profile.pressure[3] = -std::numeric_limits<double>::infinity();
    const std::string text = result_json(r);
    const Json j = Json::parse(text);
    EXPECT_TRUE(j["strain_energy"].is_null());
    EXPECT_TRUE(j["contacts"][0]["profile"]["pressure"][3].is_null());
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(text.find("inf\""), std::string::npos);
}

TEST(ResultJson, FailedSaysWhyAndClaimsNoAnswer) {
    Result r;
    r.status = "failed";
    r.message = "part pin moves freely";
    r.parts.emplace_back();
    r.parts[0].name = "pin";
    r.parts[0].area = 3;
    const Json j = Json::parse(result_json(r));
    EXPECT_EQ(keys(j)[3], "message");
    EXPECT_EQ(j["message"], "part pin moves freely");
    EXPECT_EQ(j["parts"][0]["area"], 3.0);
    EXPECT_TRUE(j["parts"][0]["max_von_mises"].is_null());
    EXPECT_TRUE(j["equilibrium"].is_null());
}

TEST(ResultJson, EmptyResultAndStrangeNamesAreValidJson) {
    Result r;
    EXPECT_TRUE(Json::accept(result_json(r)));
    r.title = "a \"quoted\" <title>\n\x01 \xff";
    EXPECT_TRUE(Json::accept(result_json(r)));
    EXPECT_EQ(Json::parse(result_json(r))["contacts"], Json::array());
}

TEST(ContactCsv, OneExactRowPerPointAndQuotedNames) {
    ContactResult c;
    c.profile.edge = {"jaw/left", "jaw/a,\"b\""};
    c.profile.s = {0.1, 1.0 / 3};
    c.profile.x = {1, 2};
    c.profile.y = {-1, 1e-20};
    c.profile.pressure = {5, std::numeric_limits<double>::quiet_NaN()};
    c.profile.gap = {0, 0.25};
    EXPECT_EQ(contact_csv(c),
              "edge,s,x,y,pressure,gap\njaw/left,0.1,1,-1,5,0\n\"jaw/a,\"\"b\"\"\",0.3333333333333333,2,1e-20,,0.25\n");
}

TEST(VonMises, ClosedForms) {
    EXPECT_DOUBLE_EQ(von_mises({100, 0, 0, 0}), 100);
    EXPECT_DOUBLE_EQ(von_mises({0, 0, 10, 0}), 10 * std::sqrt(3.0));
    EXPECT_EQ(von_mises({1e9, 1e9, 0, 1e9}), 0);
    EXPECT_DOUBLE_EQ(von_mises({3, 3, 0, 0}), 3);
}

TEST(ResultTable, ShowsContactsReactionsAndResidualInAlignedColumns) {
    const std::string table = result_table(synthetic::bracket());
    std::istringstream lines(table);
    std::string line;
    std::size_t pressure_column = std::string::npos;
    bool found = false;
    while (std::getline(lines, line)) {
        EXPECT_TRUE(line.empty() || line.back() != ' ') << line;
        if (line.rfind("contact", 0) == 0) pressure_column = line.find("max pressure [MPa]");
        if (line.rfind("1        bracket/hole - pin/circle", 0) == 0) found = line.find("132.4") == pressure_column;
    }
    EXPECT_TRUE(found) << table;
    EXPECT_NE(table.find("fix x, y on bracket/bottom"), std::string::npos);
    EXPECT_NE(table.find("residual 3.1e-13"), std::string::npos);
    EXPECT_NE(table.find("3528 unknowns"), std::string::npos);
    EXPECT_EQ(table.find("e-12"), std::string::npos) << "rounding beside 1000 N is 0";
}

TEST(ResultTable, FailureComesFirst) {
    Result r;
    r.status = "failed";
    r.message = "no way";
    EXPECT_EQ(result_table(r), "FAILED: no way\n");
}

namespace fs = std::filesystem;

class WriteFile : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) / ("write_file_" + std::to_string(::getpid()));
        fs::remove_all(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    static std::string read(const fs::path& file) {
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    fs::path folder_;
};

TEST_F(WriteFile, MakesTheFolderReplacesTheFileAndLeavesNothingElse) {
    const fs::path deep = folder_ / "a/b";
    write_file(deep.string(), "x.json", "a longer first text");
    write_file(deep.string(), "x.json", "second\n");
    EXPECT_EQ(read(deep / "x.json"), "second\n");
    EXPECT_EQ(std::distance(fs::directory_iterator(deep), fs::directory_iterator()), 1);
}

TEST_F(WriteFile, ErrorsNameTheFileAndTheReason) {
    write_file(folder_.string(), "plain", "not a folder");
    const auto message = [&](const std::string& directory, const std::string& name) {
        try {
            write_file(directory, name, "text");
        } catch (const InputError& error) { return std::string(error.what()); }
        return std::string("no error");
    };
    const std::string below_a_file = message((folder_ / "plain").string(), "x.json");
    EXPECT_NE(below_a_file.find("plain/x.json: cannot be written: "), std::string::npos) << below_a_file;
    fs::create_directories(folder_ / "taken.json" / "full");
    const std::string onto_a_folder = message(folder_.string(), "taken.json");
    EXPECT_NE(onto_a_folder.find("directory"), std::string::npos) << onto_a_folder;
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 2)
        << "a temporary file was left behind";
}

}  // namespace
}  // namespace abut::result_json_test
