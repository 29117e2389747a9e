// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch/sweep.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "geometry/brep/input_error.hpp"
#include "src/batch/job_store.hpp"
#include "src/io/nearest_name.hpp"
#include "src/io/whole_file.hpp"
#include "src/results/result_units.hpp"

namespace abut {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* forms = "write NAME=FROM:TO:COUNT or NAME=VALUE,VALUE,...";

double number_in(const std::string& word, const std::string& text) {
    double value = 0;
    const char* end = word.data() + word.size();
    const auto read = std::from_chars(word.data(), end, value);
    if (word.empty() || read.ec != std::errc{} || read.ptr != end || !std::isfinite(value))
        throw InputError(shortened(text), "'" + shortened(word) + "' is no number", forms);
    return value;
}

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> words{""};
    for (char c : text) {
        if (c == at)
            words.emplace_back();
        else
            words.back() += c;
    }
    return words;
}

std::vector<double> evenly_spaced(const std::vector<std::string>& words, const std::string& text) {
    if (words.size() != 3) throw InputError(shortened(text), "a range has three numbers", forms);
    const double from = number_in(words[0], text), to = number_in(words[1], text), count = number_in(words[2], text);
    if (!(count >= 2) || count != std::floor(count) || count > static_cast<double>(most_sweep_jobs))
        throw InputError(shortened(text), "a range has a whole number of values, at least 2", forms);
    if (from == to) throw InputError(shortened(text), "the range begins where it ends", "give one value, or another end");
    std::vector<double> values;
    const int last = static_cast<int>(count) - 1;
    for (int k = 0; k <= last; ++k) values.push_back(k == last ? to : from + (to - from) * k / last);
    return values;
}

std::string padded(std::size_t number, std::size_t of) {
    const std::string digits = std::to_string(number);
    return std::string(std::to_string(of).size() - digits.size(), '0') + digits;
}

// ---- answers ----

/// A number of the result; nothing where it is null or not there.
std::optional<double> number_at(const Json& json, const char* pointer) {
    const Json::json_pointer at(pointer);
    if (!json.contains(at) || !json.at(at).is_number()) return std::nullopt;
    return json.at(at).get<double>();
}

/// A value with a relative error.
std::optional<SweepValue> value_of(std::optional<double> value, std::optional<double> relative_error) {
    if (!value) return std::nullopt;
    SweepValue result{*value};
    if (relative_error) result.error = std::abs(*value) * *relative_error;
    return result;
}

class Columns {
public:
    explicit Columns(Sweep& sweep) : sweep_(sweep) {}

    void set(SweepPoint& point, const SweepQuantity& quantity, const std::optional<SweepValue>& value) {
        const auto is_it = [&](const SweepQuantity& q) { return q.of == quantity.of && q.quantity == quantity.quantity; };
        const auto found = std::find_if(sweep_.quantities.begin(), sweep_.quantities.end(), is_it);
        const auto column = static_cast<std::size_t>(found - sweep_.quantities.begin());
        if (found == sweep_.quantities.end()) sweep_.quantities.push_back(quantity);
        if (point.values.size() <= column) point.values.resize(column + 1);
        point.values[column] = value;
    }

private:
    Sweep& sweep_;
};

/// Two parts that meet in several places have the contact's number beside them.
std::string name_of(const Json& contacts, std::size_t k) {
    const Json& parts = contacts[k].at("parts");
    const auto n = std::count_if(contacts.begin(), contacts.end(), [&](const Json& c) { return c.at("parts") == parts; });
    const std::string name = parts[0].get<std::string>() + " - " + parts[1].get<std::string>();
    return n > 1 ? name + " (" + contact_number(k) + ")" : name;
}

void read_answer(const Json& result, const ResultUnits& units, SweepPoint& point, Columns& columns) {
    const Json& contacts = result.at("contacts");
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        const Json& c = contacts[k];
        const std::string of = name_of(contacts, k);
        const std::optional<double> x = number_at(c, "/force/0"), y = number_at(c, "/force/1");
        columns.set(point, {of, "max pressure", units.stress},
                    value_of(number_at(c, "/max_pressure/value"), number_at(c, "/errors/peak")));
        columns.set(point, {of, "force", units.force},
                    value_of(x && y ? std::optional(std::hypot(*x, *y)) : std::nullopt, number_at(c, "/errors/force")));
        columns.set(point, {of, "contact length", units.length},
                    value_of(number_at(c, "/contact_length"), number_at(c, "/errors/length")));
    }
    for (const Json& part : result.at("parts"))
        columns.set(point, {part.at("name"), "max von Mises stress", units.stress},
                    value_of(number_at(part, "/max_von_mises/value"), number_at(part, "/max_von_mises/error")));
}

}  // namespace

SweptParameter parse_swept(const std::string& text) {
    const std::size_t sign = text.find('=');
    if (sign == std::string::npos || sign == 0) throw InputError(shortened(text), "this says no values of a parameter", forms);
    SweptParameter parameter{text.substr(0, sign), {}};
    const std::string values = text.substr(sign + 1);
    if (values.find(':') != std::string::npos) {
        parameter.values = evenly_spaced(split(values, ':'), text);
    } else {
        for (const std::string& word : split(values, ',')) parameter.values.push_back(number_in(word, text));
    }
    std::sort(parameter.values.begin(), parameter.values.end());
    if (std::adjacent_find(parameter.values.begin(), parameter.values.end()) != parameter.values.end())
        throw InputError(shortened(text), "a value is there twice", forms);
    return parameter;
}

BatchSource sweep_jobs(const std::vector<SweptParameter>& parameters) {
    std::size_t n = 1;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        for (std::size_t i = 0; i < k; ++i)
            if (parameters[i].name == parameters[k].name)
                throw InputError(parameters[k].name, "this parameter is there twice", "give all its values at once");
        n *= parameters[k].values.size();
        if (n > most_sweep_jobs)
            throw InputError("", "these are more than " + std::to_string(most_sweep_jobs) + " jobs", "take fewer values");
    }
    BatchSource source;
    source.names_files = false;
    for (const SweptParameter& p : parameters) source.parameters[p.name] = p.name;
    for (std::size_t j = 0; j < n; ++j) {
        BatchJob job;
        std::size_t rest = j;
        for (const SweptParameter& p : parameters) {
            const std::size_t k = rest % p.values.size();
            rest /= p.values.size();
            job.parameters[p.name] = p.values[k];
            job.name += (job.name.empty() ? "" : "_") + padded(k + 1, p.values.size());
        }
        source.jobs.push_back(std::move(job));
    }
    return source;
}

Sweep read_sweep(const std::string& scene, const std::vector<SweptParameter>& parameters, const std::string& out) {
    Sweep sweep;
    sweep.scene = scene;
    sweep.parameters = parameters;
    Columns columns(sweep);
    for (const BatchJob& job : sweep_jobs(parameters).jobs) {
        SweepPoint point{job.name, "missing", "", job.parameters, {}};
        if (const std::optional<JobRecord> record = stored_job(out, job.name)) {
            point.status = status_word(record->status);
            point.message = record->message;
            const std::string file = job_folder(out, job.name) + "/result.json";
            if (ended_well(*record) && std::filesystem::exists(file)) {
                Result labels;
                labels.length_unit = record->length_unit;
                labels.force_unit = record->force_unit;
                const Json result = Json::parse(read_whole_file(file), nullptr, false);
                if (result.is_object()) read_answer(result, result_units(labels), point, columns);
            }
        }
        sweep.points.push_back(std::move(point));
    }
    for (SweepPoint& point : sweep.points) point.values.resize(sweep.quantities.size());
    return sweep;
}

}  // namespace abut
