// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "src/io/escape_xml.hpp"
#include "src/io/number_text.hpp"
#include "src/report/report_sections.hpp"
#include "src/results/result_units.hpp"
#include "src/results/verdict.hpp"

namespace abut::report {

namespace {

std::string contact_words(const Result& result, const ResultUnits& units) {
    const auto& contacts = result.contacts;
    const auto open = static_cast<std::size_t>(
        std::count_if(contacts.begin(), contacts.end(), [](const auto& c) { return c.status == "open"; }));
    std::string words = counted(contacts.size(), "contact");
    if (open > 0) words += open == contacts.size() ? " (open)" : " (" + std::to_string(open) + " open)";
    const auto largest = std::max_element(contacts.begin(), contacts.end(), [](const auto& a, const auto& b) {
        return a.max_pressure.value < b.max_pressure.value;
    });
    if (largest->max_pressure.value > 0)
        words += ", largest pressure " + with_unit(largest->max_pressure.value, 4, units.stress) + " on " +
                 largest->between[0] + " at " + place_text(largest->max_pressure.at, model_size(result));
    return words;
}

std::string stress_words(const Result& result, const ResultUnits& units) {
    const PartResult* most = most_stressed(result);
    if (!most) return "no contact";
    return "no contact; largest von Mises stress " + largest_stress_text(*most, 4, units.stress) + " in " + most->name +
           " at " + place_text(most->max_von_mises.at, model_size(result));
}

/// What there is, and the largest of it.
std::string facts(const Result& result) {
    const ResultUnits units = result_units(result);
    const std::string words = result.contacts.empty() ? stress_words(result, units) : contact_words(result, units);
    const std::string time = seconds_text(stage_seconds(result, "total"));
    return words + "; residual " + number_text(result.equilibrium.relative_residual, 1) + (time.empty() ? "" : "; " + time);
}

}  // namespace

std::string verdict_box(const Result& result) {
    const Verdict verdict = verdict_of(result);
    const std::string mood = verdict == Verdict::failed ? " failed" : verdict == Verdict::solved_but ? " doubtful" : "";
    const std::string box = "<p class=\"verdict" + mood + "\">" + escape_xml(verdict_sentence(result)) + "</p>\n";
    return verdict == Verdict::failed ? box : box + "<p class=\"facts\">" + escape_xml(facts(result)) + "</p>\n";
}

std::string warnings_box(const Result& result) {
    std::string html;
    for (const std::string& note : result.notes) html += "<p class=\"facts\">" + escape_xml(note) + "</p>\n";
    if (result.warnings.empty()) return html;
    html += "<div class=\"warnings\"><b>" + counted(result.warnings.size(), "warning") + "</b>\n<ul>\n";
    constexpr std::size_t most_shown = 7;
    for (std::size_t k = 0; k < result.warnings.size(); ++k) {
        if (k == most_shown) html += "</ul>\n<details><summary>and more</summary>\n<ul>\n";
        html += "<li>" + escape_xml(result.warnings[k]) + "</li>\n";
    }
    return html + (result.warnings.size() > most_shown ? "</ul></details></div>\n" : "</ul></div>\n");
}

}  // namespace abut::report
