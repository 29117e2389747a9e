// SPDX-License-Identifier: GPL-3.0-or-later
// Which shards go together, and what is said of those that do not.
#include "src/batch/batch_merge.hpp"

#include "geometry/brep/input_error.hpp"
#include "src/batch/batch_difference.hpp"
#include "src/batch/batch_run.hpp"
#include "src/batch/batch_summary.hpp"
#include "src/io/whole_file.hpp"
#include "src/io/write_file.hpp"
#include "src/results/result.hpp"
#include "tests/src/io/folder_test.hpp"

namespace abut::batch_merge_test {
namespace {

class BatchMergeTest : public FolderTest {
protected:
    void SetUp() override {
        FolderTest::SetUp();
        run_.work = [](const BatchJob& job, const std::string& folder) {
            write_file(folder, "answer", job.name);
            return JobRecord{};
        };
        run_.request = {{{"version", "1"}, {"--accuracy", ""}}, write("template.json", R"({"abut": 1})"), {}};
        for (const char* name : {"a", "b", "c", "d"})
            jobs_.push_back({name, write(std::string("in/") + name, name), {{"P", 1}}, ""});
    }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    /// Shard I of N, with batch.json.
    std::string shard(const std::string& name, std::size_t i, std::size_t n) {
        run_.shard = {i, n};
        run_batch(jobs_, path(name), run_);
        write_file(path(name), "batch.json", batch_json(batch_file("in", run_.request, jobs_)));
        return path(name);
    }

    /// What merging is refused for.
    std::vector<Problem> faults(const std::vector<std::string>& folders) const {
        try {
            merge_batches(folders, path("merged"));
        } catch (const InputError& error) { return error.problems(); }
        return {};
    }

    /// The second shard of a batch that `change` made another one: one fault that names both folders and has these words.
    template <class Change>
    void expect_another(Change change, const std::string& words) {
        SCOPED_TRACE(words);
        const std::string one = shard("one", 1, 2);
        const std::vector<BatchJob> before = jobs_;
        const BatchRequest asked = run_.request;
        change();
        const std::string two = shard("two", 2, 2);
        const std::vector<Problem> found = faults({one, two});
        ASSERT_EQ(found.size(), 1U);
        EXPECT_EQ(found[0].where, two);
        EXPECT_NE(found[0].what.find("another batch than " + one), std::string::npos) << found[0].what;
        EXPECT_NE(found[0].what.find(words), std::string::npos) << found[0].what;
        EXPECT_FALSE(std::filesystem::exists(path("merged")));
        jobs_ = before;
        run_.request = asked;
        write("template.json", R"({"abut": 1})");
    }

    std::vector<BatchJob> jobs_;
    BatchRun run_;
};

TEST_F(BatchMergeTest, RefusesShardsOfOtherBatchesAndSaysWhatDiffers) {
    const std::string one = path("one"), two = path("two");
    expect_another([&] { run_.request.settings["--accuracy"] = "fine"; },
                   "the option --accuracy is not given in " + one + " and fine in " + two);
    expect_another([&] { run_.request.settings["version"] = "2"; },
                   "the program's version is 1 in " + one + " and 2 in " + two);
    expect_another([&] { write("template.json", R"({"abut": 1, "title": "x"})"); }, "the templates, or files that they import");
    expect_another([&] { run_.request.template_file = ""; }, "only " + one + " has a template");
    expect_another([&] { jobs_.pop_back(); }, "the number of jobs is 4 in " + one + " and 3 in " + two);
    expect_another([&] { jobs_[1].name = "x"; }, "job 2 is b in " + one + " and x in " + two);
    expect_another([&] { jobs_[1].file = write("in/x", ""); }, "the file of job 2, b, is b in " + one + " and x in " + two);
    expect_another([&] { jobs_[2].parameters["P"] = 1.5; },
                   "the parameter P of job 3, c, is 1 in " + one + " and 1.5 in " + two);
    expect_another([&] { jobs_[2].parameters = {}; },
                   "the parameter P of job 3, c, is 1 in " + one + " and not given in " + two);
    expect_another([&] { run_.request.own_settings = [](const BatchJob& job) { return job.name == "d" ? "pair" : ""; }; },
                   "what --expect says of job 4, d, is not the same");
}

TEST_F(BatchMergeTest, AFileThatTheTemplateImportsCounts) {
    write("template.json", R"({"abut": 1, "assembly": {"file": "common.dxf"}})");
    write("common.dxf", "old");
    const std::string one = shard("one", 1, 2);
    write("common.dxf", "new");
    const std::vector<Problem> found = faults({one, shard("two", 2, 2)});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NE(found[0].what.find("the templates, or files that they import"), std::string::npos);
}

TEST_F(BatchMergeTest, TakesShardsFromOtherPlacesAndMachines) {
    const std::string one = shard("one", 1, 2);
    for (BatchJob& job : jobs_) job.file = write("elsewhere/" + job.name, job.name);
    run_.request.template_file = write("elsewhere/t.json", R"({"abut": 1})");
    const std::string two = shard("two", 2, 2);
    EXPECT_TRUE(faults({one, two}).empty());
    EXPECT_EQ(summarize(path("merged"), read_batch_file(one)).jobs.size(), 4U);
}

TEST_F(BatchMergeTest, RefusesAJobWithDifferentInputs) {
    const std::string one = shard("one", 1, 1), two = shard("two", 1, 1);
    EXPECT_TRUE(faults({one, two}).empty());  // the same jobs twice: no conflict
    write("in/b", "changed");
    shard("two", 1, 1);
    const std::vector<Problem> found = faults({one, two});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].where, "b");
    EXPECT_EQ(faults({folder_.string()}).size(), 1U);
}

TEST_F(BatchMergeTest, InASharedFolderJobsOfAnotherTemplateAreNotThere) {
    shard("out", 1, 2);
    write("template.json", R"({"abut": 1, "title": "x"})");
    shard("out", 2, 2);
    const BatchFile batch = merge_batches({path("out")}, path("out"));
    const BatchSummary summary = summarize(path("out"), batch);
    EXPECT_EQ(summary.jobs.size(), 2U);
    EXPECT_EQ(summary.missing, (std::vector<std::string>{"a", "c"}));
    EXPECT_EQ(summary.stale, summary.missing);
    shard("out", 1, 2);
    EXPECT_TRUE(summarize(path("out"), batch).missing.empty());
}

TEST_F(BatchMergeTest, WhatAnOlderVersionWroteIsRefusedInOneSentence) {
    write("old/batch.json",
          R"({"abut": 1, "source": "in", "settings": {"version": "0"}, "jobs": [{"name": "a", "file": "in/a"}]})");
    const std::vector<Problem> found = faults({path("old")});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].where, path("old/batch.json"));
    EXPECT_NE(found[0].what.find("an older abut wrote this"), std::string::npos);
    for (const char* wrong :
         {"", "[]", "{\"jobs\": 3}", "{\"abut\": 1, \"settings\": {}, \"template\": \"\", \"jobs\": [{}]}"}) {
        write("old/batch.json", wrong);
        ASSERT_EQ(faults({path("old")}).size(), 1U) << wrong;
        EXPECT_NE(faults({path("old")})[0].what.find("no batch.json"), std::string::npos) << wrong;
    }
}

}  // namespace
}  // namespace abut::batch_merge_test
