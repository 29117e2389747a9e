// SPDX-License-Identifier: GPL-3.0-or-later
// What is kept of one job of a batch: job.json of its folder, and its line in the summary.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/contact/expected_pairs.hpp"

namespace abut {

/// What one job was asked and what it came to.
struct JobRecord {
    enum class Status {
        ok,
        solved_but,  ///< with reasons not to take the answer as it is
        differs,     ///< from what was expected
        failed,      ///< the analysis has no answer
        refused,     ///< the input is wrong
        broken       ///< memory, time or the program gave out: tried again by the next run
    };
    std::string name, file;
    std::string mode;  ///< "analysis" or "contacts"
    Status status = Status::ok;
    std::string message;  ///< one line, why it is not ok, or the reasons
    std::string key;      ///< src/batch/job_key.hpp
    std::string request;  ///< src/batch/job_request.hpp: the key without the job's own files
    std::map<std::string, double> parameters;
    std::string title, length_unit, force_unit;
    std::optional<int> parts, pairs, closed;  ///< pairs found; those that carry
    std::optional<double> max_pressure;       ///< over all contacts
    std::optional<double> max_von_mises;
    std::optional<double> error_estimate;  ///< the worst of the contacts, of stress where there are none; relative
    std::vector<std::string> warnings;
    std::optional<ExpectationCount> expectation;
    std::vector<std::string> files;     ///< beside job.json
    std::vector<std::uintmax_t> sizes;  ///< of those, in bytes: after a power failure a file may be shorter, or empty
    double seconds = 0;                 ///< wall time; with `sizes` the only thing in it that a repetition changes
};

/// The word of a status: "ok", "solved_but", "differs", "failed", "refused", "broken".
std::string status_word(JobRecord::Status status);
/// Has the job what was asked for, be it with reservations?
bool ended_well(const JobRecord& record);
/// Is there nothing left to do for the job?
bool is_finished(const JobRecord& record);

/// The text of a job.json.
std::string job_json(const JobRecord& record);
/// Reads a job.json; nothing where the text is none, as after a power failure.
std::optional<JobRecord> parse_job_json(const std::string& text);

}  // namespace abut
