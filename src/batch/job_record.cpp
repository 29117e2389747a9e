// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch/job_record.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace abut {

namespace {

using Json = nlohmann::ordered_json;
using Status = JobRecord::Status;

constexpr std::array<const char*, 6> state_words{"ok", "solved_but", "differs", "failed", "refused", "broken"};

template <class T>
Json or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

template <class T>
std::optional<T> value_in(const Json& json, const char* key) {
    const Json& value = json.at(key);
    return value.is_null() ? std::nullopt : std::optional(value.get<T>());
}

std::optional<Status> status_of(const std::string& word) {
    for (std::size_t i = 0; i < state_words.size(); ++i)
        if (word == state_words[i]) return static_cast<Status>(i);
    return std::nullopt;
}

Json to_json(const ExpectationCount& e) {
    return {{"expected", e.expected},
            {"expected_found", e.expected_found},
            {"detected", e.detected},
            {"detected_expected", e.detected_expected},
            {"differences", e.differences}};
}

ExpectationCount expectation_of(const Json& j) {
    return {j.at("expected"), j.at("expected_found"), j.at("detected"), j.at("detected_expected"),
            j.at("differences").get<std::vector<std::string>>()};
}

JobRecord record_of(const Json& j) {
    JobRecord r;
    r.name = j.at("name");
    r.file = j.at("file");
    r.mode = j.at("mode");
    r.status = status_of(j.at("status")).value();
    r.message = j.at("message");
    r.key = j.at("key");
    r.request = j.at("request");
    r.parameters = j.at("parameters").get<std::map<std::string, double>>();
    r.title = j.at("title");
    r.length_unit = j.at("units").at("length");
    r.force_unit = j.at("units").at("force");
    r.parts = value_in<int>(j, "parts");
    r.pairs = value_in<int>(j, "pairs");
    r.closed = value_in<int>(j, "closed");
    r.max_pressure = value_in<double>(j, "max_pressure");
    r.max_von_mises = value_in<double>(j, "max_von_mises");
    r.error_estimate = value_in<double>(j, "error_estimate");
    r.warnings = j.at("warnings").get<std::vector<std::string>>();
    if (!j.at("expectation").is_null()) r.expectation = expectation_of(j.at("expectation"));
    r.files = j.at("files").get<std::vector<std::string>>();
    r.sizes = j.at("sizes").get<std::vector<std::uintmax_t>>();
    r.seconds = j.at("seconds");
    return r;
}

}  // namespace

std::string status_word(Status status) {
    return state_words[static_cast<std::size_t>(status)];
}

bool ended_well(const JobRecord& record) {
    return record.status == Status::ok || record.status == Status::solved_but;
}

bool is_finished(const JobRecord& record) {
    return record.status != Status::broken;
}

std::string job_json(const JobRecord& r) {
    const Json json{{"abut", 1},
                    {"name", r.name},
                    {"file", r.file},
                    {"mode", r.mode},
                    {"status", status_word(r.status)},
                    {"message", r.message},
                    {"title", r.title},
                    {"units", {{"length", r.length_unit}, {"force", r.force_unit}}},
                    {"parameters", r.parameters.empty() ? Json::object() : Json(r.parameters)},
                    {"parts", or_null(r.parts)},
                    {"pairs", or_null(r.pairs)},
                    {"closed", or_null(r.closed)},
                    {"max_pressure", or_null(r.max_pressure)},
                    {"max_von_mises", or_null(r.max_von_mises)},
                    {"error_estimate", or_null(r.error_estimate)},
                    {"warnings", r.warnings},
                    {"expectation", r.expectation ? to_json(*r.expectation) : Json(nullptr)},
                    {"files", r.files},
                    {"sizes", r.sizes},
                    {"key", r.key},
                    {"request", r.request},
                    {"seconds", r.seconds}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<JobRecord> parse_job_json(const std::string& text) {
    try {
        return record_of(Json::parse(text));
    } catch (const std::exception&) {  // half a file, or a file of someone else: the job is done again
        return std::nullopt;
    }
}

}  // namespace abut
