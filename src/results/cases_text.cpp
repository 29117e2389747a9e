// SPDX-License-Identifier: GPL-3.0-or-later
// cases.json, envelope.csv and the table of load cases.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "src/io/build_id.hpp"
#include "src/io/csv_field.hpp"
#include "src/io/number_text.hpp"
#include "src/io/text_table.hpp"
#include "src/results/case_result.hpp"
#include "src/results/result_units.hpp"
#include "src/results/warning_lines.hpp"

namespace abut {

namespace {

using Json = nlohmann::ordered_json;
using Cases = std::vector<CaseResult>;

Json finite_number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json place(const Vec2& at) {
    return Json::array({finite_number(at.x()), finite_number(at.y())});
}

Json largest(const CaseValue& v, const Cases& cases, bool has_place) {
    Json j{{"value", finite_number(v.value)}};
    if (has_place) j["at"] = place(v.at);
    j["case"] = cases[v.in_case].name;
    return j;
}

const ContactResult* most_pressed(const Result& result) {
    const ContactResult* most = nullptr;
    for (const ContactResult& c : result.contacts)
        if (c.max_pressure.value > (most ? most->max_pressure.value : 0)) most = &c;
    return most;
}

Json summary(const CaseResult& c, std::size_t k) {
    const Result& r = c.result;
    Json loads = Json::object(), reasons = Json::array();
    for (const auto& [name, factor] : c.factors) loads[name] = factor;
    for (const Reason& reason : r.reasons) reasons.push_back(reason.text);
    Json j{{"name", c.name},
           {"loads", std::move(loads)},
           {"folder", case_folder(k)},
           {"status", r.status},
           {"verdict", verdict_word(verdict_of(r))},
           {"reasons", std::move(reasons)}};
    if (r.status != "ok") j["message"] = r.message;
    const bool solved = r.status == "ok";
    const ContactResult* pressed = solved ? most_pressed(r) : nullptr;
    const PartResult* stressed = solved ? most_stressed(r) : nullptr;
    j["max_pressure"] = pressed ? Json{{"value", finite_number(pressed->max_pressure.value)},
                                       {"at", place(pressed->max_pressure.at)},
                                       {"parts", Json(pressed->parts)}}
                                : Json(nullptr);
    j["max_von_mises"] = stressed ? Json{{"value", finite_number(stressed->max_von_mises.value)},
                                         {"at", place(stressed->max_von_mises.at)},
                                         {"part", stressed->name}}
                                  : Json(nullptr);
    return j;
}

Json names_of(const std::vector<std::size_t>& list, const Cases& cases) {
    Json names = Json::array();
    for (std::size_t k : list) names.push_back(cases[k].name);
    return names;
}

Json envelope(const Cases& cases) {
    const Envelope all = envelope_of(cases);
    Json contacts = Json::array(), parts = Json::array();
    for (const ContactEnvelope& e : all.contacts)
        contacts.push_back({{"parts", Json(e.parts)},
                            {"edges", Json(e.edges)},
                            {"max_pressure", largest(e.max_pressure, cases, true)},
                            {"force", largest(e.force, cases, false)},
                            {"contact_length", largest(e.contact_length, cases, false)},
                            {"open_in", names_of(e.open_in, cases)}});
    for (const PartEnvelope& e : all.parts)
        parts.push_back({{"name", e.name},
                         {"max_von_mises", largest(e.max_von_mises, cases, true)},
                         {"max_displacement", largest(e.max_displacement, cases, true)},
                         {"utilisation", e.utilisation ? largest(*e.utilisation, cases, false) : Json(nullptr)}});
    return {{"contacts", std::move(contacts)}, {"parts", std::move(parts)}};
}

std::string case_rows(const Cases& cases) {
    const ResultUnits units = result_units(cases.front().result);
    std::vector<TextRow> rows{{"case", "", "verdict", heading("max pressure", units.stress), "between",
                               heading("max von Mises", units.stress), "in"}};
    for (std::size_t k = 0; k < cases.size(); ++k) {
        const Result& r = cases[k].result;
        TextRow row{std::to_string(k + 1), cases[k].name, verdict_word(verdict_of(r))};
        const ContactResult* pressed = r.status == "ok" ? most_pressed(r) : nullptr;
        const PartResult* stressed = r.status == "ok" ? most_stressed(r) : nullptr;
        row.push_back(pressed ? number_text(pressed->max_pressure.value, 4) : "");
        row.push_back(pressed ? pressed->parts[0] + " - " + pressed->parts[1] : "");
        row.push_back(stressed ? number_text(stressed->max_von_mises.value, 4) : "");
        row.push_back(stressed ? stressed->name : "");
        rows.push_back(std::move(row));
    }
    return aligned(rows);
}

/// What all cases warn of once, then what single ones do.
std::string remarks(const Cases& cases) {
    std::vector<std::string> told, lines;
    for (const CaseResult& c : cases)
        for (const std::string& warning : c.result.warnings) {
            if (std::find(told.begin(), told.end(), warning) != told.end()) continue;
            told.push_back(warning);
            std::string in;
            for (const CaseResult& other : cases) {
                const auto& all = other.result.warnings;
                if (std::find(all.begin(), all.end(), warning) != all.end()) in += (in.empty() ? "" : ", ") + other.name;
            }
            lines.push_back("in " + in + ": " + warning);
        }
    return warning_lines(lines);
}

}  // namespace

std::vector<EnvelopeLine> envelope_lines(const Cases& cases) {
    const Envelope all = envelope_of(cases);
    const ResultUnits units = result_units(cases.front().result);
    std::vector<EnvelopeLine> lines;
    for (const ContactEnvelope& e : all.contacts) {
        const std::string of = joined(e.edges[0], " ") + " - " + joined(e.edges[1], " ");
        lines.push_back({of, "max pressure", units.stress, e.max_pressure, true});
        lines.push_back({of, "force", units.force, e.force, false});
        lines.push_back({of, "contact length", units.length, e.contact_length, false});
    }
    for (const PartEnvelope& e : all.parts) {
        lines.push_back({e.name, "max von Mises stress", units.stress, e.max_von_mises, true});
        lines.push_back({e.name, "max displacement", units.length, e.max_displacement, true});
        if (e.utilisation) lines.push_back({e.name, "utilisation", "", *e.utilisation, false});
    }
    return lines;
}

std::string cases_json(const Cases& cases) {
    Json j{{"abut", 1},
           {"title", cases.front().result.title},
           {"build", program_build()},
           {"verdict", verdict_word(verdict_of(cases))},
           {"cases", Json::array()}};
    for (std::size_t k = 0; k < cases.size(); ++k) j["cases"].push_back(summary(cases[k], k));
    j["envelope"] = envelope(cases);
    return j.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<std::string> folders_of_cases(const std::string& text) {
    const Json json = Json::parse(text, nullptr, false);
    std::vector<std::string> folders;
    if (!json.is_object() || !json.contains("cases") || !json["cases"].is_array()) return folders;
    for (std::size_t k = 0; k < json["cases"].size(); ++k) folders.push_back(case_folder(k));
    return folders;
}

std::string envelope_csv(const Cases& cases) {
    std::string text = "of,quantity,unit,value,case,x,y\n";
    for (const EnvelopeLine& line : envelope_lines(cases)) {
        text += csv_field(line.of) + "," + line.quantity + "," + csv_field(line.unit) + "," +
                number_text(line.largest.value, 12) + "," + csv_field(cases[line.largest.in_case].name) + ",";
        if (line.has_place) text += number_text(line.largest.at.x(), 12) + "," + number_text(line.largest.at.y(), 12);
        text += line.has_place ? "\n" : ",\n";
    }
    return text;
}

std::string cases_table(const Cases& cases) {
    const Result& first = cases.front().result;
    std::string text = first.title.empty() ? "" : first.title + "\n";
    for (const CaseResult& c : cases)
        if (c.result.status != "ok") text += "FAILED: " + c.name + ": " + c.result.message + "\n";
    text += case_rows(cases) + "\nlargest of all cases:\n";
    std::vector<TextRow> rows{{"of", "quantity", "value", "case"}};
    for (const EnvelopeLine& line : envelope_lines(cases))
        rows.push_back({line.of, line.quantity, with_unit(line.largest.value, 4, line.unit),
                        line.largest.value > 0 ? cases[line.largest.in_case].name : ""});
    text += aligned(rows) + remarks(cases);
    for (const CaseResult& c : cases)
        if (c.result.status == "ok") text += c.name + ": " + verdict_sentence(c.result) + "\n";
    return text;
}

}  // namespace abut
