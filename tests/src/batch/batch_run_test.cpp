// SPDX-License-Identifier: GPL-3.0-or-later
// Batches of made-up jobs: workers that die, throw, are stopped; folders that are whole or not there.
#include "src/batch/batch_run.hpp"

#include <signal.h>
#include <unistd.h>

#include <thread>

#include "geometry/brep/input_error.hpp"
#include "geometry/foreign/reader_main.hpp"
#include "src/batch/batch_merge.hpp"
#include "src/batch/batch_summary.hpp"
#include "src/io/whole_file.hpp"
#include "src/io/write_file.hpp"
#include "src/results/result.hpp"
#include "tests/src/io/folder_test.hpp"

namespace abut::batch_run_test {
namespace {

namespace fs = std::filesystem;
using Status = JobRecord::Status;

class BatchRunTest : public FolderTest {
protected:
    void SetUp() override {
        FolderTest::SetUp();
        out_ = (folder_ / "out").string();
        run_.work = [](const BatchJob& job, const std::string& folder) {
            write_file(folder, "answer", job.name);
            return JobRecord{};
        };
    }

    /// Jobs a, b, c, ... each with a file of its own.
    std::vector<BatchJob> jobs(int n) const {
        std::vector<BatchJob> result;
        for (int i = 0; i < n; ++i) {
            const std::string name(1, static_cast<char>('a' + i));
            result.push_back({name, write("in/" + name, "content of " + name), {}, ""});
        }
        return result;
    }

    Status status(const std::string& job) const {
        const auto record = stored_job(out_, job);
        EXPECT_TRUE(record) << job;
        return record ? record->status : Status::broken;
    }

    std::vector<std::string> entries(const fs::path& path) const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(path)) names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }

    std::string out_;
    BatchRun run_;
};

TEST_F(BatchRunTest, KeepsWhatIsFinishedAndRedoesWhatHasChanged) {
    const auto all = jobs(4);
    EXPECT_EQ(run_batch(all, out_, run_).progress.kept, 0U);
    EXPECT_EQ(run_batch(all, out_, run_).progress.kept, 4U);
    write("in/b", "something else");
    EXPECT_EQ(run_batch(all, out_, run_).progress.kept, 3U);
    run_.request.settings["accuracy"] = "fine";
    EXPECT_EQ(run_batch(all, out_, run_).progress.kept, 0U);
    run_.request.template_file = write("template.json", "{}");
    EXPECT_EQ(run_batch(all, out_, run_).progress.kept, 0U);
    EXPECT_EQ(run_batch(all, out_, run_).progress.kept, 4U);
    write("template.json", "{\"abut\": 1}");
    EXPECT_EQ(run_batch(all, out_, run_).progress.kept, 0U);
    auto with_parameter = all;
    with_parameter[2].parameters["P"] = 3;
    EXPECT_EQ(run_batch(with_parameter, out_, run_).progress.kept, 3U);
    run_.force = true;
    EXPECT_EQ(run_batch(with_parameter, out_, run_).progress.kept, 0U);
    EXPECT_EQ(entries(out_), (std::vector<std::string>{"jobs"}));  // nothing temporary
    EXPECT_EQ(entries(job_folder(out_, "a")), (std::vector<std::string>{"answer", "job.json"}));
}

TEST_F(BatchRunTest, AFolderThatLostAFileIsDoneAgain) {
    const auto all = jobs(3);
    run_batch(all, out_, run_);
    fs::remove(fs::path(job_folder(out_, "a")) / "answer");
    std::ofstream(fs::path(job_folder(out_, "b")) / "job.json") << "{\"abut\": 1, \"na";  // as after a power failure
    std::ofstream(fs::path(job_folder(out_, "c")) / "answer") << "";
    EXPECT_EQ(run_batch(all, out_, run_).progress.kept, 0U);
    EXPECT_EQ(run_batch(all, out_, run_).progress.kept, 3U);
}

TEST_F(BatchRunTest, OneBadJobStopsNoOther) {
    if (geometry::is_sanitized) GTEST_SKIP() << "shadow memory is larger than any limit";
    run_.workers = 3;
    run_.limits.seconds = 1;
    run_.limits.memory_bytes = 512e6;
    run_.work = [](const BatchJob& job, const std::string& folder) {
        write_file(folder, "answer", job.name);
        if (job.name == "b") throw InputError("b.dxf", "is wrong", "mend it");
        if (job.name == "c") ::raise(SIGSEGV);
        if (job.name == "d") std::this_thread::sleep_for(std::chrono::seconds(20));
        if (job.name == "e") std::vector<double>(1000000000, 1.0).front() = 2;
        if (job.name == "f") throw std::runtime_error("a bug");
        return JobRecord{};
    };
    const auto all = jobs(7);
    const BatchEnd end = run_batch(all, out_, run_);
    EXPECT_EQ(end.progress.done, 7U);
    EXPECT_EQ(end.progress.not_ok, 5U);
    EXPECT_EQ(status("a"), Status::ok);
    EXPECT_EQ(status("b"), Status::refused);
    for (const char* job : {"c", "d", "e", "f"}) EXPECT_EQ(status(job), Status::broken) << job;
    EXPECT_EQ(status("g"), Status::ok);
    EXPECT_EQ(stored_job(out_, "b")->message, "b.dxf: is wrong; mend it");
    EXPECT_NE(stored_job(out_, "c")->message.find("Segmentation fault"), std::string::npos);
    EXPECT_NE(stored_job(out_, "d")->message.find("stopped after 1 s"), std::string::npos);
    EXPECT_NE(stored_job(out_, "e")->message.find("not enough memory"), std::string::npos);
    EXPECT_NE(stored_job(out_, "f")->message.find("a bug"), std::string::npos);
    run_.limits = {};
    run_.work = [](const BatchJob&, const std::string&) { return JobRecord{}; };
    EXPECT_EQ(run_batch(all, out_, run_).progress.kept, 3U);  // what broke is tried again, what is wrong stays wrong
}

TEST_F(BatchRunTest, StoppedItLeavesNothingHalf) {
    run_.workers = 2;
    std::size_t done = 0;
    run_.work = [](const BatchJob& job, const std::string& folder) {
        write_file(folder, "answer", job.name);
        if (job.name > "c") std::this_thread::sleep_for(std::chrono::seconds(20));
        return JobRecord{};
    };
    run_.progress = [&](const BatchProgress& p) { done = p.done; };
    run_.interrupted = [&] { return done >= 3; };
    const BatchEnd end = run_batch(jobs(6), out_, run_);
    EXPECT_TRUE(end.interrupted);
    EXPECT_EQ(end.progress.done, 3U);
    EXPECT_EQ(entries(out_), (std::vector<std::string>{"jobs"}));
    EXPECT_EQ(entries(fs::path(out_) / "jobs"), (std::vector<std::string>{"a", "b", "c"}));
}

TEST_F(BatchRunTest, StopsWhereNothingCanBeWritten) {
    run_.work = [](const BatchJob& job, const std::string&) -> JobRecord {
        if (job.name == "b") throw StoreError("out/b cannot be written: no space left");
        return {};
    };
    const BatchEnd end = run_batch(jobs(5), out_, run_);
    EXPECT_EQ(end.write_fault, "out/b cannot be written: no space left");
    EXPECT_EQ(end.progress.done, 1U);
    EXPECT_EQ(status("a"), Status::ok);
}

TEST_F(BatchRunTest, RemovesWhatADeadRunLeftAndNothingOfALivingOne) {
    const JobStore living(out_);
    const std::string begun = living.begin("a");
    write("out/.run-host-1/b/answer", "");
    write("out/.run-host-1.lock", "");
    run_batch(jobs(1), (folder_ / "out/other").string(), run_);
    // The same process has the same name: a store of another process is what counts.
    const pid_t child = ::fork();
    if (child == 0) {
        { const JobStore other(out_); }
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(fs::exists(begun));
    EXPECT_FALSE(fs::exists(fs::path(out_) / ".run-host-1"));
    EXPECT_FALSE(fs::exists(fs::path(out_) / ".run-host-1.lock"));
}

TEST_F(BatchRunTest, ShardsTogetherAreTheWholeOnceEach) {
    const auto all = jobs(7);
    for (std::size_t n = 1; n <= 9; ++n) {
        std::vector<int> times(all.size(), 0);
        for (std::size_t i = 1; i <= n; ++i)
            for (std::size_t job = 0; job < all.size(); ++job) times[job] += is_in({i, n}, job);
        EXPECT_EQ(times, std::vector<int>(all.size(), 1)) << n;
    }
    const BatchFile batch = batch_file("in", run_.request, all);
    std::vector<std::string> outs;
    for (std::size_t i = 1; i <= 3; ++i) {
        run_.shard = {i, 3};
        outs.push_back((folder_ / ("shard" + std::to_string(i))).string());
        run_batch(all, outs.back(), run_);
        write_file(outs.back(), "batch.json", batch_json(batch));
    }
    EXPECT_EQ(summarize(outs[0], batch).missing.size(), 4U);
    merge_batches(outs, out_);
    EXPECT_TRUE(summarize(out_, batch).missing.empty());
    merge_batches(outs, outs[1]);
    EXPECT_TRUE(summarize(outs[1], batch).missing.empty());
}

}  // namespace
}  // namespace abut::batch_run_test
