// SPDX-License-Identifier: GPL-3.0-or-later
// abut study as a user calls it.
#include <nlohmann/json.hpp>

#include "tests/apps/command_line.hpp"

namespace abut_tests::study_command_test {
namespace {

class StudyCommand : public CommandLine {};

TEST_F(StudyCommand, WritesThreeFilesAndPrintsATable) {
    write("scene.json", SceneText{}.text());
    const Outcome run = abut({"study", "scene.json", "-o", "here", "--once"});
    EXPECT_EQ(run.status, 0) << joined(run.errors);
    EXPECT_TRUE(run.errors.empty()) << joined(run.errors);
    expect_words(run.output, {"setting", "unknowns", "standard", "study: here/study.html"});
    const auto json = nlohmann::json::parse(read(folder_ / "here/study.json"));
    EXPECT_EQ(lines_of(read(folder_ / "here/study.csv")).size(), json["runs"].size() + 1);
    EXPECT_NE(read(folder_ / "here/study.html").find("</html>"), std::string::npos);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "here"), fs::directory_iterator()), 3);  // no temporary ones
}

TEST_F(StudyCommand, PrintsItsJsonOrNothing) {
    write("scene.json", SceneText{}.text());
    const Outcome json = abut({"study", "scene.json", "--json", "--once", "--budget", "2"});
    EXPECT_TRUE(nlohmann::json::parse(json.output).contains("runs"));
    EXPECT_EQ(abut({"study", "scene.json", "--quiet", "--budget=0.005min"}).output, "");
}

TEST_F(StudyCommand, RefusesWrongUsageAndWrongScenes) {
    expect_refused(abut({"study", "missing.json"}), 1);
    write("scene.json", SceneText{}.text());
    for (const char* budget : {"-3", "0s", "2GB", "30s,2GB", "soon"})
        expect_refused(abut({"study", "scene.json", "--budget", budget}), 1);
    expect_refused(abut({"study", "scene.json", "--threads", "1.5"}), 1);
    expect_refused(abut({"study", "scene.json", "--data", "."}), 1);
    SceneText wrong;
    wrong.supports = R"([{"on": "block/botom", "fix": ["x"]}])";
    write("wrong.json", wrong.text());
    const Outcome run = abut({"study", "wrong.json"});
    expect_refused(run, 1);
    expect_words(joined(run.errors), {"botom", "bottom"});
}

TEST_F(StudyCommand, FailsWhereNoLevelGivesAnAnswer) {
    SceneText loose;
    loose.supports = "[]";
    write("loose.json", loose.text());
    const Outcome run = abut({"study", "loose.json", "--budget", "5"});
    EXPECT_EQ(run.status, 1);
    ASSERT_EQ(run.errors.size(), 1U);
    expect_words(run.errors[0], {"loose.json", "the analysis failed", "nothing holds"});
    EXPECT_TRUE(fs::exists(folder_ / "out/study.html"));
}

}  // namespace
}  // namespace abut_tests::study_command_test
