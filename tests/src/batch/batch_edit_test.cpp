// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are edited while a batch runs: no answer is kept under the key of inputs that it was not made of.
#include "geometry/brep/input_error.hpp"
#include "src/batch/batch_run.hpp"
#include "src/batch/batch_summary.hpp"
#include "src/io/whole_file.hpp"
#include "src/io/write_file.hpp"
#include "src/results/result.hpp"
#include "tests/src/io/folder_test.hpp"

namespace abut::batch_edit_test {
namespace {

namespace fs = std::filesystem;

/// Jobs a to d: scenes that import a drawing, through a template that imports another one. A job's answer is what all of them
/// hold when it reads them; then `while_reading_` edits some.
class BatchEditTest : public FolderTest {
protected:
    void SetUp() override {
        FolderTest::SetUp();
        out_ = (folder_ / "out").string();
        run_.request.template_file = write("template.json", R"({"assembly": {"file": "common.dxf"}})");
        write("common.dxf", "common");
        for (const char* name : {"a", "b", "c", "d"}) {
            write(std::string("in/") + name + ".dxf", name);
            const std::string scene = std::string(R"({"assembly": {"file": ")") + name + ".dxf\"}}";
            jobs_.push_back({name, write(std::string("in/") + name + ".json", scene), {}, ""});
        }
        run_.work = [this](const BatchJob& job, const std::string& folder) {
            std::string all;
            for (const std::string& file : files_of(job)) all += read_whole_file(file) + "\n";
            if (while_reading_) while_reading_(job);
            write_file(folder, "answer", all);
            return JobRecord{};
        };
    }

    std::vector<std::string> files_of(const BatchJob& job) const {
        return {job.file, path("in/" + job.name + ".dxf"), path("template.json"), path("common.dxf")};
    }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    /// Answers of all jobs are of the files as they are now.
    void expect_current() const {
        for (const BatchJob& job : jobs_) {
            std::string all;
            for (const std::string& file : files_of(job)) all += read_whole_file(file) + "\n";
            EXPECT_EQ(read_whole_file(job_folder(out_, job.name) + "/answer"), all) << job.name;
        }
    }

    BatchEnd run() const { return run_batch(jobs_, out_, run_); }

    /// Once in the whole batch, in whatever process: what it did is seen by a file.
    bool first_time(const std::string& mark) const {
        const bool first = !fs::exists(path(mark));
        if (first) write(mark, "");
        return first;
    }

    std::string out_;
    BatchRun run_;
    std::vector<BatchJob> jobs_;
    std::function<void(const BatchJob&)> while_reading_;
};

TEST_F(BatchEditTest, AJobWhoseFilesAreWrittenWhileItRunsReadsThemAgain) {
    for (const char* file : {"in/b.json", "in/b.dxf", "template.json", "common.dxf"}) {
        SCOPED_TRACE(file);
        fs::remove_all(out_);
        const std::string old = read_whole_file(path(file));
        while_reading_ = [&](const BatchJob& job) {
            if (job.name == "b" && first_time(std::string("mark") + fs::path(file).filename().string())) write(file, old + " ");
        };
        const BatchEnd end = run();
        EXPECT_EQ(end.progress.not_ok, 0U);
        EXPECT_EQ(stored_job(out_, "b")->key.size(), 16U);
        while_reading_ = nullptr;
        const bool is_common = std::string(file).find("in/") == std::string::npos;
        EXPECT_EQ(end.edited, is_common ? 3U : 0U);           // b to d have the new one
        EXPECT_EQ(run().progress.kept, is_common ? 3U : 4U);  // a alone is to be done again
        expect_current();
        EXPECT_EQ(run().progress.kept, 4U);
    }
}

/// Restored, the file hashes as before, and yet the answer is of something else.
TEST_F(BatchEditTest, AnEditThatIsTakenBackIsSeen) {
    while_reading_ = [&](const BatchJob& job) {
        if (job.name != "b" || !first_time("mark")) return;
        write("in/b.dxf", "another");
        write("in/b.dxf", "b");
        write("seen", "");
    };
    run();
    EXPECT_TRUE(fs::exists(path("seen")));
    expect_current();
}

TEST_F(BatchEditTest, AFileThatIsWrittenAllTheTimeIsNoAnswer) {
    while_reading_ = [&](const BatchJob& job) {
        if (job.name == "c") write("in/c.dxf", read_whole_file(path("in/c.dxf")) + "x");
    };
    EXPECT_EQ(run().progress.not_ok, 1U);
    const auto record = stored_job(out_, "c");
    ASSERT_TRUE(record);
    EXPECT_EQ(record->status, JobRecord::Status::broken);
    EXPECT_NE(record->message.find("was written whenever this job ran"), std::string::npos);
    EXPECT_FALSE(fs::exists(job_folder(out_, "c") + "/answer"));
    while_reading_ = nullptr;
    EXPECT_EQ(run().progress.kept, 3U);
    expect_current();
}

TEST_F(BatchEditTest, AFileThatComesLaterCounts) {
    fs::remove(path("in/d.dxf"));
    run_.work = [this, work = run_.work](const BatchJob& job, const std::string& folder) {
        if (job.name == "d" && first_time("mark")) {
            write("in/d.dxf", "late");
            throw InputError("d.dxf", "there is no such file");
        }
        return work(job, folder);
    };
    EXPECT_EQ(run().progress.not_ok, 0U);
    expect_current();
}

TEST_F(BatchEditTest, TheSummaryHasJobsOfOneTemplateOnly) {
    const BatchFile batch = batch_file("in", run_.request, jobs_);
    while_reading_ = [&](const BatchJob& job) {
        if (job.name == "b" && first_time("mark")) write("template.json", "{}");
    };
    run();
    const BatchSummary summary = summarize(out_, batch);
    EXPECT_EQ(summary.jobs.size(), 1U);
    EXPECT_EQ(summary.stale, (std::vector<std::string>{"b", "c", "d"}));
}

}  // namespace
}  // namespace abut::batch_edit_test
