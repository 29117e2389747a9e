// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "src/io/number_text.hpp"
#include "src/io/text_table.hpp"
#include "src/results/result.hpp"
#include "src/results/result_units.hpp"
#include "src/results/verdict.hpp"
#include "src/results/warning_lines.hpp"

namespace abut {

namespace {

using Row = TextRow;

constexpr std::size_t most_open_lines = 3;  ///< more contacts that stay open share one line

std::string pressure_text(const ContactResult& contact) {
    std::string text = number_text(contact.max_pressure.value, 4);
    if (contact.errors) {
        const double error = std::max(contact.errors->pressure, contact.errors->peak);
        text += contact.errors->at_corner ? " at a corner" : " ± " + number_text(100 * error, 2) + " %";
    }
    return text;
}

/// Numbers of contacts, from 1, with runs put together: "5 to 9, 17".
std::string number_ranges(const std::vector<std::size_t>& numbers) {
    std::string text;
    for (std::size_t i = 0, end = 0; i < numbers.size(); i = end) {
        for (end = i + 1; end < numbers.size() && numbers[end] == numbers[end - 1] + 1;) ++end;
        text += (text.empty() ? "" : ", ") + contact_number(numbers[i]);
        if (end - i > 1) text += (end - i == 2 ? ", " : " to ") + contact_number(numbers[end - 1]);
    }
    return text;
}

std::string contact_rows(const Result& result, const ResultUnits& units) {
    if (result.contacts.empty()) return "no contacts\n";
    std::vector<std::size_t> open;
    for (std::size_t k = 0; k < result.contacts.size(); ++k)
        if (result.contacts[k].kind == "contact" && result.contacts[k].status == "open") open.push_back(k);
    if (open.size() <= most_open_lines) open.clear();
    std::vector<Row> rows{{"contact", "between", "status", heading("force on first", units.force),
                           heading("max pressure", units.stress), heading("length", units.length)}};
    for (std::size_t k = 0; k < result.contacts.size(); ++k) {
        const ContactResult& c = result.contacts[k];
        if (std::binary_search(open.begin(), open.end(), k)) continue;
        rows.push_back({contact_number(k), c.between[0] + " - " + c.between[1],
                        c.kind == "contact" ? c.status : c.kind + ", " + c.status, pair_text(c.force, 4), pressure_text(c),
                        number_text(c.contact_length, 4)});
    }
    std::string text = rows.size() > 1 ? aligned(rows) : "";
    if (!open.empty()) text += counted(open.size(), "open contact") + ": " + number_ranges(open) + "\n";
    return text;
}

std::string reaction_rows(const Result& result, const ResultUnits& units) {
    if (result.reactions.empty()) return "";
    std::vector<Row> rows{{"support", "", heading("reaction", units.force), heading("moment", units.moment)}};
    double force = 0, moment = 0;
    for (const Reaction& r : result.reactions) {
        force = std::max(force, r.force.norm());
        moment = std::max({moment, std::abs(r.moment), r.force.norm() * model_size(result)});
    }
    for (const Reaction& r : result.reactions)
        rows.push_back({std::to_string(r.support + 1), r.label,
                        pair_text({rounded_off(r.force.x(), force), rounded_off(r.force.y(), force)}, 4),
                        number_text(rounded_off(r.moment, moment), 4)});
    return "\n" + aligned(rows);
}

std::string preload_rows(const Result& result, const ResultUnits& units) {
    if (result.preloads.empty()) return "";
    std::vector<Row> rows{{"tightened", heading("to", units.force), heading("shortened by", units.length),
                           heading("carries under load", units.force)}};
    for (const PreloadResult& p : result.preloads)
        rows.push_back({p.part, number_text(p.force, 5), number_text(p.shortening, 4), number_text(p.force_under_load, 5)});
    return "\n" + aligned(rows);
}

std::string summary(const Result& result) {
    std::string text;
    if (const PartResult* most = most_stressed(result))
        text += "\nlargest von Mises stress: " + largest_stress_text(*most, 4, result_units(result).stress) + " in " +
                most->name + " at " + place_text(most->max_von_mises.at, model_size(result));
    text += "\nequilibrium: relative residual " + number_text(result.equilibrium.relative_residual, 2) + " of forces, " +
            number_text(result.equilibrium.relative_moment_residual, 2) + " of moments\n";
    return text;
}

std::string effort(const Result& result) {
    std::string text = counted(static_cast<std::size_t>(std::max(result.unknowns, 0)), "unknown") + " of degree " +
                       std::to_string(result.degree);
    if (result.multipliers > 0) text += ", " + counted(static_cast<std::size_t>(result.multipliers), "multiplier");
    const std::string time = seconds_text(stage_seconds(result, "total"));
    return text + (time.empty() ? "" : ", " + time) + "\n";
}

/// What was reached, and what more would cost.
std::string last_lines(const Result& result) {
    std::string text = verdict_sentence(result) + "\n";
    if (result.next_level)
        text += number_text(100 * result.next_level->target, 2) + " % (--accuracy " + result.next_level->accuracy +
                ") would take about " + seconds_text(result.next_level->seconds) + "\n";
    return text;
}

}  // namespace

std::string result_table(const Result& result) {
    const ResultUnits units = result_units(result);
    const bool failed = result.status != "ok";
    std::string text = result.title.empty() ? "" : result.title + "\n";
    if (failed) text += "FAILED: " + result.message + "\n";
    if (!failed || !result.contacts.empty()) text += contact_rows(result, units);
    text += reaction_rows(result, units);
    if (!failed) text += preload_rows(result, units);
    if (!failed) text += summary(result);
    if (result.unknowns > 0) text += effort(result);
    for (const std::string& note : result.notes) text += "note: " + note + "\n";
    text += warning_lines(result.warnings);
    if (!failed) text += last_lines(result);
    return text;
}

}  // namespace abut
