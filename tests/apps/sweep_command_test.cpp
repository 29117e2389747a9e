// SPDX-License-Identifier: GPL-3.0-or-later
// abut sweep, and abut analyze with load cases, as a user calls them.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/apps/command_line.hpp"
#include "tests/src/reference/schema_check.hpp"

namespace abut_tests::sweep_command_test {
namespace {

using namespace schema_check;

const std::string data = std::string(ABUT_SOURCE_DIR) + "/data/";

TEST_F(CommandLine, SweepFollowsHertz) {
    const std::string scene = data + "verification/cylinder_on_plane.json";
    const Outcome run = abut({"sweep", scene, "Q=100,400", "-o", "o", "--accuracy", "draft"});
    EXPECT_EQ(run.status, 0) << joined(run.errors);
    EXPECT_TRUE(any_line_has(lines_of(run.output), {"curves: o/sweep.html"})) << run.output;
    const std::vector<std::string> rows = lines_of(read(folder_ / "o/sweep.csv"));
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].rfind("job,status,Q,cylinder - block: max pressure,cylinder - block: error of max pressure,", 0), 0U)
        << rows[0];
    const auto pressure = [](const std::string& row) {
        std::istringstream fields(row);
        std::string field;
        for (int k = 0; k < 4; ++k) std::getline(fields, field, ',');
        return std::stod(field);
    };
    EXPECT_NEAR(pressure(rows[2]) / pressure(rows[1]), 2, 0.1) << "the root of the force's ratio";
    EXPECT_NE(read(folder_ / "o/sweep.html").find("<polyline"), std::string::npos);
    const Outcome again = abut({"sweep", scene, "Q=100,400", "-o", "o", "--accuracy", "draft"});
    EXPECT_TRUE(any_line_has(lines_of(again.output), {"0 done now", "2 kept from before"})) << again.output;
    // Other values by the same places are other jobs, whatever is there.
    const Outcome other = abut({"sweep", scene, "Q=900,1600", "-o", "o", "--accuracy", "draft"});
    EXPECT_EQ(other.status, 0) << joined(other.errors);
    EXPECT_NEAR(pressure(lines_of(read(folder_ / "o/sweep.csv"))[1]) / pressure(rows[1]), 3, 0.15);
}

TEST_F(CommandLine, SweepMarksWhatHasNoAnswer) {
    const Outcome run =
        abut({"sweep", data + "verification/cylinder_on_plane.json", "Q=-100:100:2", "-o", "o", "--accuracy", "draft"});
    EXPECT_EQ(run.status, 1);
    EXPECT_TRUE(any_line_has(run.errors, {"1: failed: ", "cylinder"})) << joined(run.errors);
    EXPECT_NE(read(folder_ / "o/sweep.csv").find("1,failed,-100,"), std::string::npos);
    EXPECT_NE(read(folder_ / "o/sweep.html").find("class=\"failed\""), std::string::npos);
}

TEST_F(CommandLine, SweepRefusesWhatItDoesNotUnderstand) {
    const std::string scene = data + "verification/cylinder_on_plane.json";
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"sweep"},
                                               {"sweep", scene},
                                               {"sweep", scene, "q=1,2"},
                                               {"sweep", scene, "Q=1:2"},
                                               {"sweep", scene, "Q=1", "Q=2"},
                                               {"sweep", "no_such.json", "Q=1"},
                                               {"sweep", data + "scenes/pin_bracket_cases.json", "Q=1"}})
        expect_refused(abut(words), 1);
    EXPECT_FALSE(fs::exists(folder_ / "out"));
    EXPECT_NE(joined(abut({"sweep", scene, "q=1"}).errors).find("'q' is no parameter of"), std::string::npos);
    write("p.json", R"({"abut": 1, "title": "of F", "parameters": {"F": 1, "F2": 2, "G": "F2", "K": 3, "H": "2*K"},
        "materials": {"m": {"E": "H", "nu": 0}}})");
    const auto is_unused = [&](const std::string& name) {
        const std::string errors = joined(abut({"sweep", "p.json", name + "=1,2"}).errors);
        return errors.find("nothing in p.json uses its parameter '" + name + "'") != std::string::npos;
    };
    for (const char* name : {"F", "F2", "G"}) EXPECT_TRUE(is_unused(name)) << name;
    for (const char* name : {"H", "K"}) EXPECT_FALSE(is_unused(name)) << name;
}

TEST_F(CommandLine, AnalyzeWritesEveryLoadCaseAndWhatIsLargest) {
    const std::string scene = data + "scenes/pin_bracket_cases.json";
    const Outcome run = abut({"analyze", scene, "-o", "o", "--accuracy", "draft"});
    EXPECT_EQ(run.status, 0) << joined(run.errors);
    EXPECT_TRUE(any_line_has(lines_of(run.output), {"4", "overload"})) << run.output;
    const Json schema = json_of(schema_file("cases")), cases = Json::parse(read(folder_ / "o/cases.json"));
    SchemaCheck check(schema);
    EXPECT_EQ(in_lines(check.faults(cases)), "");
    ASSERT_EQ(cases["cases"].size(), 4U);
    double largest = 0;
    for (int k = 1; k <= 4; ++k) {
        const Json result = Json::parse(read(folder_ / ("o/case_" + std::to_string(k)) / "result.json"));
        largest = std::max(largest, result["contacts"][0]["max_pressure"]["value"].get<double>());
        EXPECT_TRUE(fs::exists(folder_ / ("o/case_" + std::to_string(k)) / "report.html"));
        EXPECT_TRUE(fs::exists(folder_ / ("o/case_" + std::to_string(k)) / "contact_2.csv"));
    }
    EXPECT_EQ(cases["envelope"]["contacts"][0]["max_pressure"]["value"], largest);
    EXPECT_EQ(cases["envelope"]["contacts"][0]["max_pressure"]["case"], "overload");
    EXPECT_EQ(lines_of(read(folder_ / "o/envelope.csv")).size(), 1U + 2 * 3 + 3 * 3);
    EXPECT_NE(read(folder_ / "o/report.html").find("case_4/report.html"), std::string::npos);

    // One case alone, into the same folder: nothing of the others is left there.
    const Outcome one = abut({"analyze", scene, "--case", "overload", "-o", "o", "--accuracy", "draft"});
    EXPECT_EQ(one.status, 0) << joined(one.errors);
    EXPECT_TRUE(fs::exists(folder_ / "o/result.json"));
    for (const char* file : {"cases.json", "envelope.csv", "case_1", "case_4"})
        EXPECT_FALSE(fs::exists(folder_ / "o" / file)) << file;

    // An analysis leaves alone what is no case of an earlier one.
    fs::create_directories(folder_ / "o/case_1");
    write("o/case_1/result.json", "mine");
    abut({"analyze", scene, "--case", "overload", "-o", "o", "--accuracy", "draft", "--quiet"});
    EXPECT_EQ(read(folder_ / "o/case_1/result.json"), "mine");

    EXPECT_TRUE(any_line_has(abut({"analyze", scene, "--case", "overlaod"}).errors, {"did you mean 'overload'"}));
    EXPECT_TRUE(any_line_has(abut({"study", scene}).errors, {"load cases"}));
}

TEST_F(CommandLine, AnalyzeSaysWhichCaseFailed) {
    write("scene.json",
          R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}}, "supports": [{"on": "low/bottom", "fix": ["x", "y"]}],
        "parts": [{"name": "low", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [4, 2]}}},
                  {"name": "high", "material": "m", "geometry": {"rectangle": {"min": [1, 2], "max": [3, 4]}}}],
        "loads": [{"name": "p", "on": "high/top", "pressure": 1}], "output": {"formats": ["json"]},
        "cases": [{"name": "down", "loads": {"p": 1}}, {"name": "up", "loads": {"p": -1}}],
        "expect": [{"case": "down", "quantity": "contacts[0].force[1]", "value": -2, "tolerance": 1e-6},
                   {"case": "up", "quantity": "contacts[0].force[1]", "value": 0, "tolerance": 1e-6}]})");
    const Outcome run = abut({"analyze", "scene.json", "-o", "o"});
    EXPECT_EQ(run.status, 1);
    EXPECT_TRUE(any_line_has(run.errors, {"the analysis failed: up: "})) << joined(run.errors);
    EXPECT_TRUE(any_line_has(run.errors, {"not as expected"})) << joined(run.errors);
    const Outcome verified = abut({"verify", "."});
    EXPECT_EQ(verified.status, 1);
    EXPECT_TRUE(any_line_has(lines_of(verified.output), {"down: contacts[0].force[1]", "pass"})) << verified.output;
    EXPECT_TRUE(any_line_has(lines_of(verified.output), {"up: contacts[0].force[1]"})) << verified.output;
    const Json cases = Json::parse(read(folder_ / "o/cases.json"));
    EXPECT_EQ(cases["cases"][0]["status"], "ok");
    EXPECT_EQ(cases["cases"][1]["status"], "failed");
    EXPECT_EQ(cases["verdict"], "failed");
}

}  // namespace
}  // namespace abut_tests::sweep_command_test
