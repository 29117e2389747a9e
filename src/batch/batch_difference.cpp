// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch/batch_difference.hpp"

#include <filesystem>
#include <map>
#include <set>

#include "src/io/csv_field.hpp"

namespace abut {

namespace {

using Job = BatchFile::Job;

/// "X is 1 in out1 and 2 in out2"
std::string in_both(const std::string& what, const FolderBatch& a, const std::string& of_a, const FolderBatch& b,
                    const std::string& of_b) {
    return what + " is " + of_a + " in " + a.folder + " and " + of_b + " in " + b.folder;
}

std::string setting_of(const BatchFile& batch, const std::string& name) {
    const auto found = batch.settings.find(name);
    return found == batch.settings.end() || found->second.empty() ? "not given" : found->second;
}

std::string settings_difference(const FolderBatch& a, const FolderBatch& b) {
    std::map<std::string, std::string> names = a.batch.settings;
    names.insert(b.batch.settings.begin(), b.batch.settings.end());
    for (const auto& [name, value] : names) {
        const std::string of_a = setting_of(a.batch, name), of_b = setting_of(b.batch, name);
        if (of_a != of_b) return in_both(name == "version" ? "the program's version" : "the option " + name, a, of_a, b, of_b);
    }
    return "";
}

std::string template_difference(const FolderBatch& a, const FolderBatch& b) {
    if (a.batch.scene_template == b.batch.scene_template) return "";
    if (a.batch.scene_template.empty() || b.batch.scene_template.empty())
        return "only " + (a.batch.scene_template.empty() ? b : a).folder + " has a template";
    return "the templates, or files that they import, are not the same";
}

std::string parameter_of(const Job& job, const std::string& name) {
    const auto found = job.parameters.find(name);
    return found == job.parameters.end() ? "not given" : csv_field(found->second);
}

std::string job_difference(const FolderBatch& a, const Job& of_a, const FolderBatch& b, const Job& of_b, std::size_t number) {
    const std::string which = "job " + std::to_string(number);
    if (of_a.name != of_b.name) return in_both(which, a, of_a.name, b, of_b.name);
    const std::string file_a = std::filesystem::path(of_a.file).filename().string(),
                      file_b = std::filesystem::path(of_b.file).filename().string();
    if (file_a != file_b) return in_both("the file of " + which + ", " + of_a.name + ",", a, file_a, b, file_b);
    std::set<std::string> names;
    for (const Job& job : {of_a, of_b})
        for (const auto& [name, value] : job.parameters) names.insert(name);
    for (const std::string& name : names)
        if (parameter_of(of_a, name) != parameter_of(of_b, name))
            return in_both("the parameter " + name + " of " + which + ", " + of_a.name + ",", a, parameter_of(of_a, name), b,
                           parameter_of(of_b, name));
    return of_a.request == of_b.request ? "" : "what --expect says of " + which + ", " + of_a.name + ", is not the same";
}

std::string jobs_difference(const FolderBatch& a, const FolderBatch& b) {
    const std::vector<Job>&jobs_a = a.batch.jobs, &jobs_b = b.batch.jobs;
    if (jobs_a.size() != jobs_b.size())
        return in_both("the number of jobs", a, std::to_string(jobs_a.size()), b, std::to_string(jobs_b.size()));
    for (std::size_t i = 0; i < jobs_a.size(); ++i) {
        const std::string what = job_difference(a, jobs_a[i], b, jobs_b[i], i + 1);
        if (!what.empty()) return what;
    }
    return "";
}

}  // namespace

std::string difference(const FolderBatch& a, const FolderBatch& b) {
    for (const auto compare : {settings_difference, template_difference, jobs_difference}) {
        const std::string what = compare(a, b);
        if (!what.empty()) return what;
    }
    return "";
}

}  // namespace abut
