// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch/batch_file.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "geometry/brep/input_error.hpp"
#include "src/io/whole_file.hpp"

namespace abut {

namespace {

using Json = nlohmann::ordered_json;

std::string template_hash(const std::vector<InputFile>& files) {
    return files.empty() ? "" : job_key({}, files);
}

Json to_json(const BatchFile::Job& job) {
    return {{"name", job.name},
            {"file", job.file},
            {"parameters", job.parameters.empty() ? Json::object() : Json(job.parameters)},
            {"request", job.request}};
}

BatchFile batch_of(const Json& json) {
    BatchFile batch{json.at("source"), json.at("settings").get<std::map<std::string, std::string>>(), json.at("template"), {}};
    for (const Json& job : json.at("jobs"))
        batch.jobs.push_back(
            {job.at("name"), job.at("file"), job.at("parameters").get<std::map<std::string, double>>(), job.at("request")});
    return batch;
}

/// Of a version that did not write what was asked of the jobs.
bool is_old(const Json& json) {
    return json.is_object() && json.contains("jobs") && json.contains("settings") && !json.contains("template");
}

}  // namespace

BatchFile batch_file(const std::string& source, const BatchRequest& request, const std::vector<BatchJob>& jobs) {
    const std::vector<InputFile> files = template_files(request);
    BatchFile batch{source, request.settings, template_hash(files), {}};
    batch.jobs.reserve(jobs.size());
    for (const BatchJob& job : jobs)
        batch.jobs.push_back({job.name, job.file, job.parameters, job_request(request, files, job)});
    return batch;
}

std::string batch_json(const BatchFile& batch) {
    Json jobs = Json::array();
    for (const BatchFile::Job& job : batch.jobs) jobs.push_back(to_json(job));
    const Json json{{"abut", 1},
                    {"source", batch.source},
                    {"settings", batch.settings.empty() ? Json::object() : Json(batch.settings)},
                    {"template", batch.scene_template},
                    {"jobs", std::move(jobs)}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

BatchFile read_batch_file(const std::string& out) {
    const std::string path = (std::filesystem::path(out) / "batch.json").string();
    const std::optional<std::string> text = whole_file(path);
    if (!text)
        throw InputError(out, "this is no output folder of abut batch: there is no batch.json in it",
                         "give the OUT of a batch");
    const Json json = Json::parse(*text, nullptr, false);
    if (is_old(json))
        throw InputError(path, "an older abut wrote this, which did not note what was asked of the jobs",
                         "run the batch again with this version");
    try {
        return batch_of(json);
    } catch (const std::exception&) {
        throw InputError(path, "this is no batch.json of abut batch", "run the batch again: it keeps what is finished");
    }
}

bool belongs(const JobRecord& record, const BatchFile::Job& job) {
    return record.request == job.request;
}

}  // namespace abut
