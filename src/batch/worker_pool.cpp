// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch/worker_pool.hpp"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "src/io/child_text.hpp"

namespace abut {

namespace {

using child::done, child::thrown, child::work_and_end;

void limit_memory(double bytes) {
    rlimit limit{};
    if (bytes <= 0 || ::getrlimit(RLIMIT_DATA, &limit) != 0) return;
    limit.rlim_cur = static_cast<rlim_t>(bytes);
    ::setrlimit(RLIMIT_DATA, &limit);
}

void prepare(const WorkerLimits& limits, pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(1);  // it died before the line above
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
    std::signal(SIGALRM, SIG_DFL);
    std::signal(SIGPIPE, SIG_IGN);
    limit_memory(limits.memory_bytes);
    ::alarm(limits.seconds);
}

std::string death_of(const std::string& sent, int status, unsigned seconds) {
    if (sent.size() >= 2 && sent.front() == done && sent.back() == done) return "";
    if (!sent.empty() && sent.front() == thrown) return sent.substr(1);
    if (!WIFSIGNALED(status)) return "the worker ended without an answer";
    if (WTERMSIG(status) == SIGALRM) return "stopped after " + std::to_string(seconds) + " s";
    if (WTERMSIG(status) == SIGKILL) return "killed from outside, or by the system for want of memory";
    return std::string("an error in the program itself: ") + ::strsignal(WTERMSIG(status)) + "; please report it with the file";
}

}  // namespace

WorkerPool::~WorkerPool() {
    kill_all();
}

std::string WorkerPool::start(std::size_t job, const std::function<std::string()>& work, const WorkerLimits& limits) {
    std::array<int, 2> pipe{};
    if (::pipe(pipe.data()) != 0) return std::string("no process of its own: ") + std::strerror(errno);
    const pid_t parent = ::getpid(), child = ::fork();
    if (child == 0) {
        ::close(pipe[0]);
        prepare(limits, parent);
        work_and_end(work, pipe[1]);
    }
    const int reason = errno;
    ::close(pipe[1]);
    if (child < 0) {
        ::close(pipe[0]);
        return std::string("no process of its own: ") + std::strerror(reason);
    }
    workers_.push_back({job, child, pipe[0], limits.seconds, {}});
    return "";
}

std::optional<WorkerEnd> WorkerPool::wait(int milliseconds) {
    std::vector<pollfd> pipes;
    for (const Worker& worker : workers_) pipes.push_back({worker.pipe, POLLIN, 0});
    if (::poll(pipes.data(), pipes.size(), milliseconds) <= 0) return std::nullopt;
    std::array<char, 4096> buffer{};  // small: after a fork each page of it that is written costs a fault
    for (std::size_t i = 0; i < pipes.size(); ++i) {
        if (pipes[i].revents == 0) continue;
        const ssize_t n = ::read(pipes[i].fd, buffer.data(), buffer.size());
        if (n > 0) workers_[i].text.append(buffer.data(), static_cast<std::size_t>(n));
        if (n == 0) return end(i);
    }
    return std::nullopt;
}

WorkerEnd WorkerPool::end(std::size_t i) {
    Worker worker = std::move(workers_[i]);
    workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(i));
    ::close(worker.pipe);
    int status = 0;
    while (::waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {}
    std::string death = death_of(worker.text, status, worker.seconds);
    std::string text = death.empty() ? worker.text.substr(1, worker.text.size() - 2) : "";
    return {worker.job, std::move(text), std::move(death)};
}

void WorkerPool::kill_all() {
    for (const Worker& worker : workers_) ::kill(worker.process, SIGKILL);
    while (!workers_.empty()) end(workers_.size() - 1);
}

}  // namespace abut
