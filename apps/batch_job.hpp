// SPDX-License-Identifier: GPL-3.0-or-later
// One job of a batch: what `analyze` or `contacts` would do with its file.
#pragma once
#include <optional>
#include <string>

#include "apps/arguments.hpp"
#include "src/batch/batch_source.hpp"
#include "src/batch/job_record.hpp"
#include "src/contact/expected_pairs.hpp"
#include "src/scene/read_drawing.hpp"

namespace abut {

/// What the call of `batch` says of every job.
struct JobSettings {
    std::string template_file;  ///< empty: each job's file is a scene of its own, or a drawing to be searched for contacts
    bool contacts_only = false;
    Arguments arguments;             ///< for --accuracy
    ImportOptions import_options;    ///< of drawings without a template
    std::optional<double> distance;  ///< --distance
    std::optional<ExpectationTable> expectations;
};

/// The expected pairs of a job: by its name, its file as it is given, or the last part of that; nullptr without any.
const std::vector<ExpectedPair>* expected_for(const JobSettings& settings, const BatchJob& job);

/// Writes result.json, contact_<k>.csv and report.html (as the scene asks), or contacts.json and contacts.svg, and
/// thumbnail.svg. Throws InputError where the input is wrong, StoreError where a file cannot be written.
JobRecord do_batch_job(const JobSettings& settings, const BatchJob& job, const std::string& folder);

}  // namespace abut
