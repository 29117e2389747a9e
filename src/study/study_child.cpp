// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/study_child.hpp"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>

#include "src/io/child_text.hpp"

namespace abut {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double longest_limit = 1e6;  // seconds: clocks count in nanoseconds, and not for ever

using child::done, child::thrown, child::work_and_end;

int milliseconds_until(Clock::time_point end) {
    const double left = std::chrono::duration<double, std::milli>(end - Clock::now()).count();
    return left <= 0 ? 0 : static_cast<int>(std::min(std::ceil(left), 1e9));
}

/// All that the child sends; false: the time is over.
bool receive(int pipe, Clock::time_point end, std::string& text) {
    std::array<char, 65536> buffer{};
    for (;;) {
        pollfd waiting{pipe, POLLIN, 0};
        const int ready = ::poll(&waiting, 1, milliseconds_until(end));
        if (ready < 0 && errno == EINTR) continue;
        if (ready <= 0) return false;
        const ssize_t n = ::read(pipe, buffer.data(), buffer.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return true;
        text.append(buffer.data(), static_cast<std::size_t>(n));
    }
}

/// Waits for the child's end; its largest resident size in bytes.
double peak_after_end(pid_t child, int& status) {
    rusage usage{};
    while (::wait4(child, &status, 0, &usage) < 0)
        if (errno != EINTR) return 0;
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// What became of the child that sent this text.
void judge(const std::string& sent, int status, ChildOutcome& outcome) {
    if (outcome.out_of_time) {
        outcome.failure = "stopped: it took longer than was left of the budget; a larger --budget gives it more";
    } else if (sent.size() >= 2 && sent.front() == done && sent.back() == done) {
        outcome.text = sent.substr(1, sent.size() - 2);
    } else if (!sent.empty() && sent.front() == thrown) {
        outcome.failure = sent.substr(1);
    } else if (WIFSIGNALED(status)) {
        outcome.failure = std::string("ended by the system: ") + ::strsignal(WTERMSIG(status)) + " (memory?)";
    } else {
        outcome.failure = "ended without an answer";
    }
}

}  // namespace

ChildOutcome in_child(const std::function<std::string()>& work, double limit_seconds) {
    ChildOutcome outcome;
    const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                     std::chrono::duration<double>(std::min(limit_seconds, longest_limit)));
    std::array<int, 2> pipe{};
    if (::pipe(pipe.data()) != 0) {
        outcome.failure = std::string("no process of its own: ") + std::strerror(errno);
        return outcome;
    }
    const pid_t child = ::fork();
    if (child == 0) {
        ::close(pipe[0]);
        work_and_end(work, pipe[1]);
    }
    ::close(pipe[1]);
    if (child < 0) {
        outcome.failure = std::string("no process of its own: ") + std::strerror(errno);
        ::close(pipe[0]);
        return outcome;
    }
    std::string sent;
    outcome.out_of_time = !receive(pipe[0], end, sent);
    if (outcome.out_of_time) ::kill(child, SIGKILL);
    ::close(pipe[0]);
    int status = 0;
    outcome.peak_bytes = peak_after_end(child, status);
    judge(sent, status, outcome);
    return outcome;
}

}  // namespace abut
