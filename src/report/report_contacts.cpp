// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "src/io/escape_xml.hpp"
#include "src/report/report_sections.hpp"
#include "src/results/result_units.hpp"

namespace abut::report {

namespace {

constexpr std::size_t most_printed = 8;    ///< the pictures of the strongest go to paper, the others stay on the screen
constexpr std::size_t most_closeups = 24;  ///< beyond it the page would grow too large; tables and csv files have all contacts

std::string title(const ContactResult& c, std::size_t k) {
    std::string words = c.between[0] + " – " + c.between[1];
    if (!c.interface.empty()) words += ", " + c.interface;
    return "<h3><span class=\"disc\">" + contact_number(k) + "</span> " + escape_xml(words) + "</h3>\n";
}

std::string sentence(const ContactResult& c, const ResultUnits& units, double size) {
    std::string words = (c.kind == "contact" ? "" : c.kind + ", ") + c.status;
    if (c.status != "open")
        words += "; force on " + c.parts[0] + " " + pair_text(c.force, 4) + (units.force.empty() ? "" : " " + units.force) +
                 "; length " + with_unit(c.contact_length, 4, units.length) + "; largest pressure " +
                 with_unit(c.max_pressure.value, 4, units.stress) + " at " + place_text(c.max_pressure.at, size);
    return "<p>" + escape_xml(words) + "</p>\n";
}

}  // namespace

std::string contacts_section(const Result& result) {
    if (result.contacts.empty()) return "";
    const ResultUnits units = result_units(result);
    std::vector<double> pressures;
    for (const ContactResult& c : result.contacts) pressures.push_back(c.max_pressure.value);
    std::sort(pressures.rbegin(), pressures.rend());
    const double least_printed = pressures.size() > most_printed ? pressures[most_printed - 1] : 0;
    std::string html = "<section><h2>Contacts</h2>\n";
    for (std::size_t k = 0; k < result.contacts.size(); ++k) {
        const ContactResult& c = result.contacts[k];
        html += (c.max_pressure.value < least_printed ? "<article class=\"weak\">" : "<article>") + title(c, k) +
                sentence(c, units, model_size(result));
        const std::string pictures = contact_curves(result, k) + (k < most_closeups ? contact_closeup(result, k) : "");
        html += (pictures.empty() ? "" : "<div class=\"row\">" + pictures + "</div>\n") + "</article>\n";
    }
    return html + "</section>\n";
}

}  // namespace abut::report
