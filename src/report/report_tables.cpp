// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/io/escape_xml.hpp"
#include "src/io/number_text.hpp"
#include "src/report/report_sections.hpp"
#include "src/report/report_table.hpp"
#include "src/results/result_units.hpp"
#include "src/scene/part_levels.hpp"

namespace abut::report {

namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string count_text(int n) {
    return std::to_string(n);
}
std::string percent_or_dash(const std::optional<double>& fraction) {
    return fraction ? percent_text(*fraction) : "–";
}
std::string subsection(const std::string& title, const std::string& html) {
    return "<h3>" + title + "</h3>\n" + html;
}

std::string ends_text(const std::vector<Vec2>& ends, double size) {
    std::vector<std::string> words;
    for (const Vec2& end : ends) words.push_back(place_text(end, size));
    return words.empty() ? "–" : joined(words, "  ");
}

std::string peak_error(const ContactResult& c) {
    if (!c.errors) return "–";
    return c.errors->at_corner ? "no limit" : percent_or_dash(std::max(c.errors->pressure, c.errors->peak));
}

std::string contact_table(const Result& result, const ResultUnits& u) {
    if (result.contacts.empty()) return subsection("Contacts", "<p>No parts touch.</p>\n");
    const double size = model_size(result);
    Rows forces, shapes;
    for (std::size_t k = 0; k < result.contacts.size(); ++k) {
        const ContactResult& c = result.contacts[k];
        const std::string number = contact_number(k);
        forces.push_back({number, c.between[0], c.between[1], c.interface,
                          c.kind == "contact" ? c.status : c.kind + ", " + c.status, pair_text(c.force, 5),
                          number_text(rounded_off(c.moment, c.force.norm() * model_size(result)), 5),
                          number_text(c.max_pressure.value, 5), peak_error(c), place_text(c.max_pressure.at, size),
                          percent_or_dash(c.error_estimate)});
        shapes.push_back({number, joined(c.edges[0], ", "), joined(c.edges[1], ", "), number_text(c.contact_length, 5),
                          ends_text(c.ends, size), number_text(c.gap_min, 4) + " to " + number_text(c.gap_max, 4),
                          number_text(c.max_penetration, 3)});
    }
    return subsection("Contacts", html_table({{"", true},
                                              {"first"},
                                              {"second"},
                                              {"interface"},
                                              {"status"},
                                              {heading("force on first", u.force), true},
                                              {heading("moment", u.moment), true},
                                              {heading("max pressure", u.stress), true},
                                              {"est. error", true},
                                              {heading("at", u.length), true},
                                              {"est. error of pressures", true}},
                                             forces) +
                                      html_table({{"", true},
                                                  {"edges of the first"},
                                                  {"edges of the second"},
                                                  {heading("contact length", u.length), true},
                                                  {heading("ends", u.length), true},
                                                  {heading("initial gap", u.length), true},
                                                  {heading("max penetration", u.length), true}},
                                                 shapes));
}

std::string friction_table(const Result& result, const ResultUnits& u) {
    Rows rows;
    for (std::size_t k = 0; k < result.contacts.size(); ++k) {
        const std::optional<FrictionResult>& f = result.contacts[k].friction;
        if (!f) continue;
        const double forces = f->normal_force, works = forces * model_size(result);
        rows.push_back({contact_number(k), std::isinf(f->coefficient) ? "rough" : number_text(f->coefficient, 4),
                        number_text(rounded_off(f->shear_force, forces), 5), number_text(forces, 5),
                        percent_or_dash(f->utilisation), number_text(f->stick_length, 4),
                        f->stick_length_error ? number_text(*f->stick_length_error, 2) : "–", number_text(f->slip_length, 4),
                        number_text(rounded_off(f->dissipated, works), 4),
                        number_text(rounded_off(f->dissipated_error, works), 2)});
    }
    if (rows.empty()) return "";
    return subsection("Friction", html_table({{"contact", true},
                                              {"coefficient", true},
                                              {heading("shear force", u.force), true},
                                              {heading("normal force", u.force), true},
                                              {"of what friction bears", true},
                                              {heading("sticks along", u.length), true},
                                              {"±", true},
                                              {heading("slips along", u.length), true},
                                              {heading("work against slip", u.energy), true},
                                              {"± by the increments", true}},
                                             rows));
}

std::string reaction_table(const Result& result, const ResultUnits& u) {
    if (result.reactions.empty()) return "";
    double force = 0, moment = 0;
    for (const Reaction& r : result.reactions) {
        force = std::max(force, r.force.norm());
        moment = std::max({moment, std::abs(r.moment), r.force.norm() * model_size(result)});
    }
    Rows rows;
    for (const Reaction& r : result.reactions)
        rows.push_back({count_text(r.support + 1), r.label, r.method, r.why,
                        pair_text({rounded_off(r.force.x(), force), rounded_off(r.force.y(), force)}, 5),
                        number_text(rounded_off(r.moment, moment), 5)});
    return subsection("Reactions", html_table({{"support", true},
                                               {""},
                                               {"method"},
                                               {"why"},
                                               {heading("force on the model", u.force), true},
                                               {heading("moment about the origin", u.moment), true}},
                                              rows));
}

std::string preload_table(const Result& result, const ResultUnits& u) {
    if (result.preloads.empty()) return "";
    Rows rows;
    for (const PreloadResult& p : result.preloads)
        rows.push_back({p.part, number_text(p.force, 5), number_text(p.shortening, 5), number_text(p.force_under_load, 5)});
    return subsection("Tightened parts", html_table({{"part"},
                                                     {heading("tightened to", u.force), true},
                                                     {heading("shortened by", u.length), true},
                                                     {heading("force across the cut under load", u.force), true}},
                                                    rows));
}

std::string equilibrium_table(const Result& result, const ResultUnits& u) {
    const auto& e = result.equilibrium;
    const Rows rows{{pair_text(e.applied, 5), pair_text(e.reaction, 5), number_text(e.relative_residual, 2),
                     number_text(e.relative_moment_residual, 2), number_text(result.strain_energy, 5)}};
    return subsection("Equilibrium", html_table({{heading("applied", u.force), true},
                                                 {heading("reaction", u.force), true},
                                                 {"relative residual", true},
                                                 {"of moments", true},
                                                 {heading("strain energy", u.energy), true}},
                                                rows));
}

std::string part_table(const Result& result, const ResultUnits& u) {
    if (result.parts.empty()) return "";
    const double size = model_size(result);
    Rows rows;
    for (const PartResult& p : result.parts) {
        // A failed analysis has not found a zero: it has found nothing.
        const auto known = [&](const ValueAt& v) { return p.solved && (result.status == "ok" || v.value != 0); };
        const auto value = [&](const ValueAt& v) { return known(v) ? number_text(v.value, 5) : "–"; };
        const auto at = [&](const ValueAt& v) { return known(v) ? place_text(v.at, size) : "–"; };
        rows.push_back({p.name + (p.level.empty() ? "" : ", level " + levels_text(p.level)), p.material, number_text(p.area, 6),
                        p.rigid    ? "rigid"
                        : p.solved ? count_text(p.unknowns)
                                   : "not analysed: no load reaches it",
                        value(p.max_displacement), at(p.max_displacement),
                        known(p.max_von_mises) ? largest_stress_text(p, 5, "") : "–", at(p.max_von_mises),
                        p.utilisation ? percent_beside(*p.utilisation, 1) : "–"});
    }
    return subsection("Parts", html_table({{"part"},
                                           {"material"},
                                           {heading("area", u.area), true},
                                           {"unknowns", true},
                                           {heading("max displacement", u.length), true},
                                           {heading("at", u.length), true},
                                           {heading("max von Mises", u.stress), true},
                                           {heading("at", u.length), true},
                                           {"of the yield", true}},
                                          rows));
}

std::string probe_table(const Result& result, const ResultUnits& u) {
    if (result.probes.empty()) return "";
    Rows rows;
    for (const ProbeResult& p : result.probes) {
        std::vector<std::string> row{p.part, place_text(p.at, model_size(result)), number_text(p.displacement.x(), 5),
                                     number_text(p.displacement.y(), 5)};
        for (double s : {p.stress.xx, p.stress.yy, p.stress.xy, p.stress.zz, von_mises(p.stress)})
            row.push_back(number_text(s, 5));
        rows.push_back(std::move(row));
    }
    return subsection("Probes", html_table({{"part"},
                                            {heading("at", u.length), true},
                                            {heading("u", u.length), true},
                                            {heading("v", u.length), true},
                                            {heading("σxx", u.stress), true},
                                            {heading("σyy", u.stress), true},
                                            {heading("σxy", u.stress), true},
                                            {heading("σzz", u.stress), true},
                                            {heading("von Mises", u.stress), true}},
                                           rows));
}

std::string smallest_step(const std::vector<double>& knots) {
    double step = 0;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i)
        if (const double d = knots[i + 1] - knots[i]; d > 0 && (step == 0 || d < step)) step = d;
    return step > 0 ? number_text(step, 3) : "–";
}

/// Columns and rows, and how often cells are halved.
std::string grid_text(const PartResult& p) {
    std::string text = std::to_string(p.grid_x.size() - 1) + " × " + std::to_string(p.grid_y.size() - 1);
    int levels = 0;
    for (const PartResult::Halved& h : p.halved) levels = std::max(levels, h.levels);
    return levels > 0 ? text + ", halved up to " + counted(static_cast<std::size_t>(levels), "time") : text;
}

std::string grid_table(const Result& result, const ResultUnits& u) {
    Rows rows;
    for (const PartResult& p : result.parts) {
        if (!p.solved || p.grid_x.size() < 2 || p.grid_y.size() < 2) continue;
        rows.push_back({p.name, grid_text(p), smallest_step(p.grid_x) + " × " + smallest_step(p.grid_y),
                        number_text(p.grid_angle * 180 / std::numbers::pi, 4), count_text(p.cells_inner),
                        count_text(p.cells_boundary), count_text(p.cells_outer), count_text(p.unknowns)});
    }
    const auto& s = result.solver;
    std::string words = "Degree " + std::to_string(result.degree) + ", " + std::to_string(result.unknowns) + " unknowns, " +
                        std::to_string(result.multipliers) + " contact multipliers; " +
                        counted(static_cast<std::size_t>(std::max(s.grids, 0)), "grid") + ", " +
                        counted(static_cast<std::size_t>(std::max(s.factorizations, 0)), "factorization") + ", " +
                        counted(static_cast<std::size_t>(std::max(s.contact_iterations, 0)), "contact iteration");
    if (s.condition_estimate > 0) words += "; condition number about " + number_text(s.condition_estimate, 2);
    words += s.converged ? "." : "; not converged.";
    std::string html = "<p>" + escape_xml(words) + "</p>\n";
    if (!rows.empty())
        html += html_table({{"part"},
                            {"cells", true},
                            {heading("smallest", u.length), true},
                            {"angle [°]", true},
                            {"inner", true},
                            {"boundary", true},
                            {"outer", true},
                            {"unknowns", true}},
                           rows);
    return subsection("Grids", html);
}

/// Least filled cell, functions that were mended, and what the quadrature makes of the part.
std::string quality_table(const Result& result) {
    Rows rows;
    for (const PartResult& p : result.parts) {
        if (!p.solved) continue;
        const CutQuality& q = p.quality;
        rows.push_back({p.name, number_text(q.smallest_fraction, 3), count_text(q.split_cells), count_text(q.extended),
                        count_text(q.taken_apart), number_text(q.self_check.area, 2), number_text(q.self_check.centroid, 2),
                        number_text(q.self_check.divergence, 2)});
    }
    if (rows.empty()) return "";
    return subsection("Cut cells and self check", html_table({{"part"},
                                                              {"smallest filled fraction", true},
                                                              {"pieces beyond one a cell", true},
                                                              {"functions extended", true},
                                                              {"taken apart", true},
                                                              {"error of area", true},
                                                              {"of centroid", true},
                                                              {"of divergence", true}},
                                                             rows));
}

/// Pairs of an effect, or else its parts.
std::string concerned(const Effect& e) {
    std::string text;
    const auto append = [&](const std::string& name) { text += (text.empty() ? "" : ", ") + name; };
    for (const auto& pair : e.pairs) append(pair[0] + " - " + pair[1]);
    if (e.pairs.empty())
        for (const std::string& part : e.parts) append(part);
    return text;
}

std::string effect_table(const Result& result) {
    if (result.effects.empty()) return "";
    Rows rows;
    for (const Effect& e : result.effects)
        rows.push_back({e.on ? "on" : "off", e.name, e.why, concerned(e), seconds_text(e.seconds),
                        e.on ? number_text(100 * e.share, 2) + " %" : "", std::to_string(e.items)});
    return subsection("Plan of effects", html_table({{""},
                                                     {"effect"},
                                                     {"why"},
                                                     {"parts or pairs"},
                                                     {"time", true},
                                                     {"of the run", true},
                                                     {"points, rows, unknowns", true}},
                                                    rows));
}

std::string timing_bars(const Result& result) {
    double longest = 0;
    for (const auto& [stage, seconds] : result.timing)
        if (stage != "total") longest = std::max(longest, seconds);
    if (!(longest > 0)) return "";
    std::string html = "<table class=\"times\"><tbody>\n";
    for (const auto& [stage, seconds] : result.timing) {
        const std::string bar =
            stage == "total" ? ""
                             : "<span class=\"bar\" style=\"width:" + coordinate_text(100 * seconds / longest) + "%\"></span>";
        const std::string time = seconds > 0 ? seconds_text(seconds) : "0 s";
        html +=
            "<tr><td>" + escape_xml(stage) + "</td><td class=\"n\">" + time + "</td><td class=\"bars\">" + bar + "</td></tr>\n";
    }
    return subsection("Time", html + "</tbody></table>\n");
}

}  // namespace

std::string tables_section(const Result& result) {
    const ResultUnits units = result_units(result);
    const bool solved = result.status == "ok";
    std::string html = "<section class=\"tables\"><h2>Tables</h2>\n";
    if (solved || !result.contacts.empty()) html += contact_table(result, units);
    html += friction_table(result, units);
    html += reaction_table(result, units);
    html += preload_table(result, units);
    if (solved) html += equilibrium_table(result, units);
    html += mobility_table(result);
    html += part_table(result, units) + probe_table(result, units);
    std::string developers;
    if (result.unknowns > 0) {
        html += accuracy_table(result);
        developers = grid_table(result, units) + quality_table(result);
    }
    developers += effect_table(result) + timing_bars(result);
    return html +
           (developers.empty() ? ""
                               : "<details><summary>For developers: grids, self checks, effects, time</summary>\n" +
                                     developers + "</details>\n") +
           "</section>\n";
}

}  // namespace abut::report
