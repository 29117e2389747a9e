// SPDX-License-Identifier: GPL-3.0-or-later
// The folders of finished jobs: OUT/jobs/NAME, each of them whole or not there.
#pragma once
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "src/batch/job_record.hpp"

namespace abut {

/// A folder or file cannot be written (disk full, permissions): no fault of any job.
class StoreError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Several stores, in several processes and on several machines, may write into one OUT. A job is written into a folder of this
/// store (OUT/.run-HOST-PID/NAME) and renamed to its place in one step. It is not brought to the disk (fsync took up to 8 ms a
/// file on a busy one, ten times as long as finding contacts): after a power failure, sizes tell which of the last jobs are to
/// be done again. What a killed process left behind is removed by the next store, as it begins and as it
/// ends: who is alive holds a lock. All functions but
/// the destructor throw StoreError.
class JobStore {
public:
    explicit JobStore(std::string out);
    JobStore(const JobStore&) = delete;
    JobStore& operator=(const JobStore&) = delete;
    ~JobStore();  ///< removes what is not finished, and what the dead left

    /// An empty folder to write the job's files into.
    std::string begin(const std::string& name) const;
    std::string begun(const std::string& name) const;  ///< the same folder again
    /// Brings the job's folder to its place, instead of an older one.
    void finish(const std::string& name) const;
    void drop(const std::string& name) const;

private:
    std::string out_, run_;
    int lock_ = -1;
};

/// The folder of a finished job: OUT/jobs/NAME.
std::string job_folder(const std::string& out, const std::string& name);

/// The record of a finished job; nothing where there is none, or where a file that it lists is missing or has another size.
std::optional<JobRecord> stored_job(const std::string& out, const std::string& name);

}  // namespace abut
