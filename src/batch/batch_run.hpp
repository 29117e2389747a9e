// SPDX-License-Identifier: GPL-3.0-or-later
// The walk through the jobs of a batch: what is finished is kept, the rest is done by workers, a folder each.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "src/batch/batch_shard.hpp"
#include "src/batch/batch_source.hpp"
#include "src/batch/job_record.hpp"
#include "src/batch/job_request.hpp"
#include "src/batch/job_store.hpp"
#include "src/batch/worker_pool.hpp"

namespace abut {

/// How far a batch is, as it is told after every job.
struct BatchProgress {
    std::size_t total = 0, done = 0, kept = 0, not_ok = 0;  ///< done: with those kept from an earlier run
    const JobRecord* last = nullptr;                        ///< the job that is done now; null: nothing but time has passed
    bool last_kept = false;
};

/// How a batch is run: workers and limits, the shard, what is asked of a job, and who does it.
struct BatchRun {
    std::size_t workers = 1;
    WorkerLimits limits{};
    Shard shard{};
    bool force = false;  ///< keep nothing
    BatchRequest request{};
    /// Does the job and writes its files into the folder; fills all of the record but key, files and seconds. An InputError
    /// that it throws is the job's fault, a StoreError the disk's. Runs in a process of its own.
    std::function<JobRecord(const BatchJob&, const std::string& folder)> work{};
    std::function<bool()> interrupted{};                   ///< asked several times a second
    std::function<void(const BatchProgress&)> progress{};  ///< may be empty
};

/// How a batch ended.
struct BatchEnd {
    BatchProgress progress;
    bool interrupted = false;
    std::size_t edited = 0;   ///< jobs done with a template that was edited after the batch had begun
    std::string write_fault;  ///< why no more jobs were begun: nothing can be written; empty where it did not come to that
};

/// Does the jobs of a batch, in their order, several at once; answers do not depend on how many. Interrupted, workers are ended
/// and what they had begun is removed. A job one of whose files is written while it runs is done again; its key is that of what
/// it read. A job that dies (memory, time, a fault of the program) gets a record that says so. Throws StoreError where not even
/// the first folder can be made.
BatchEnd run_batch(const std::vector<BatchJob>& jobs, const std::string& out, const BatchRun& run);

}  // namespace abut
