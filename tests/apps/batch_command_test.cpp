// SPDX-License-Identifier: GPL-3.0-or-later
// abut batch and abut merge as a user calls them.
#include <signal.h>
#include <sys/mount.h>
#include <sys/statvfs.h>

#include <nlohmann/json.hpp>

#include "geometry/foreign/reader_main.hpp"
#include "tests/apps/batch_folder.hpp"

namespace abut_tests::batch_command_test {
namespace {

const std::string data = std::string(ABUT_SOURCE_DIR) + "/data/";

TEST_F(BatchCommand, AnalysesATableThroughATemplate) {
    write_sketches(2);
    write("jobs.csv", "file,name,P\nin/s0.dxf,light,100\nin/s0.dxf,heavy,200\nin/s1.dxf,,\n");
    const Outcome run = abut({"batch", "jobs.csv", "--template", "template.json", "-o", "o", "-j", "2"});
    EXPECT_EQ(run.status, 0) << joined(run.errors);
    EXPECT_TRUE(any_line_has(lines_of(run.output), {"3 jobs: 3 solved_but"})) << run.output;
    EXPECT_TRUE(any_line_has(lines_of(run.output), {"solved_but heavy: ", "2 parts, 1 pair, peak pressure"})) << run.output;
    const auto light = result("o", "light"), heavy = result("o", "heavy"), plain = result("o", "0003-in-s1.dxf");
    EXPECT_NEAR(light["equilibrium"]["applied"][1].get<double>(), -100, 1e-6);
    EXPECT_NEAR(heavy["equilibrium"]["applied"][1].get<double>(), -200, 1e-6);
    EXPECT_NEAR(plain["equilibrium"]["applied"][1].get<double>(), -50, 1e-6);
    const auto summary = nlohmann::json::parse(read(folder_ / "o/summary.json"));
    EXPECT_EQ(summary["counts"]["solved_but"], 3);
    EXPECT_EQ(summary["jobs"][1]["name"], "heavy");
    EXPECT_EQ(summary["jobs"][1]["parameters"]["P"], 200);
    EXPECT_GT(summary["jobs"][1]["max_pressure"], summary["jobs"][0]["max_pressure"]);
    EXPECT_EQ(lines_of(read(folder_ / "o/summary.csv")).size(), 4U);
    const std::string page = read(folder_ / "o/index.html");
    for (const char* text : {"jobs/heavy/thumbnail.svg", "jobs/heavy/result.json", "P = 200", "</html>"})
        EXPECT_NE(page.find(text), std::string::npos) << text;
}

TEST_F(BatchCommand, AnswersWithReservationsAreShownAndAreNoFailures) {
    SceneText scene;
    scene.supports = R"([{"on": "block/bottom", "symmetry": true}, {"on": "block/left", "symmetry": true}])";
    fs::create_directory(folder_ / "scenes");
    write("scenes/reached.json", scene.text());
    scene.material = R"({"E": 210000, "nu": 0.3, "yield": 0.4})";
    write("scenes/yields.json", scene.text());
    const Outcome run = abut({"batch", "scenes", "-o", "o"});
    EXPECT_EQ(run.status, 0);
    EXPECT_TRUE(run.errors.empty()) << joined(run.errors);
    EXPECT_TRUE(any_line_has(lines_of(run.output), {"2 jobs: 1 ok, 1 solved_but"})) << run.output;
    EXPECT_TRUE(any_line_has(lines_of(run.output), {"solved_but yields.json: block at 2.5 times its yield; 1 part, "}))
        << run.output;
    const auto job = nlohmann::json::parse(read(folder_ / "o/jobs/yields.json/job.json"));
    EXPECT_EQ(job["status"], "solved_but");
    EXPECT_EQ(job["message"], "block at 2.5 times its yield");
    EXPECT_NEAR(job["max_von_mises"].get<double>(), 1, 1e-6);
    EXPECT_EQ(abut({"merge", "o"}).status, 0);
}

TEST_F(BatchCommand, OneBadFileIsItsOwnResultAndStopsNothing) {
    write_sketches(2);
    write("in/bad.dxf", "0\nSECTION\n");
    write("in/b.json", "{\"some\": \"thing\"}");
    write("in/c.igs", "");
    write("in/read.me", "");
    write("in/LICENCE", "");
    const Outcome run = abut({"batch", "in", "-o", "o", "-j", "2"});
    EXPECT_EQ(run.status, 1);
    EXPECT_TRUE(any_line_has(lines_of(run.output), {"5 jobs: 2 ok, 3 refused"})) << run.output;
    ASSERT_EQ(run.errors.size(), 4U) << joined(run.errors);
    EXPECT_TRUE(any_line_has(run.errors, {"left out", "1 without an ending, 1 .me"}));
    EXPECT_TRUE(any_line_has(run.errors, {"b.json", "no scene", "'abut'"}));
    EXPECT_TRUE(any_line_has(run.errors, {"c.igs", "'.igs' cannot be read"}));
    EXPECT_TRUE(any_line_has(run.errors, {"bad.dxf", "refused"}));
    const std::string page = read(folder_ / "o/index.html");
    EXPECT_LT(page.find(">bad.dxf<"), page.find(">s0.dxf<"));  // failures first
    EXPECT_EQ(abut({"batch", "in", "-o", "o"}).status, 1);     // kept, and still no success
}

TEST_F(BatchCommand, GoesOnWhereItStoppedAndForces) {
    write_sketches(3);
    const std::vector<std::string> call{"batch", "in", "-o", "o", "--only", "contacts"};
    abut(call);
    EXPECT_TRUE(any_line_has(lines_of(abut(call).output), {"3 kept from before"}));
    write_sketches(4);
    EXPECT_TRUE(any_line_has(lines_of(abut(call).output), {"1 done now", "3 kept from before"}));
    auto forced = call;
    forced.emplace_back("--force");
    EXPECT_TRUE(any_line_has(lines_of(abut(forced).output), {"4 done now", "0 kept"}));
    auto finer = call;
    finer.insert(finer.end(), {"--distance", "0.5"});
    EXPECT_TRUE(any_line_has(lines_of(abut(finer).output), {"4 done now", "0 kept"}));
}

TEST_F(BatchCommand, ResultsDoNotDependOnWorkersOrShards) {
    write_sketches(5);
    const std::vector<std::string> call{"batch", "in", "--template", "template.json", "--quiet"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), call.begin(), call.end());
        const Outcome run = abut(more);
        EXPECT_EQ(run.status, 0) << joined(run.errors);
    };
    with({"-o", "one", "-j", "1"});
    with({"-o", "three", "-j", "3"});
    for (const char* shard : {"1/3", "2/3", "3/3"}) with({"-o", std::string("shard") + shard[0], "--shard", shard});
    for (const char* shard : {"1/2", "2/2"}) with({"-o", "shared", "--shard", shard});
    EXPECT_EQ(abut({"merge", "shard1", "shard2", "shard3", "-o", "merged"}).status, 0);
    EXPECT_EQ(abut({"merge", "shared"}).status, 0);
    const auto answers = answers_of("one");
    EXPECT_GT(answers.size(), 5U * 3U);
    for (const char* out : {"three", "merged", "shared"}) EXPECT_EQ(answers_of(out), answers) << out;
    // The comparison sees a single digit.
    write("three/jobs/s1.dxf/result.json",
          std::regex_replace(read(folder_ / "three/jobs/s1.dxf/result.json"), std::regex("\"unknowns\": "), "\"unknowns\": 1"));
    EXPECT_NE(answers_of("three"), answers);
}

TEST_F(BatchCommand, ShardsOfDifferentTemplatesOrTablesAreNotMerged) {
    write_sketches(2);
    write("jobs.csv", "file,P\nin/s0.dxf,1\nin/s1.dxf,2\n");
    const auto shard = [&](const char* which, const char* out) {
        EXPECT_EQ(abut({"batch", "jobs.csv", "--template", "template.json", "--shard", which, "-o", out, "--quiet"}).status, 0);
    };
    shard("1/2", "one");
    write("jobs.csv", "file,P\nin/s0.dxf,1\nin/s1.dxf,3\n");
    shard("2/2", "two");
    const Outcome tables = abut({"merge", "one", "two", "-o", "o"});
    expect_refused(tables, 1);
    expect_words(tables.errors.at(0), {"two", "another batch than one", "parameter P of job 2", "is 2 in one and 3 in two"});
    write("template.json", std::string(block_template) + " ");
    shard("1/2", "one");
    const Outcome templates = abut({"merge", "one", "two", "-o", "o"});
    expect_refused(templates, 1);
    expect_words(templates.errors.at(0), {"two", "another batch than one", "templates"});
    shard("1/2", "two");  // into a folder with a job of the old template
    const Outcome mixed = abut({"merge", "two"});
    EXPECT_EQ(mixed.status, 1);
    EXPECT_TRUE(any_line_has(mixed.errors, {"1 job is there from another batch", "0002-in-s1.dxf"})) << joined(mixed.errors);
    shard("2/2", "two");
    EXPECT_EQ(abut({"merge", "two"}).status, 0);
}

TEST_F(BatchCommand, IsAShardInASlurmArray) {
    write_sketches(4);
    const std::string variables = "SLURM_ARRAY_TASK_ID=2 SLURM_ARRAY_TASK_COUNT=2 SLURM_ARRAY_TASK_MIN=1 ";
    const std::string command =
        "cd " + quoted(folder_.string()) + " && " + variables + quoted(ABUT_BINARY) + " batch in -o o > /dev/null 2> e.txt";
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_NE(read(folder_ / "e.txt").find("shard 2 of 2"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder_ / "o/jobs/s0.dxf"));
    EXPECT_TRUE(fs::exists(folder_ / "o/jobs/s1.dxf"));
    const Outcome merge = abut({"merge", "o"});
    EXPECT_EQ(merge.status, 1);
    EXPECT_TRUE(any_line_has(merge.errors, {"2 jobs are not done", "s0.dxf"}));
}

TEST_F(BatchCommand, ComparesDetectionWithATable) {
    write_sketches(3);
    write("e.csv", "file,part_1,part_2\ns0.dxf,BODY,PIN\ns1.dxf,,\ns7.dxf,,\n");
    const Outcome run = abut({"batch", "in", "-o", "o", "--only", "contacts", "--expect", "e.csv"});
    EXPECT_EQ(run.status, 1);
    EXPECT_TRUE(any_line_has(lines_of(run.output), {"precision 0.5 (1 of 2", "recall 1 (1 of 1"})) << run.output;
    EXPECT_TRUE(any_line_has(run.errors, {"s1.dxf", "differs", "1 difference"}));
    EXPECT_TRUE(any_line_has(run.errors, {"--expect names 1 ", "s7.dxf"}));
    EXPECT_TRUE(any_line_has(lines_of(read(folder_ / "o/summary.csv")), {"s1.dxf", ",differs,"}));
    write("e.csv", "file,part_1,part_2\ns0.dxf,BODY,PIN\n");
    EXPECT_EQ(abut({"batch", "in", "-o", "o", "--only", "contacts", "--expect", "e.csv"}).status, 0);
}

TEST_F(BatchCommand, AParameterStudyNeedsNoFiles) {
    SceneText scene;
    scene.more = R"(, "parameters": {"p": 1}, "output": {"formats": ["json"]})";
    scene.loads = R"([{"on": "block/top", "pressure": "p"}])";
    write("scene.json", scene.text());
    write("study.jsonl", "{\"p\": 2}\n{\"p\": 4, \"name\": \"four\"}\n");
    EXPECT_EQ(abut({"batch", "study.jsonl", "--template", "scene.json", "-o", "o"}).status, 0);
    const double two = result("o", "0001")["strain_energy"], four = result("o", "four")["strain_energy"];
    EXPECT_NEAR(four / two, 4, 1e-9);
}

TEST_F(BatchCommand, TakesTheNumberOfWorkersAsMakeDoes) {
    write_sketches(1);
    EXPECT_EQ(abut({"batch", "in", "-j2", "-o", "o", "--quiet"}).status, 0);
    EXPECT_TRUE(any_line_has(abut({"batch", "in", "-j2", "-j", "1", "-o", "o"}).errors, {"-j is given twice"}));
    EXPECT_TRUE(any_line_has(abut({"batch", "in", "-j0", "-o", "o"}).errors, {"-j", "'0' is no whole number from 1 to 4096"}));
    EXPECT_TRUE(any_line_has(abut({"batch", "in", "-jobs", "-o", "o"}).errors, {"unknown option -jobs"}));
    EXPECT_TRUE(any_line_has(abut({"batch", "in", "-k2", "-o", "o"}).errors, {"unknown option -k"}));
}

TEST_F(BatchCommand, RefusesWrongUsage) {
    write_sketches(1);
    write("jobs.csv", "file,Q\nin/s0.dxf,1\n");
    write("fixed.json", SceneText{}.text());
    write("e.csv", "file,part_1\n");
    const std::vector<std::vector<std::string>> wrong{
        {"batch", "missing"},
        {"batch", "in", "-j", "0"},
        {"batch", "in", "-j", "1.5"},
        {"batch", "in", "--memory", "2"},
        {"batch", "in", "--memory", "1K"},
        {"batch", "in", "--shard", "3/2"},
        {"batch", "in", "--only", "stress"},
        {"batch", "in", "--expect", "e.csv"},
        {"batch", "in", "--accuracy", "best"},
        {"batch", "in", "--units", "furlong"},
        {"batch", "in", "--template", "fixed.json"},  // no place for the file
        {"batch", "in", "--template", "missing.json"},
        {"batch", "jobs.csv", "--template", "template.json"},  // Q is no parameter
        {"merge"},
        {"merge", "in"}};
    for (const auto& words : wrong) {
        SCOPED_TRACE(joined(words));
        expect_refused(abut(words), 1);
    }
    EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(BatchCommand, ATemplateByItselfSaysWhatItIs) {
    write_sketches(0);
    const Outcome run = abut({"analyze", "template.json"});
    expect_refused(run, 1);
    expect_words(run.errors.at(0), {"template.json", "/assembly/file", "template", "abut batch"});
}

TEST_F(BatchCommand, TheExamplesOfDataRun) {
    const Outcome run = abut({"batch", data + "batch/loads.csv", "--template", data + "batch/pin_pushed_down.json", "-o", "o"});
    EXPECT_EQ(run.status, 0) << joined(run.errors);
    const double half = result("o", "half")["contacts"][0]["max_pressure"]["value"],
                 full = result("o", "full")["contacts"][0]["max_pressure"]["value"];
    EXPECT_GT(full, half);
}

TEST_F(BatchCommand, AJobBeyondItsMemoryFailsAlone) {
    if (abut::geometry::is_sanitized) GTEST_SKIP() << "shadow memory is larger than any limit";
    write_sketches(1);
    write("in/large.json", SceneText{.more = R"(, "accuracy": {"cell_size": 0.01})"}.text());
    std::string text = read(folder_ / "in/large.json");
    text = std::regex_replace(text, std::regex("  \"accuracy\": \\{\"level\": \"draft\"\\},\n"), "");
    write("in/large.json", text);
    const Outcome run = abut({"batch", "in", "-o", "o", "--memory", "256M"});
    EXPECT_EQ(run.status, 1);
    EXPECT_TRUE(any_line_has(lines_of(run.output), {"2 jobs: 1 ok, 1 broken"})) << run.output;
    EXPECT_TRUE(any_line_has(run.errors, {"large.json", "memory"})) << joined(run.errors);
}

TEST_F(BatchCommand, EveryRealFileHasAResultOrOneClearError) {
    const std::string inputs = std::string(ABUT_SOURCE_DIR) + "/../shared/inputs";
    if (!fs::exists(inputs)) GTEST_SKIP() << "the drawings and meshes are not here";
    const Outcome run = abut({"batch", inputs, "-o", "o"});
    EXPECT_EQ(run.status, 1);  // some of them are wrong on purpose
    const auto summary = nlohmann::json::parse(read(folder_ / "o/summary.json"));
    EXPECT_EQ(summary["counts"]["broken"], 0);
    const auto solved = [&](const char* status) { return summary["counts"].value(status, 0); };
    EXPECT_GE(solved("ok") + solved("solved_but"), 59);
    EXPECT_GE(summary["jobs"].size(), 75U);
    for (const auto& job : summary["jobs"]) {
        const std::string message = job["message"], file = job["file"];
        EXPECT_EQ(message.empty(), job["status"] == "ok") << file;
        EXPECT_TRUE(job["status"] != "refused" || message.starts_with(file)) << message;
        EXPECT_TRUE(job["status"] != "failed" || file.find("/truth/") != std::string::npos)
            << file;  // loads that nothing holds, on purpose
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
}

/// A disk of 400 kB, where the system lets a test have one.
TEST_F(BatchCommand, AFullDiskLosesNothingThatWasFinished) {
    write_sketches(60);
    fs::create_directories(folder_ / "disk");
    if (::mount("tmpfs", (folder_ / "disk").c_str(), "tmpfs", 0, "size=400k") != 0)
        GTEST_SKIP() << "no right to mount a small disk";
    const std::vector<std::string> call{"batch", "in", "-o", "disk/o", "--only", "contacts", "-j", "2"};
    const Outcome full = abut(call);
    const auto finished = answers_of("disk/o");
    const bool larger = ::mount("tmpfs", (folder_ / "disk").c_str(), "tmpfs", MS_REMOUNT, "size=20m") == 0;
    const Outcome again = abut(call);
    const auto complete = answers_of("disk/o");
    ::umount((folder_ / "disk").c_str());
    EXPECT_EQ(full.status, 2);
    EXPECT_TRUE(any_line_has(full.errors, {"cannot be written", "No space left", "run the same command again"}))
        << joined(full.errors);
    EXPECT_GT(finished.size(), 0U);
    ASSERT_TRUE(larger);
    EXPECT_EQ(again.status, 0) << joined(again.errors);
    EXPECT_EQ(std::count_if(complete.begin(), complete.end(), [](const auto& e) { return e.first.ends_with("job.json"); }), 60);
    for (const auto& [file, text] : finished) {
        if (!file.starts_with("jobs/")) continue;  // the summary has more jobs now
        EXPECT_EQ(complete.at(file), text) << file;
    }
}

}  // namespace
}  // namespace abut_tests::batch_command_test
