// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/page_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "src/report/packed_field.hpp"
#include "src/report/svg.hpp"
#include "src/results/result_units.hpp"

namespace abut::report {

namespace {

using PageJson = nlohmann::ordered_json;

PageJson exact(double value) {
    return std::isfinite(value) ? PageJson(value) : PageJson(nullptr);
}
PageJson exact(const std::optional<double>& value) {
    return value ? exact(*value) : PageJson(nullptr);
}
PageJson exact(const Vec2& v) {
    return PageJson::array({exact(v.x()), exact(v.y())});
}
PageJson exact(const ValueAt& v) {
    return {{"value", exact(v.value)}, {"at", exact(v.at)}};
}

/// To seven digits, which is more than any picture shows.
double rounded(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.7g", value);
    return std::strtod(text.data(), nullptr);
}
PageJson rounded_list(const std::vector<double>& values) {
    PageJson list = PageJson::array();
    for (double value : values) list.push_back(exact(rounded(value)));
    return list;
}

PageJson field_json(const PackedField& field) {
    return {
        {"origin", exact(field.origin)}, {"step", field.step},       {"scale", field.scale}, {"samples", field.samples},
        {"inside", field.n_inside},      {"patches", field.patches}, {"loops", field.loops}, {"loop_sizes", field.loop_sizes}};
}

/// Between which lines a value lies, and in which of so many equal pieces there.
std::array<std::ptrdiff_t, 2> piece_of(const std::vector<double>& lines, double value, int pieces) {
    const auto next = std::clamp(std::upper_bound(lines.begin(), lines.end(), value), lines.begin() + 1, lines.end() - 1);
    const double low = *(next - 1);
    return {next - 1 - lines.begin(), static_cast<std::ptrdiff_t>((value - low) / (*next - low) * pieces)};
}

/// The last cells that were halved: the grid's cell that each lies in, its column and row among the cells of its size there,
/// and how often halving has gone.
PageJson halved_json(const PartResult& p) {
    PageJson list = PageJson::array();
    for (const PartResult::Halved& h : p.halved) {
        const Vec2 middle = 0.5 * (h.low + h.high);
        const auto [column, x] = piece_of(p.grid_x, middle.x(), 1 << (h.levels - 1));
        const auto [row, y] = piece_of(p.grid_y, middle.y(), 1 << (h.levels - 1));
        list.push_back({row * static_cast<std::ptrdiff_t>(p.grid_x.size() - 1) + column, x, y, h.levels});
    }
    return list;
}

PageJson part_json(const Result& result, std::size_t i) {
    const PartResult& p = result.parts[i];
    const PartField none;
    PageJson j{{"name", p.name},
               {"material", p.material},
               {"color", part_color(static_cast<int>(i))},
               {"solved", p.solved},
               {"rigid", p.rigid},
               {"unknowns", p.unknowns},
               {"max_displacement", exact(p.max_displacement)},
               {"max_von_mises", exact(p.max_von_mises)},
               {"max_von_mises_error", exact(p.max_von_mises_error)},
               {"at_corner", p.max_von_mises_at_corner},
               {"utilisation", exact(p.utilisation)},
               {"grid", {{"angle", exact(p.grid_angle)}, {"x", p.grid_x}, {"y", p.grid_y}, {"halved", halved_json(p)}}}};
    j["field"] = field_json(packed_field(i < result.fields.size() ? result.fields[i] : none, result.geometry[i]));
    return j;
}

PageJson profile_json(const ContactProfile& p) {
    PageJson edges = PageJson::array(), edge = PageJson::array();
    for (const std::string& name : p.edge) {  // a few names, many points
        if (edges.empty() || edges.back() != name) edges.push_back(name);
        edge.push_back(edges.size() - 1);
    }
    PageJson j{{"edges", edges},
               {"edge", edge},
               {"s", rounded_list(p.s)},
               {"x", rounded_list(p.x)},
               {"y", rounded_list(p.y)},
               {"pressure", rounded_list(p.pressure)},
               {"gap", rounded_list(p.gap)}};
    if (!p.shear.empty()) j["shear"] = rounded_list(p.shear);
    if (!p.slip.empty()) {
        j["slip"] = rounded_list(p.slip);
        j["state"] = p.state;
    }
    return j;
}

PageJson contact_json(const ContactResult& c) {
    PageJson ends = PageJson::array();
    for (const Vec2& end : c.ends) ends.push_back(exact(end));
    PageJson j{{"parts", c.part},
               {"between", c.between},
               {"kind", c.kind},
               {"interface", c.interface},
               {"status", c.status},
               {"force", exact(c.force)},
               {"moment", exact(c.moment)},
               {"length", exact(c.contact_length)},
               {"ends", ends},
               {"max_pressure", exact(c.max_pressure)},
               {"at_corner", c.errors && c.errors->at_corner},
               {"profile", profile_json(c.profile)}};
    if (c.friction) {
        j["shear_force"] = exact(c.friction->shear_force);
        j["dissipated"] = exact(c.friction->dissipated);
    }
    j["error"] = c.errors ? exact(std::max(c.errors->pressure, c.errors->peak)) : PageJson(nullptr);
    return j;
}

PageJson reaction_json(const Reaction& r) {
    return {{"support", r.support}, {"label", r.label}, {"force", exact(r.force)}, {"moment", exact(r.moment)}};
}

PageJson marks_json(const Result& result) {
    PageJson supports = PageJson::array(), loads = PageJson::array();
    for (const SupportMark& m : result.support_marks)
        supports.push_back({{"at", exact(m.at)}, {"normal", exact(m.normal)}, {"x", m.x}, {"y", m.y}});
    for (const LoadMark& m : result.load_marks) loads.push_back({{"at", exact(m.at)}, {"direction", exact(m.direction)}});
    return {{"supports", supports}, {"loads", loads}};
}

PageJson model_facts_json(const ModelFacts& model) {
    PageJson j = PageJson::parse(model_json(model));
    const auto points = [](const std::vector<Vec2>& list) {
        PageJson all = PageJson::array();
        for (const Vec2& p : list) all.push_back(exact(p));
        return all;
    };
    for (std::size_t i = 0; i < model.loads.size(); ++i) {
        j["loads"][i]["text"] = load_words(model.loads[i]);
        j["loads"][i]["at"] = points(model.loads[i].at);
    }
    for (std::size_t i = 0; i < model.supports.size(); ++i) j["supports"][i]["at"] = points(model.supports[i].at);
    return j;
}

/// As it may stand in a script element of a page that is XML, too: names may hold what ends a script.
std::string script_text(const PageJson& j) {
    std::string text;
    for (const char c : j.dump(-1, ' ', false, PageJson::error_handler_t::replace)) {
        if (c == '<')
            text += "\\u003c";
        else if (c == '&')
            text += "\\u0026";
        else
            text += c;
    }
    return text;
}

}  // namespace

std::string tabs_data(const std::vector<CaseTab>& cases, bool in_steps) {
    std::string text;
    for (const CaseTab& c : cases) {
        std::string head =
            script_text({{"name", c.name}, {"loads", c.loads}, {"verdict", c.verdict}, {"sentence", c.sentence}});
        head.pop_back();
        text += (text.empty() ? "" : ",") + head + ",\"data\":" + c.data + "}";
    }
    return "{\"steps\":" + std::string(in_steps ? "true" : "false") + ",\"cases\":[" + text + "]}";
}

std::string fields_data(const std::vector<geometry::Part>& parts, const std::vector<PartField>& fields) {
    const PartField none;
    PageJson j = PageJson::array();
    for (std::size_t i = 0; i < parts.size(); ++i)
        j.push_back(field_json(packed_field(i < fields.size() ? fields[i] : none, parts[i])));
    return script_text(j);
}

std::string page_data(const Result& result, const ModelFacts& model) {
    const ResultUnits u = result_units(result);
    PageJson j{{"title", result.title},
               {"units", {{"length", u.length}, {"force", u.force}, {"stress", u.stress}, {"moment", u.moment}}},
               {"model", model_facts_json(model)},
               {"parts", PageJson::array()},
               {"contacts", PageJson::array()},
               {"reactions", PageJson::array()},
               {"marks", marks_json(result)}};
    for (std::size_t i = 0; i < result.parts.size() && i < result.geometry.size(); ++i)
        j["parts"].push_back(part_json(result, i));
    for (const ContactResult& c : result.contacts) j["contacts"].push_back(contact_json(c));
    for (const Reaction& r : result.reactions) j["reactions"].push_back(reaction_json(r));
    return script_text(j);
}

}  // namespace abut::report
