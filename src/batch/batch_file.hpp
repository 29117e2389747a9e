// SPDX-License-Identifier: GPL-3.0-or-later
// batch.json: which batch an output folder belongs to. All shards of a batch write the same one.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "src/batch/batch_source.hpp"
#include "src/batch/job_record.hpp"
#include "src/batch/job_request.hpp"

namespace abut {

/// A batch: its settings, and its jobs with what each was asked.
struct BatchFile {
    std::string source;                           ///< as it was given; for titles
    std::map<std::string, std::string> settings;  ///< options that change answers, and the program's version
    std::string scene_template;                   ///< hash of the template and of what it imports; empty: none
    struct Job {
        std::string name, file;
        std::map<std::string, double> parameters{};
        std::string request{};  ///< src/batch/job_request.hpp
    };
    std::vector<Job> jobs;  ///< of all shards, in their order
};

/// What the batch.json of a batch of these jobs says; source: as it was given.
BatchFile batch_file(const std::string& source, const BatchRequest& request, const std::vector<BatchJob>& jobs);

/// The text of a batch.json.
std::string batch_json(const BatchFile& batch);
/// Reads the batch.json of an output folder. Throws InputError where there is none, where it is wrong, or where it is of an
/// older version that did not say what was asked of the jobs.
BatchFile read_batch_file(const std::string& out);

/// Was the record made by this batch: with its settings, template and parameters?
bool belongs(const JobRecord& record, const BatchFile::Job& job);

}  // namespace abut
