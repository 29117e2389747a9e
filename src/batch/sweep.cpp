// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch/sweep.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
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
        throw InputError(shortened(text), "a range has a whole number of values, from 2 to " + std::to_string(most_sweep_jobs),
                         forms);
    if (from == to) throw InputError(shortened(text), "the range begins where it ends", "give one value, or another end");
    std::vector<double> values;
    const int last = static_cast<int>(count) - 1;
    for (int k = 0; k <= last; ++k) values.push_back(std::lerp(from, to, static_cast<double>(k) / last));
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

/// A contact's column: its parts, and what tells it from others of theirs.
struct ContactKey {
    std::string parts, edges;
    int which = 0;  ///< of several on the same edges
    bool operator==(const ContactKey&) const = default;
};

std::string joined_names(const Json& names, const char* between) {
    std::string text;
    for (const Json& name : names) text += (text.empty() ? "" : between) + name.get<std::string>();
    return text;
}

class Columns {
public:
    explicit Columns(Sweep& sweep) : sweep_(sweep) {}

    void read(const Json& result, const ResultUnits& units, SweepPoint& point) {
        std::vector<ContactKey> met;
        for (const Json& c : result.at("contacts")) {
            ContactKey key{joined_names(c.at("parts"), " - "),
                           joined_names(c.at("edges").at(0), " ") + " - " + joined_names(c.at("edges").at(1), " "), 0};
            while (std::find(met.begin(), met.end(), key) != met.end()) ++key.which;
            met.push_back(key);
            read_contact(c, units, key, point);
        }
        for (const Json& part : result.at("parts")) {
            const std::string name = part.at("name");
            set(point, {"", name, 0}, {name, "max von Mises stress", units.stress},
                value_of(number_at(part, "/max_von_mises/value"), number_at(part, "/max_von_mises/error")));
        }
    }

    /// Parts that meet in several places are told apart by their edges.
    void name_contacts() {
        for (std::size_t k = 0; k < keys_.size(); ++k) {
            if (keys_[k].parts.empty()) continue;
            const auto is_other = [&](const ContactKey& key) { return key.parts == keys_[k].parts && !(key == keys_[k]); };
            if (std::any_of(keys_.begin(), keys_.end(), is_other))
                sweep_.quantities[k].of =
                    keys_[k].edges + (keys_[k].which > 0 ? " (" + std::to_string(keys_[k].which + 1) + ")" : "");
        }
    }

private:
    void read_contact(const Json& c, const ResultUnits& units, const ContactKey& key, SweepPoint& point) {
        const std::optional<double> x = number_at(c, "/force/0"), y = number_at(c, "/force/1");
        set(point, key, {key.parts, "max pressure", units.stress},
            value_of(number_at(c, "/max_pressure/value"), number_at(c, "/errors/peak")));
        set(point, key, {key.parts, "force", units.force},
            value_of(x && y ? std::optional(std::hypot(*x, *y)) : std::nullopt, number_at(c, "/errors/force")));
        set(point, key, {key.parts, "contact length", units.length},
            value_of(number_at(c, "/contact_length"), number_at(c, "/errors/length")));
    }

    void set(SweepPoint& point, const ContactKey& key, const SweepQuantity& quantity, const std::optional<SweepValue>& value) {
        std::size_t column = 0;
        while (column < keys_.size() && !(keys_[column] == key && sweep_.quantities[column].quantity == quantity.quantity))
            ++column;
        if (column == keys_.size()) {
            keys_.push_back(key);
            sweep_.quantities.push_back(quantity);
        }
        if (point.values.size() <= column) point.values.resize(column + 1);
        point.values[column] = value;
    }

    Sweep& sweep_;
    std::vector<ContactKey> keys_;  // by quantity
};

SweepPoint read_point(const BatchFile& batch, const BatchJob& job, const std::string& out, Columns& columns) {
    SweepPoint point{job.name, "missing", "", false, job.parameters, {}};
    const std::optional<JobRecord> record = stored_job(out, job.name);
    const auto asked = std::find_if(batch.jobs.begin(), batch.jobs.end(), [&](const auto& j) { return j.name == job.name; });
    if (!record || asked == batch.jobs.end() || !belongs(*record, *asked)) return point;
    point.status = status_word(record->status);
    point.message = record->message;
    const auto has_file = [&](const char* name) {
        return std::find(record->files.begin(), record->files.end(), name) != record->files.end();
    };
    point.has_report = has_file("report.html");
    if (!ended_well(*record) || !has_file("result.json")) return point;
    Result labels;
    labels.length_unit = record->length_unit;
    labels.force_unit = record->force_unit;
    const Json result = Json::parse(read_whole_file(job_folder(out, job.name) + "/result.json"), nullptr, false);
    if (result.is_object()) columns.read(result, result_units(labels), point);
    return point;
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
        throw InputError(shortened(text), "a value is there twice, or values lie closer than numbers can tell", forms);
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

Sweep read_sweep(const BatchFile& batch, const std::vector<SweptParameter>& parameters, const std::string& out) {
    Sweep sweep;
    sweep.scene = batch.source;
    sweep.parameters = parameters;
    Columns columns(sweep);
    for (const BatchJob& job : sweep_jobs(parameters).jobs) sweep.points.push_back(read_point(batch, job, out, columns));
    columns.name_contacts();
    for (SweepPoint& point : sweep.points) point.values.resize(sweep.quantities.size());
    return sweep;
}

}  // namespace abut
