// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch_file.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "geometry/input_error.hpp"
#include "src/whole_file.hpp"

namespace abut {

namespace {

using Json = nlohmann::ordered_json;

std::string value_of(const BatchFile& batch, const std::string& name) {
    const auto found = batch.settings.find(name);
    return found == batch.settings.end() || found->second.empty() ? "none" : found->second;
}

}  // namespace

BatchFile batch_file(const std::string& source, const std::map<std::string, std::string>& settings,
                     const std::vector<BatchJob>& jobs) {
    BatchFile batch{source, settings, {}};
    batch.jobs.reserve(jobs.size());
    for (const BatchJob& job : jobs) batch.jobs.push_back({job.name, job.file});
    return batch;
}

std::string batch_json(const BatchFile& batch) {
    Json jobs = Json::array();
    for (const BatchFile::Job& job : batch.jobs) jobs.push_back({{"name", job.name}, {"file", job.file}});
    const Json json{{"abut", 1}, {"source", batch.source}, {"settings", batch.settings}, {"jobs", std::move(jobs)}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

BatchFile read_batch_file(const std::string& out) {
    const std::string path = (std::filesystem::path(out) / "batch.json").string();
    const std::optional<std::string> text = whole_file(path);
    if (!text)
        throw InputError(out, "this is no output folder of abut batch: there is no batch.json in it",
                         "give the OUT of a batch");
    try {
        const Json json = Json::parse(*text);
        BatchFile batch{json.at("source"), json.at("settings").get<std::map<std::string, std::string>>(), {}};
        for (const Json& job : json.at("jobs")) batch.jobs.push_back({job.at("name"), job.at("file")});
        return batch;
    } catch (const std::exception&) {
        throw InputError(path, "this is no batch.json of abut batch", "run the batch again: it keeps what is finished");
    }
}

std::string difference(const BatchFile& a, const BatchFile& b) {
    std::map<std::string, std::string> names = a.settings;
    names.insert(b.settings.begin(), b.settings.end());
    for (const auto& [name, value] : names)
        if (value_of(a, name) != value_of(b, name)) return name + ": " + value_of(a, name) + " and " + value_of(b, name);
    if (a.jobs.size() != b.jobs.size()) return std::to_string(a.jobs.size()) + " jobs and " + std::to_string(b.jobs.size());
    for (std::size_t i = 0; i < a.jobs.size(); ++i)
        if (a.jobs[i].name != b.jobs[i].name)
            return "job " + std::to_string(i + 1) + ": " + a.jobs[i].name + " and " + b.jobs[i].name;
    return "";
}

}  // namespace abut
