// SPDX-License-Identifier: GPL-3.0-or-later
// What was analysed: file, units, materials, loads, supports.
#include <algorithm>

#include "src/io/build_id.hpp"
#include "src/io/escape_xml.hpp"
#include "src/io/number_text.hpp"
#include "src/report/report_sections.hpp"
#include "src/report/report_table.hpp"
#include "src/results/result_units.hpp"

namespace abut::report {

namespace {

using FactRows = std::vector<std::vector<std::string>>;

std::string fact_or_dash(const std::optional<double>& value) {
    return value ? fact_number(*value) : "–";
}

std::string files_text(const ModelFacts& model) {
    std::vector<std::string> files;
    for (const HashedFile& f : model.files) files.push_back(f.file + " (" + f.hash + ")");
    return joined(files, ", ");
}

std::string units_text(const ResultUnits& u) {
    if (u.length.empty() && u.force.empty()) return "not named";
    return joined({u.length.empty() ? "no length" : u.length, u.force.empty() ? "no force" : u.force}, ", ") +
           (u.stress.empty() ? "" : ", " + u.stress);
}

std::string accuracy_text(const Result& result) {
    const auto& a = result.accuracy;
    if (!a.estimate) return "";
    return percent_text(a.target) + " of the " + a.of + " asked for, " +
           percent_beside(*a.estimate, a.reached ? *a.estimate : a.target) + " reached";
}

FactRows general_rows(const Result& result, const ModelFacts& model) {
    FactRows rows;
    const auto add = [&](const std::string& what, const std::string& text) {
        if (!text.empty()) rows.push_back({what, text});
    };
    add("File", files_text(model));
    add("Run", model.begun);
    add("Program", "abut " + program_build());
    add("Units", units_text(result_units(result)));
    add("Analysis", analysis_words(model));
    add("Accuracy", accuracy_text(result));
    return rows;
}

std::string materials_table(const ModelFacts& model, const ResultUnits& u) {
    FactRows rows;
    for (const MaterialFacts& m : model.materials)
        rows.push_back({m.name, m.rigid ? "rigid" : fact_number(m.E), m.rigid ? "" : fact_number(m.nu), fact_or_dash(m.yield),
                        fact_or_dash(m.density), fact_or_dash(m.expansion)});
    return html_table({{"material"},
                       {heading("E", u.stress), true},
                       {"ν", true},
                       {heading("yield", u.stress), true},
                       {"density", true},
                       {"expansion", true}},
                      rows);
}

std::string made_of_table(const ModelFacts& model, const ResultUnits& u) {
    const bool is_plane = model.analysis != "axisymmetric";
    const auto thickness = [&](const PartFacts& p) {
        return !is_plane ? "full circle" : p.default_thickness ? "1 (none was given)" : fact_number(p.thickness);
    };
    // parts alike share a row
    FactRows rows;
    for (const PartFacts& p : model.parts) {
        const auto alike = std::find_if(rows.begin(), rows.end(),
                                        [&](const auto& row) { return row[1] == p.material && row[2] == thickness(p); });
        if (alike == rows.end())
            rows.push_back({p.name, p.material, thickness(p)});
        else
            (*alike)[0] += ", " + p.name;
    }
    return html_table({{"parts"}, {"material"}, {heading("thickness", is_plane ? u.length : ""), true}}, rows);
}

std::string conditions_table(const ModelFacts& model) {
    FactRows rows;
    for (const LoadFacts& l : model.loads)
        rows.push_back(
            {(l.name.empty() ? "" : l.name + ": ") + load_words(l), l.on.empty() ? "all parts" : joined(l.on, ", ")});
    for (const SupportFacts& s : model.supports) rows.push_back({s.label, joined(s.on, ", ")});
    return rows.empty() ? "" : html_table({{"load or support"}, {"on"}}, rows);
}

}  // namespace

std::string model_section(const Result& result, const ModelFacts& model) {
    if (model.analysis.empty()) return "";
    const ResultUnits units = result_units(result);
    return "<section class=\"model\"><h2>Model</h2>\n<div class=\"row\">" +
           html_table({{""}, {""}}, general_rows(result, model)) + materials_table(model, units) + made_of_table(model, units) +
           conditions_table(model) + "</div></section>\n";
}

}  // namespace abut::report
