// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include "src/io/escape_xml.hpp"
#include "src/report/report_sections.hpp"
#include "src/results/result_units.hpp"

namespace abut::report {

namespace {

constexpr std::size_t most_pictured = 8;  ///< beyond it paper and page would grow too large; tables and csv files have all

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

std::vector<bool> strongest_contacts(const Result& result, std::size_t n) {
    std::vector<std::size_t> order(result.contacts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return result.contacts[a].max_pressure.value > result.contacts[b].max_pressure.value;
    });
    std::vector<bool> strongest(order.size(), false);
    for (std::size_t i = 0; i < std::min(order.size(), n); ++i) strongest[order[i]] = true;
    return strongest;
}

std::vector<bool> pictured_contacts(const Result& result) {
    return strongest_contacts(result, most_pictured);
}

std::string contacts_section(const Result& result) {
    if (result.contacts.empty()) return "";
    const ResultUnits units = result_units(result);
    const std::vector<bool> pictured = pictured_contacts(result);
    std::string html = "<section><h2>Contacts</h2>\n";
    for (std::size_t k = 0; k < result.contacts.size(); ++k) {
        const ContactResult& c = result.contacts[k];
        html += (pictured[k] ? "<article>" : "<article class=\"weak\">") + title(c, k) + sentence(c, units, model_size(result));
        const std::string pictures = pictured[k] ? contact_curves(result, k) + contact_closeup(result, k) : "";
        html += (pictures.empty() ? "" : "<div class=\"row\">" + pictures + "</div>\n") + "</article>\n";
    }
    return html + "</section>\n";
}

}  // namespace abut::report
