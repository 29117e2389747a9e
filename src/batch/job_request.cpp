// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch/job_request.hpp"

#include "src/io/csv_field.hpp"

namespace abut {

std::vector<InputFile> template_files(const BatchRequest& request) {
    return request.template_file.empty() ? std::vector<InputFile>{} : input_files(request.template_file);
}

std::string job_request(const BatchRequest& request, const std::vector<InputFile>& template_files, const BatchJob& job) {
    std::map<std::string, std::string> settings = request.settings;
    for (const auto& [name, value] : job.parameters) settings["/" + name] = csv_field(value);
    const std::string own = request.own_settings ? request.own_settings(job) : "";
    if (!own.empty()) settings["job"] = own;
    return job_key(settings, template_files);
}

}  // namespace abut
