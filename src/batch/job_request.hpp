// SPDX-License-Identifier: GPL-3.0-or-later
// What a batch asks of its jobs: all that their answers depend on but their own files.
#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "src/batch/batch_source.hpp"
#include "src/batch/job_key.hpp"

namespace abut {

/// What the answers of a batch's jobs depend on.
struct BatchRequest {
    std::map<std::string, std::string> settings;  ///< options that change answers, and the program's version
    std::string template_file;                    ///< empty: none
    std::function<std::string(const BatchJob&)>
        own_settings{};  ///< what the answer of this job depends on besides; may be empty
};

/// The template and what it imports, as they are now.
std::vector<InputFile> template_files(const BatchRequest& request);

/// Settings, template and parameters of a job in one short text.
std::string job_request(const BatchRequest& request, const std::vector<InputFile>& template_files, const BatchJob& job);

}  // namespace abut
