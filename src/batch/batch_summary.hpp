// SPDX-License-Identifier: GPL-3.0-or-later
// What a batch came to: summary.csv, summary.json and index.html of its folder.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "src/batch/batch_file.hpp"
#include "src/batch/job_record.hpp"

namespace abut {

/// The records of a batch and their counts.
struct BatchSummary {
    std::vector<JobRecord> jobs;                  ///< those that OUT has, in the batch's order
    std::vector<std::string> missing;             ///< names of the others
    std::vector<std::string> stale;               ///< those of the missing that OUT has from another batch: other settings,
                                                  ///< template or parameters
    std::array<int, 6> count{};                   ///< by JobRecord::Status
    std::optional<ExpectationCount> expectation;  ///< over all jobs that had one; without its lines
};

/// Sums up what is in OUT/jobs now. Cost: one small file read for each job.
BatchSummary summarize(const std::string& out, const BatchFile& batch);

/// Did every job of these end well?
bool all_well(const BatchSummary& summary);
/// The counts in words: "precision 0.98 (49 of 50 detected pairs are expected), recall 1 (49 of 49 expected pairs are
/// detected)".
std::string expectation_text(const ExpectationCount& count);
/// The statuses in words: "996 ok, 3 refused, 1 failed".
std::string count_text(const BatchSummary& summary);

/// The text of summary.csv: one row a job. Parameters are the columns before the last, "seconds", which alone changes from run
/// to run.
std::string summary_csv(const BatchSummary& summary);
std::string summary_json(const BatchSummary& summary);
/// The text of index.html: one file that needs no network, with pictures out of the jobs' folders; sorted and filtered in the
/// page, failures first.
std::string index_html(const BatchSummary& summary, const std::string& title);

/// Writes summary.csv, summary.json and index.html into OUT, each by way of a temporary name. Throws InputError where they
/// cannot be written.
void write_summary(const std::string& out, const BatchFile& batch, const BatchSummary& summary);

}  // namespace abut
