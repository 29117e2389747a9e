// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/foreign/reader_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>

#include "geometry/brep/input_error.hpp"
#include "geometry/foreign/reader_main.hpp"

namespace abut::geometry {

namespace {

namespace fs = std::filesystem;

/// Processor time passes more slowly by the clock where other programs run: so many of them are allowed for.
constexpr unsigned most_sharers = 20;

/// Actions and attributes of a process to start, released with this.
struct SpawnPlan {
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;

    explicit SpawnPlan(int output) {
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
        // Libraries talk; what sanitizers say of our own code is for whoever runs them.
        if (!is_sanitized) posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
        posix_spawnattr_init(&attributes);
        sigset_t signals;
        sigemptyset(&signals);
        posix_spawnattr_setsigmask(&attributes, &signals);
        for (const int signal : {SIGPIPE, SIGXCPU, SIGSEGV, SIGABRT}) sigaddset(&signals, signal);
        posix_spawnattr_setsigdefault(&attributes, &signals);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    }
    ~SpawnPlan() {
        posix_spawn_file_actions_destroy(&actions);
        posix_spawnattr_destroy(&attributes);
    }
    SpawnPlan(const SpawnPlan&) = delete;
    SpawnPlan& operator=(const SpawnPlan&) = delete;
};

}  // namespace

ReaderLimits limits_of(const ForeignReader& reader, std::uintmax_t file_bytes) {
    const double seconds =
        std::ceil(reader.seconds + reader.seconds_per_megabyte * static_cast<double>(file_bytes) / (1 << 20));
    return {reader.memory_bytes + reader.memory_per_byte * file_bytes, static_cast<unsigned>(seconds),
            most_sharers * static_cast<unsigned>(seconds)};
}

ReaderProcess::ReaderProcess(const ForeignReader& reader, const std::string& file, const std::vector<std::string>& words)
    : reader_(reader),
      file_(file),
      path_(reader_path(reader.program)),
      records_(file, [this](char* bytes, std::size_t n) { receive(bytes, n); }) {
    if (path_.empty())
        throw InputError(file, "the program " + reader.program + " that reads files of this kind is not there", reader.absence);
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);
    limits_ = limits_of(reader, error ? 0 : size);
    std::vector<std::string> arguments{path_, std::to_string(limits_.memory_bytes), std::to_string(limits_.processor_seconds),
                                       file};
    arguments.insert(arguments.end(), words.begin(), words.end());
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0) refuse(std::string("no pipe to its reader: ") + std::strerror(errno));
    const SpawnPlan plan(pipe[1]);
    const int failure = ::posix_spawn(&process_, path_.c_str(), &plan.actions, &plan.attributes, pointers.data(), environ);
    ::close(pipe[1]);
    pipe_ = pipe[0];
    if (failure == 0) return;
    process_ = -1;
    end();
    throw InputError(file,
                     "the program " + path_ + " that reads files of this kind cannot be started: " + std::strerror(failure));
}

ReaderProcess::~ReaderProcess() {
    end();
}

/// Ends the process; its status, -1 where there is none.
int ReaderProcess::end() {
    int status = -1;
    if (process_ > 0) {
        ::kill(process_, SIGKILL);  // does nothing to one that has ended
        while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {}
    }
    process_ = -1;
    if (pipe_ >= 0) ::close(pipe_);
    pipe_ = -1;
    return status;
}

void ReaderProcess::refuse(const std::string& what) const {
    throw InputError(file_, what, reader_.hint);
}

/// The pipe has ended, and with it the process: why?
void ReaderProcess::fail() {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {}
    process_ = -1;
    end();
    const std::string reader = reader_.library + ", which reads files of this kind, ";
    if (WIFEXITED(status) && WEXITSTATUS(status) == exit_no_memory)
        refuse(reader + "needs more memory for this one than it may have, " + std::to_string(limits_.memory_bytes >> 20) +
               " MB at most");
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (signal == SIGXCPU)
        refuse(reader + "comes to no end with this one in " + std::to_string(limits_.processor_seconds) + " s");
    if (signal != 0) refuse(reader + "broke down at this one (" + ::strsignal(signal) + ")");
    throw InputError(file_, "the program " + path_ + " that reads files of this kind does not run",
                     "run it by hand: it says which library is missing");
}

/// Waits for the next portion.
void ReaderProcess::fill() {
    pollfd pipe{pipe_, POLLIN, 0};
    const int ready = ::poll(&pipe, 1, static_cast<int>(1000 * limits_.idle_seconds));
    if (ready < 0 && errno == EINTR) return;
    if (ready == 0)
        refuse(reader_.library + ", which reads files of this kind, said nothing of this one for " +
               std::to_string(limits_.idle_seconds) + " s");
    std::array<char, 1 << 16> portion{};
    const ssize_t n = ::read(pipe_, portion.data(), portion.size());
    if (n < 0 && errno == EINTR) return;
    if (n <= 0) fail();
    buffer_.assign(portion.data(), static_cast<std::size_t>(n));
    taken_ = 0;
}

void ReaderProcess::receive(char* bytes, std::size_t n) {
    while (n > 0) {
        if (taken_ == buffer_.size()) {
            fill();
            continue;
        }
        const std::size_t part = std::min(n, buffer_.size() - taken_);
        std::memcpy(bytes, buffer_.data() + taken_, part);
        taken_ += part;
        bytes += part;
        n -= part;
    }
}

}  // namespace abut::geometry
