// SPDX-License-Identifier: GPL-3.0-or-later
// result.json, which data/schema/result.schema.json describes.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "src/io/build_id.hpp"
#include "src/results/displacement_from_drawn.hpp"
#include "src/results/functional_json.hpp"
#include "src/results/model_facts.hpp"
#include "src/results/result.hpp"
#include "src/results/verdict.hpp"

namespace abut {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
    if (!std::isfinite(value)) return nullptr;  // JSON has no other word for it
    return value == 0 ? 0.0 : value;            // no "-0.0"
}
Json number(const std::optional<double>& value) {
    return value ? number(*value) : Json(nullptr);
}
Json numbers(const std::vector<double>& values) {
    Json list = Json::array();
    for (double value : values) list.push_back(number(value));
    return list;
}
Json vector(const Vec2& v) {
    return Json::array({number(v.x()), number(v.y())});
}
Json value_at(const ValueAt& v) {
    return {{"value", number(v.value)}, {"at", vector(v.at)}};
}
Json names(const std::vector<std::string>& list) {
    return list.empty() ? Json::array() : Json(list);
}
template <class T, class ToJson>
Json list_of(const std::vector<T>& items, ToJson to_json) {
    Json list = Json::array();
    for (const T& item : items) list.push_back(to_json(item));
    return list;
}

Json effect(const Effect& e) {
    return {{"name", e.name},
            {"on", e.on},
            {"why", e.why},
            {"parts", names(e.parts)},
            {"pairs", list_of(e.pairs, [](const auto& pair) { return Json(pair); })},
            {"seconds", number(e.seconds)},
            {"share", number(e.share)},
            {"items", e.items}};
}

Json cells_of(const PartResult& p) {
    if (!p.solved || p.rigid) return nullptr;
    return {{"inner", p.cells_inner},
            {"boundary", p.cells_boundary},
            {"outer", p.cells_outer},
            {"smallest_fraction", number(p.quality.smallest_fraction)},
            {"split", p.quality.split_cells},
            {"functions_extended", p.quality.extended},
            {"functions_taken_apart", p.quality.taken_apart}};
}

Json self_check_of(const PartResult& p) {
    if (!p.solved || p.rigid) return nullptr;
    const auto& c = p.quality.self_check;
    return {{"area", number(c.area)}, {"centroid", number(c.centroid)},         {"divergence", number(c.divergence)},
            {"points", c.points},     {"negative_weights", c.negative_weights}, {"outside_cell", c.outside_cell}};
}

Json largest_stress(const PartResult& p) {
    Json j = value_at(p.max_von_mises);
    j["error"] = number(p.max_von_mises_error);
    j["at_corner"] = p.max_von_mises_at_corner;
    return j;
}

Json largest_displacement(const PartResult& p) {
    Json j = value_at(p.max_displacement);
    j["error"] = number(p.max_displacement_error);
    return j;
}

Json part(const Result& r, std::size_t i) {
    const PartResult& p = r.parts[i];
    Json j{{"name", p.name},
           {"area", number(p.area)},
           {"unknowns", p.unknowns},
           {"solved", p.solved},
           {"rigid", p.rigid},
           {"max_displacement", largest_displacement(p)},
           {"max_von_mises", largest_stress(p)},
           {"utilisation", number(p.utilisation)},
           {"cells", cells_of(p)},
           {"self_check", self_check_of(p)}};
    if (!p.level.empty()) j["level"] = p.level;
    if (p.placement)
        j["placement"] = {{"translation", vector(p.placement->translation)},
                          {"rotation", number(p.placement->rotation * 180 / std::numbers::pi)},
                          {"max_displacement", value_at(displacement_from_drawn(r, i))}};
    return j;
}

Json preload(const PreloadResult& p) {
    return {{"part", p.part},
            {"across", Json::array({vector(p.across[0]), vector(p.across[1])})},
            {"force", number(p.force)},
            {"shortening", number(p.shortening)},
            {"force_under_load", number(p.force_under_load)}};
}

Json profile(const ContactProfile& p) {
    Json json = {{"edge", names(p.edge)},           {"s", numbers(p.s)},    {"x", numbers(p.x)}, {"y", numbers(p.y)},
                 {"pressure", numbers(p.pressure)}, {"gap", numbers(p.gap)}};
    if (!p.shear.empty()) json["shear"] = numbers(p.shear);
    if (!p.slip.empty()) json["slip"] = numbers(p.slip);
    if (!p.state.empty()) json["state"] = names(p.state);
    return json;
}

Json errors(const std::optional<ContactErrors>& e) {
    if (!e) return nullptr;
    return {{"pressure", number(e->pressure)},
            {"peak", number(e->peak)},
            {"force", number(e->force)},
            {"length", number(e->length)},
            {"at_corner", e->at_corner}};
}

Json friction(const FrictionResult& f) {
    return {{"coefficient", std::isinf(f.coefficient) ? Json("rough") : number(f.coefficient)},
            {"shear_force", number(f.shear_force)},
            {"normal_force", number(f.normal_force)},
            {"utilisation", number(f.utilisation)},
            {"stick_length", number(f.stick_length)},
            {"stick_length_error", number(f.stick_length_error)},
            {"slip_length", number(f.slip_length)},
            {"dissipated", number(f.dissipated)},
            {"dissipated_error", number(f.dissipated_error)}};
}

Json contact(const ContactResult& c) {
    Json j{{"parts", Json::array({c.parts[0], c.parts[1]})},
           {"between", Json::array({c.between[0], c.between[1]})},
           {"edges", Json::array({names(c.edges[0]), names(c.edges[1])})},
           {"kind", c.kind},
           {"interface", c.interface},
           {"functional_interface", c.functional ? Json::parse(functional_json(*c.functional)) : Json(nullptr)},
           {"status", c.status},
           {"initial_gap", {{"min", number(c.gap_min)}, {"max", number(c.gap_max)}}},
           {"force", vector(c.force)},
           {"moment", number(c.moment)},
           {"contact_length", number(c.contact_length)},
           {"ends", list_of(c.ends, vector)},
           {"max_pressure", value_at(c.max_pressure)},
           {"max_penetration", number(c.max_penetration)},
           {"error_estimate", number(c.error_estimate)},
           {"errors", errors(c.errors)},
           {"profile", profile(c.profile)}};
    if (c.friction) j["friction"] = friction(*c.friction);
    return j;
}

Json accuracy(const Result& r) {
    Json j = {
        {"target", number(r.accuracy.target)}, {"estimate", number(r.accuracy.estimate)}, {"reached", r.accuracy.reached}};
    if (!r.accuracy.why.empty()) j["why"] = r.accuracy.why;
    j["passes"] = list_of(r.passes, [](const PassSummary& p) {
        return Json{{"unknowns", p.unknowns}, {"multipliers", p.multipliers}, {"estimated_error", number(p.estimated_error)}};
    });
    return j;
}

Json reaction(const Reaction& r) {
    Json j = {
        {"support", r.support}, {"force", vector(r.force)}, {"moment", number(r.moment)}, {"method", r.method}, {"why", r.why}};
    if (r.force_from_stress) j["force_from_stress"] = vector(*r.force_from_stress);
    if (r.energy) j["energy"] = number(*r.energy);
    return j;
}

Json stress(const Stress& s) {
    return {{"xx", number(s.xx)}, {"yy", number(s.yy)}, {"xy", number(s.xy)}, {"zz", number(s.zz)}};
}

Json probe(const ProbeResult& p) {
    return {{"part", p.part}, {"at", vector(p.at)}, {"displacement", vector(p.displacement)}, {"stress", stress(p.stress)}};
}

Json solver(const Result& r) {
    Json j{{"grids", r.solver.grids},
           {"factorizations", r.solver.factorizations},
           {"contact_iterations", r.solver.contact_iterations},
           {"condition_estimate", number(r.solver.condition_estimate)},
           {"converged", r.solver.converged},
           {"groups", r.solver.groups},
           {"contact_problems", r.solver.contact_problems}};
    if (r.solver.increments) j["increments"] = *r.solver.increments;
    if (r.solver.contact_residual) j["contact_residual"] = number(*r.solver.contact_residual);
    if (r.solver.assembled_condition) j["assembled_condition"] = number(*r.solver.assembled_condition);
    return j;
}

Json timing(const Result& r, const ModelFacts& model) {
    Json times = Json::object();
    if (!model.begun.empty()) times["begun"] = model.begun;
    for (const auto& [stage, seconds] : r.timing) times[stage] = number(seconds);
    if (!r.passes.empty()) times["passes"] = list_of(r.passes, [](const PassSummary& p) { return number(p.seconds); });
    if (r.next_level) times["next_level"] = {{"accuracy", r.next_level->accuracy}, {"seconds", number(r.next_level->seconds)}};
    return times;
}

Json equilibrium(const Result& r) {
    const auto& e = r.equilibrium;
    return {{"applied", vector(e.applied)},
            {"reaction", vector(e.reaction)},
            {"relative_residual", number(e.relative_residual)},
            {"relative_moment_residual", number(e.relative_moment_residual)}};
}

/// An analysis that failed before it had an answer must not claim zeros for it: the answers that were not reached are null.
void hide_what_was_not_reached(Json& j, const Result& r) {
    const auto& e = r.equilibrium;
    if (r.strain_energy == 0) j["strain_energy"] = nullptr;
    if (e.applied.isZero(0) && e.reaction.isZero(0)) j["equilibrium"] = nullptr;
    for (std::size_t i = 0; i < r.parts.size(); ++i) {
        if (r.parts[i].max_displacement.value == 0) j["parts"][i]["max_displacement"] = nullptr;
        if (r.parts[i].max_von_mises.value == 0) j["parts"][i]["max_von_mises"] = nullptr;
    }
    if (r.solver.condition_estimate == 0) j["solver"]["condition_estimate"] = nullptr;
}

Json to_json(const Result& r, const ModelFacts& model) {
    const bool failed = r.status != "ok";
    Json j = {{"abut", 1}, {"title", r.title}, {"status", r.status}};
    if (failed) j["message"] = r.message;
    j["build"] = program_build();
    j["verdict"] = verdict_word(verdict_of(r));
    j["reasons"] = list_of(r.reasons, [](const Reason& reason) { return Json{{"kind", reason.kind}, {"text", reason.text}}; });
    if (!model.analysis.empty()) j["model"] = Json::parse(model_json(model));
    j["unknowns"] = r.unknowns;
    j["degree"] = r.degree;
    j["multipliers"] = r.multipliers;
    j["cells"] = {{"inner", r.cells[0]}, {"boundary", r.cells[1]}, {"outer", r.cells[2]}};
    j["solver"] = solver(r);
    j["timing"] = timing(r, model);
    j["effects"] = list_of(r.effects, effect);
    j["strain_energy"] = number(r.strain_energy);
    j["equilibrium"] = equilibrium(r);
    j["error_estimate"] = {{"energy", number(r.error_estimate.energy)},
                           {"contact_pressure", number(r.error_estimate.contact_pressure)},
                           {"stress", number(r.error_estimate.stress)},
                           {"method", r.error_estimate.method}};
    j["accuracy"] = accuracy(r);
    j["parts"] = Json::array();
    for (std::size_t i = 0; i < r.parts.size(); ++i) j["parts"].push_back(part(r, i));
    j["contacts"] = list_of(r.contacts, contact);
    j["mobility"] = {{"as_drawn", Json::parse(mobility_json(r.as_drawn))},
                     {"under_load", r.under_load ? Json::parse(mobility_json(*r.under_load)) : Json(nullptr)}};
    j["reactions"] = list_of(r.reactions, reaction);
    if (!r.preloads.empty()) j["preloads"] = list_of(r.preloads, preload);
    j["probes"] = list_of(r.probes, probe);
    j["warnings"] = names(r.warnings);
    j["notes"] = names(r.notes);
    if (failed) hide_what_was_not_reached(j, r);
    return j;
}

/// Names may hold bytes that are no UTF-8 (an old drawing's layer): they are replaced, not refused.
std::string primitive_text(const Json& j) {
    return j.dump(-1, ' ', false, Json::error_handler_t::replace);
}

constexpr std::size_t line_width = 120;

bool is_list_of_primitives(const Json& j) {
    return j.is_array() && std::all_of(j.begin(), j.end(), [](const Json& x) { return x.is_primitive(); });
}

/// Brackets around the members, which are appended by append_member and parted by the separator. Ends early, without the rest,
/// once the text is longer than `most`.
template <class AppendMember>
void append_bracketed(const Json& j, const std::string& open_with, const std::string& separator, const std::string& close_with,
                      std::size_t most, std::string& text, AppendMember append_member) {
    text += j.is_array() ? '[' : '{';
    const std::string* between = &open_with;
    for (const auto& [key, value] : j.items()) {
        if (text.size() > most) return;
        text += *between;
        if (j.is_object()) text += primitive_text(key) + ": ";
        append_member(value);
        between = &separator;
    }
    text += close_with;
    text += j.is_array() ? ']' : '}';
}

void append_line(const Json& j, std::size_t most, std::string& text) {
    if (j.is_structured())
        append_bracketed(j, "", ", ", "", most, text, [&](const Json& member) { append_line(member, most, text); });
    else
        text += primitive_text(j);
}

/// One line for what fits on one, and for lists of numbers or names however long; else one member a line.
void print(const Json& j, const std::string& indent, std::string& text) {
    constexpr std::size_t no_limit = std::string::npos;
    if (j.is_primitive() || is_list_of_primitives(j)) return append_line(j, no_limit, text);
    if (!indent.empty()) {
        const std::size_t before = text.size(), most = before + line_width - std::min(line_width, indent.size());
        append_line(j, most, text);
        if (text.size() <= most) return;
        text.resize(before);
    }
    const std::string inner = indent + "  ";
    append_bracketed(j, "\n" + inner, ",\n" + inner, "\n" + indent, no_limit, text,
                     [&](const Json& member) { print(member, inner, text); });
}

}  // namespace

std::string result_json(const Result& result) {
    return result_json(result, ModelFacts{});
}

std::string result_json(const Result& result, const ModelFacts& model) {
    std::string text;
    print(to_json(result, model), "", text);
    return text + "\n";
}

}  // namespace abut
