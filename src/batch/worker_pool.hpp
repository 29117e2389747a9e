// SPDX-License-Identifier: GPL-3.0-or-later
// Several pieces of work at once, each in a copy of this process.
#pragma once
#include <sys/types.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace abut {

/// What a worker may take.
struct WorkerLimits {
    double memory_bytes = 0;  ///< of data (heap, stacks, private maps: RLIMIT_DATA), beyond this allocations fail; 0: none
    unsigned seconds = 0;     ///< of wall time, then it is ended; 0: none
};

/// How a worker ended: with its text or with a reason.
struct WorkerEnd {
    std::size_t job = 0;
    std::string text;   ///< what the work gave
    std::string death;  ///< why it gave nothing; empty where it ended well
};

/// A worker begins as a copy of this process (nothing is loaded again), changes nothing in it, and dies with it. It ignores the
/// signals that end a program from a terminal: kill_all does that. Its standard streams are this process' own. Cost: below a
/// millisecond each.
class WorkerPool {
public:
    WorkerPool() = default;
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;
    ~WorkerPool();  ///< kill_all

    /// Starts a worker. Returns why it could not be started; empty where it was. What the work throws is its death.
    std::string start(std::size_t job, const std::function<std::string()>& work, const WorkerLimits& limits);
    std::size_t running() const { return workers_.size(); }
    /// The next worker that has ended; nothing where none has in so many milliseconds, or where a signal came.
    std::optional<WorkerEnd> wait(int milliseconds);
    void kill_all();

private:
    struct Worker {
        std::size_t job;
        pid_t process;
        int pipe;
        unsigned seconds;
        std::string text;
    };
    WorkerEnd end(std::size_t worker);

    std::vector<Worker> workers_;
};

}  // namespace abut
