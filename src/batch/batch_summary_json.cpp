// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "src/batch/batch_summary.hpp"

namespace abut {

namespace {

using Json = nlohmann::ordered_json;

Json ratio(int part, int whole) {
    return whole == 0 ? Json(nullptr) : Json(static_cast<double>(part) / whole);
}

Json counts(const BatchSummary& summary) {
    Json json = Json::object();
    for (std::size_t i = 0; i < summary.count.size(); ++i)
        json[status_word(static_cast<JobRecord::Status>(i))] = summary.count[i];
    json["missing"] = summary.missing.size();
    return json;
}

Json expectation(const ExpectationCount& e) {
    return {{"expected", e.expected},
            {"expected_found", e.expected_found},
            {"detected", e.detected},
            {"detected_expected", e.detected_expected},
            {"precision", ratio(e.detected_expected, e.detected)},
            {"recall", ratio(e.expected_found, e.expected)}};
}

/// Keys of job.json that are for resuming only.
Json job(const JobRecord& record) {
    Json json = Json::parse(job_json(record));
    json.erase("abut");
    json.erase("key");
    json.erase("request");
    json.erase("sizes");
    return json;
}

}  // namespace

std::string summary_json(const BatchSummary& summary) {
    Json json{{"abut", 1}, {"counts", counts(summary)}};
    json["expectation"] = summary.expectation ? expectation(*summary.expectation) : Json(nullptr);
    json["missing"] = summary.missing;
    json["jobs"] = Json::array();
    for (const JobRecord& record : summary.jobs) json["jobs"].push_back(job(record));
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace abut
