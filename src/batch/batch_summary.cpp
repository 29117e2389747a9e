// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch/batch_summary.hpp"

#include <algorithm>
#include <set>

#include "src/batch/job_store.hpp"
#include "src/io/csv_field.hpp"
#include "src/io/number_text.hpp"
#include "src/io/write_file.hpp"
#include "src/results/result.hpp"

namespace abut {

namespace {

using Status = JobRecord::Status;

std::string field(const std::optional<int>& value) {
    return value ? std::to_string(*value) : "";
}
std::string field(const std::optional<double>& value) {
    return value ? csv_field(*value) : "";
}

void add(ExpectationCount& sum, const ExpectationCount& more) {
    sum.expected += more.expected;
    sum.expected_found += more.expected_found;
    sum.detected += more.detected;
    sum.detected_expected += more.detected_expected;
}

std::string ratio_text(int part, int whole) {
    return whole == 0 ? "-" : number_text(static_cast<double>(part) / whole, 4);
}

std::set<std::string> parameter_names(const BatchSummary& summary) {
    std::set<std::string> names;
    for (const JobRecord& job : summary.jobs)
        for (const auto& [name, value] : job.parameters) names.insert(name);
    return names;
}

std::string row(const JobRecord& job, bool expectation, const std::set<std::string>& parameters) {
    std::string line = csv_field(job.name) + "," + csv_field(job.file) + "," + job.mode + "," + status_word(job.status) + "," +
                       csv_field(job.message) + "," + field(job.parts) + "," + field(job.pairs) + "," + field(job.closed) +
                       "," + field(job.max_pressure) + "," + field(job.max_von_mises) + "," + field(job.error_estimate) + "," +
                       std::to_string(job.warnings.size());
    if (expectation && !job.expectation) line += ",,,,";
    if (expectation && job.expectation) {
        const ExpectationCount& e = *job.expectation;
        for (const int n : {e.expected, e.expected_found, e.detected, e.detected_expected}) line += "," + std::to_string(n);
    }
    for (const std::string& name : parameters) {
        const auto value = job.parameters.find(name);
        line += "," + (value == job.parameters.end() ? "" : csv_field(value->second));
    }
    return line + "," + csv_field(job.seconds) + "\n";
}

}  // namespace

BatchSummary summarize(const std::string& out, const BatchFile& batch) {
    BatchSummary summary;
    for (const BatchFile::Job& job : batch.jobs) {
        std::optional<JobRecord> record = stored_job(out, job.name);
        if (!record || !belongs(*record, job)) {
            summary.missing.push_back(job.name);
            if (record) summary.stale.push_back(job.name);
            continue;
        }
        ++summary.count[static_cast<std::size_t>(record->status)];
        if (record->expectation) {
            if (!summary.expectation) summary.expectation = ExpectationCount{};
            add(*summary.expectation, *record->expectation);
        }
        summary.jobs.push_back(std::move(*record));
    }
    return summary;
}

bool all_well(const BatchSummary& summary) {
    return std::all_of(summary.jobs.begin(), summary.jobs.end(), ended_well);
}

std::string expectation_text(const ExpectationCount& count) {
    return "precision " + ratio_text(count.detected_expected, count.detected) + " (" + std::to_string(count.detected_expected) +
           " of " + std::to_string(count.detected) + " detected pairs are expected), recall " +
           ratio_text(count.expected_found, count.expected) + " (" + std::to_string(count.expected_found) + " of " +
           std::to_string(count.expected) + " expected pairs are detected)";
}

std::string count_text(const BatchSummary& summary) {
    std::string text;
    for (std::size_t i = 0; i < summary.count.size(); ++i) {
        if (summary.count[i] == 0) continue;
        text += (text.empty() ? "" : ", ") + std::to_string(summary.count[i]) + " " + status_word(static_cast<Status>(i));
    }
    return text.empty() ? "none" : text;
}

std::string summary_csv(const BatchSummary& summary) {
    const std::set<std::string> parameters = parameter_names(summary);
    const bool expectation = summary.expectation.has_value();
    std::string text = "name,file,mode,status,message,parts,pairs,closed,max_pressure,max_von_mises,error_estimate,warnings";
    if (expectation) text += ",expected,expected_found,detected,detected_expected";
    for (const std::string& name : parameters) text += "," + csv_field(name);
    text += ",seconds\n";
    for (const JobRecord& job : summary.jobs) text += row(job, expectation, parameters);
    return text;
}

void write_summary(const std::string& out, const BatchFile& batch, const BatchSummary& summary) {
    write_file(out, "summary.csv", summary_csv(summary));
    write_file(out, "summary.json", summary_json(summary));
    write_file(out, "index.html", index_html(summary, batch.source));
}

}  // namespace abut
