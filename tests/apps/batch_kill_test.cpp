// SPDX-License-Identifier: GPL-3.0-or-later
// Batches that are killed, or stopped from the keyboard, and started again: the end is that of an undisturbed run.
#include <fcntl.h>
#include <signal.h>

#include <chrono>
#include <random>
#include <thread>

#include "tests/apps/batch_folder.hpp"

namespace abut_tests::batch_kill_test {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

class BatchKill : public BatchCommand {
protected:
    /// The program with these words, not waited for.
    pid_t start(std::vector<std::string> words) const {
        words.insert(words.begin(), ABUT_BINARY);
        std::vector<char*> arguments;
        for (std::string& word : words) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        const pid_t child = ::fork();
        if (child != 0) return child;
        const int sink = ::open("/dev/null", O_RDWR);
        for (const int stream : {0, 1, 2}) ::dup2(sink, stream);
        if (::chdir(folder_.c_str()) == 0) ::execv(ABUT_BINARY, arguments.data());
        ::_exit(127);
    }

    static int end_of(pid_t process) {
        int status = 0;
        ::waitpid(process, &status, 0);
        return status;
    }

    std::vector<std::string> call(const std::string& out) const {
        return {"batch", "in", "--template", "template.json", "-o", out, "-j", "3", "--quiet"};
    }

    /// Names of what runs have left over.
    std::vector<std::string> left_overs(const std::string& out) const {
        std::vector<std::string> names;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / out))
            if (const std::string name = entry.path().filename().string(); name.starts_with(".")) names.push_back(name);
        return names;
    }

    /// Kills the batch so many times, each after a random share of `share` of the time that all of it takes; then lets it end.
    void kill_and_resume(int jobs, int kills, double share) {
        write_sketches(jobs);
        const Clock::time_point begin = Clock::now();
        ASSERT_EQ(abut(call("whole")).status, 0);
        const double whole = seconds_since(begin);
        std::mt19937 random(42);
        int hit = 0;
        for (int k = 0; k < kills; ++k) {
            const pid_t process = start(call("killed"));
            std::this_thread::sleep_for(
                std::chrono::duration<double>(share * whole * static_cast<double>(random()) / 4294967296.0));
            ::kill(process, SIGKILL);
            hit += WIFSIGNALED(end_of(process));
        }
        EXPECT_GE(2 * hit, kills);  // the others came to their end in time
        EXPECT_EQ(abut(call("killed")).status, 0);
        EXPECT_EQ(left_overs("killed"), std::vector<std::string>{});
        const auto killed = answers_of("killed"), undisturbed = answers_of("whole");
        EXPECT_EQ(killed.size(), undisturbed.size());
        for (const auto& [file, text] : undisturbed) EXPECT_TRUE(killed.contains(file) && killed.at(file) == text) << file;
    }
};

TEST_F(BatchKill, KilledAFewTimesItEndsTheSame) {
    kill_and_resume(8, 4, 0.4);
}

TEST_F(BatchKill, StoppedFromTheKeyboardItKeepsWhatIsFinished) {
    write_sketches(12);
    ASSERT_EQ(abut(call("whole")).status, 0);
    const pid_t process = start(call("stopped"));
    const Clock::time_point begin = Clock::now();
    const auto any_job = [&] { return fs::exists(folder_ / "stopped/jobs") && !fs::is_empty(folder_ / "stopped/jobs"); };
    while (!any_job() && seconds_since(begin) < 30) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    ::kill(process, SIGINT);
    const int status = end_of(process);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    EXPECT_EQ(left_overs("stopped"), std::vector<std::string>{});
    EXPECT_TRUE(fs::exists(folder_ / "stopped/summary.csv"));
    const auto kept = std::distance(fs::directory_iterator(folder_ / "stopped/jobs"), fs::directory_iterator());
    EXPECT_GE(kept, 1);
    auto loud = call("stopped");
    loud.pop_back();
    EXPECT_TRUE(any_line_has(lines_of(abut(loud).output), {std::to_string(kept) + " kept from before"}));
    EXPECT_EQ(answers_of("stopped"), answers_of("whole"));
}

class LongBatchKill : public BatchKill {};

TEST_F(LongBatchKill, KilledTwentyTimesItEndsTheSame) {
    kill_and_resume(100, 20, 0.08);
}

}  // namespace
}  // namespace abut_tests::batch_kill_test
