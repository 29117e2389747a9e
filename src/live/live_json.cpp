// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/live/live_json.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "src/io/json_document.hpp"
#include "src/io/json_edit.hpp"
#include "src/io/nearest_name.hpp"
#include "src/io/number_text.hpp"
#include "src/report/page_data.hpp"
#include "src/results/verdict.hpp"

namespace abut {

namespace {

using LiveJson = nlohmann::ordered_json;

std::string dumped(const LiveJson& j) {
    return j.dump(-1, ' ', false, LiveJson::error_handler_t::replace);
}

LiveJson pair(const Vec2& v) {
    return LiveJson::array({v.x(), v.y()});
}

LiveJson load_control(const Scene& scene, std::size_t k, const LoadFacts& facts) {
    const Load& load = scene.loads[k];
    LiveJson j{{"name", load.name}, {"kind", facts.kind},           {"unit", facts.unit},           {"value", facts.value},
               {"on", facts.on},    {"force", is_live_force(load)}, {"sign", keeps_its_sign(load)}, {"where", load.where},
               {"at", nullptr}};
    if (facts.at.empty()) return j;
    Vec2 middle(0, 0);
    for (const Vec2& at : facts.at) middle += at / static_cast<double>(facts.at.size());
    // of an edge around the middle the arrow stands on the edge
    const auto nearest = std::min_element(facts.at.begin(), facts.at.end(), [&](const Vec2& a, const Vec2& b) {
        return (a - middle).norm() < (b - middle).norm();
    });
    j["at"] = pair(*nearest);
    return j;
}

LiveJson contact_answer(const ContactAnswer& c) {
    const ContactPlaces none, &places = c.places ? *c.places : none;
    std::vector<std::string> edges;
    std::vector<std::size_t> edge;
    for (const std::string& name : places.edge) {
        if (edges.empty() || edges.back() != name) edges.push_back(name);
        edge.push_back(edges.size() - 1);
    }
    LiveJson profile{{"edges", edges}, {"edge", edge},  {"s", places.s},
                     {"x", places.x},  {"y", places.y}, {"pressure", c.pressure}};
    if (!c.shear.empty()) profile["shear"] = c.shear;
    return {{"between", c.between},
            {"kind", c.kind},
            {"status", c.status},
            {"force", pair(c.force)},
            {"moment", c.moment},
            {"length", c.contact_length},
            {"max_pressure", {{"value", c.max_pressure.value}, {"at", pair(c.max_pressure.at)}}},
            {"error_at_ends", c.error_at_ends},
            {"profile", profile}};
}

LiveJson setting_control(const LiveSetting& s) {
    constexpr std::array<const char*, 4> words{"friction", "rule", "pair", "place"};
    return {{"key", s.key},     {"kind", words[static_cast<std::size_t>(s.kind)]},
            {"parts", s.parts}, {"value", s.value},
            {"min", s.least},   {"max", s.most}};
}

LiveJson twist_list(const std::vector<PartTwist>& twists) {
    LiveJson list = LiveJson::array();
    for (const PartTwist& t : twists) list.push_back({{"part", t.part}, {"twist", {t.twist[0], t.twist[1], t.twist[2]}}});
    return list;
}

/// By part of the result: the directions in which its supports let it slide, all contacts left aside.
LiveJson slides(const Result& result) {
    LiveJson list = LiveJson::array();
    for (const PartResult& part : result.parts) {
        LiveJson own = LiveJson::array();
        for (const PartMobility& m : result.as_drawn.parts)
            for (const Screw& twist : m.twists)
                if (m.part == part.name && twist[2] == 0) own.push_back({twist[0], twist[1]});
        list.push_back(own);
    }
    return list;
}

LiveJson problem_list(const std::vector<Problem>& problems) {
    LiveJson list = LiveJson::array();
    for (const Problem& p : problems) list.push_back({{"where", p.where}, {"what", p.what}, {"hint", p.hint}});
    return list;
}

/// A request's text as an object with known keys.
LiveJson request_object(const std::string& text, const std::vector<std::string>& keys) {
    LiveJson j = LiveJson::parse(text, nullptr, false);
    if (!j.is_object()) throw InputError("request", "expected an object as JSON text", "see src/live/README.md");
    for (const auto& [key, value] : j.items())
        if (std::find(keys.begin(), keys.end(), key) == keys.end())
            throw InputError("request", "the key '" + shortened(key) + "' is not known", nearest_name_hint(key, keys));
    return j;
}

double finite_number(const LiveJson& j, const std::string& where) {
    if (!j.is_number() || !std::isfinite(j.get<double>())) throw InputError(where, "expected a finite number");
    return j.get<double>();
}

void read_parameters_moved(const LiveJson& j, const LiveControls& controls, LiveInputs& inputs) {
    if (!j.is_object()) throw InputError("/parameters", "expected an object of numbers by name");
    std::vector<std::string> names;
    for (const ParameterRange& p : controls.parameters) names.push_back(p.name);
    for (const auto& [name, value] : j.items()) {
        const auto own = std::find(names.begin(), names.end(), name);
        const std::string where = "/parameters/" + shortened(name);
        if (own == names.end())
            throw InputError(where, "no parameter with a range has this name", nearest_name_hint(name, names));
        const ParameterRange& range = controls.parameters[static_cast<std::size_t>(own - names.begin())];
        const double number = finite_number(value, where);
        if (number < range.least || number > range.most)
            throw InputError(where, number_text(number, 6) + " is not between " + number_text(range.least, 6) + " and " +
                                        number_text(range.most, 6));
        inputs.parameters[name] = number;
    }
}

void read_settings_moved(const LiveJson& j, const LiveControls& controls, LiveInputs& inputs) {
    if (!j.is_object()) throw InputError("/settings", "expected an object of lists of numbers");
    std::vector<std::string> keys;
    for (const LiveSetting& s : controls.settings) keys.push_back(s.key);
    inputs.settings.clear();
    for (const auto& [key, value] : j.items()) {
        const std::string where = "/settings/" + shortened(key);
        const auto own = std::find(keys.begin(), keys.end(), key);
        if (own == keys.end()) throw InputError(where, "nothing of this name can be set", nearest_name_hint(key, keys));
        const LiveSetting& s = controls.settings[static_cast<std::size_t>(own - keys.begin())];
        if (!value.is_array() || value.size() != s.value.size())
            throw InputError(where, "expected a list of as many numbers as it has: " + std::to_string(s.value.size()));
        std::vector<double> numbers;
        for (const LiveJson& number : value) {
            numbers.push_back(finite_number(number, where));
            if (numbers.back() < s.least || numbers.back() > s.most)
                throw InputError(where, number_text(numbers.back(), 6) + " is not between " + number_text(s.least, 6) +
                                            " and " + number_text(s.most, 6));
        }
        if (numbers != s.value) inputs.settings[key] = numbers;
    }
}

void read_loads_moved(const LiveJson& j, const Scene& scene, LiveInputs& inputs) {
    if (!j.is_array() || j.size() != inputs.loads.size())
        throw InputError("/loads", "expected a list of as many loads as the scene has: " + std::to_string(inputs.loads.size()));
    for (std::size_t k = 0; k < j.size(); ++k) {
        const std::string where = "/loads/" + std::to_string(k);
        const bool is_force = is_live_force(scene.loads[k]);
        if (!j[k].is_array() || (j[k].size() != 1 && !(is_force && j[k].size() == 2)))
            throw InputError(
                where, is_force ? "expected the two components of a force, or a factor" : "expected a list of one factor");
        inputs.loads[k].clear();
        for (const LiveJson& number : j[k]) inputs.loads[k].push_back(finite_number(number, where));
        if (keeps_its_sign(scene.loads[k]) && inputs.loads[k][0] < 0) throw InputError(where, "this load cannot be negative");
    }
}

/// A number of a file, times a factor: what is no number there is an expression.
std::string scaled_text(const JsonValue& value, double factor) {
    if (value.kind == JsonValue::Kind::number) return dumped(value.number * factor);
    if (value.kind != JsonValue::Kind::array) return "";
    std::string list;
    for (const JsonValue& item : value.items) {
        const std::string one = scaled_text(item, factor);
        if (one.empty()) return "";
        list += (list.empty() ? "" : ", ") + one;
    }
    return "[" + list + "]";
}

}  // namespace

std::string controls_json(const Scene& scene, const LiveControls& controls) {
    LiveJson j{{"file", scene.file},
               {"title", scene.title},
               {"target", controls.target},
               {"remembers", controls.remembers},
               {"parameters", LiveJson::array()},
               {"loads", LiveJson::array()},
               {"cases", LiveJson::array()},
               {"settings", LiveJson::array()}};
    for (const LiveSetting& s : controls.settings) j["settings"].push_back(setting_control(s));
    for (const ParameterRange& p : controls.parameters)
        j["parameters"].push_back(
            {{"name", p.name}, {"value", p.value}, {"min", p.least}, {"max", p.most}, {"where", p.where}});
    for (std::size_t k = 0; k < scene.loads.size(); ++k) j["loads"].push_back(load_control(scene, k, controls.loads[k]));
    for (const LoadCase& c : scene.cases) j["cases"].push_back({{"name", c.name}, {"loads", live_loads(scene, c)}});
    return dumped(j);
}

std::string inputs_json(const LiveInputs& inputs, const std::string& client, long version) {
    return dumped({{"client", client},
                   {"version", version},
                   {"parameters", inputs.parameters},
                   {"loads", inputs.loads},
                   {"settings", inputs.settings}});
}

std::string whole_json(const Result& result, const ModelFacts& model, bool is_draft, const LiveSettings& settings,
                       long version) {
    const LiveJson j{{"version", version},
                     {"draft", is_draft},
                     {"status", result.status},
                     {"verdict", verdict_word(verdict_of(result))},
                     {"sentence", verdict_sentence(result)},
                     {"warnings", result.warnings},
                     {"settings", settings},
                     {"slides", slides(result)},
                     {"driven", twist_list(result.driven)}};
    std::string text = dumped(j);
    text.pop_back();
    return text + ",\"data\":" + report::page_data(result, model) + "}";
}

std::string answer_json(const Answer& answer, long version) {
    LiveJson j{{"version", version},
               {"status", answer.status},
               {"message", answer.message},
               {"doubts", answer.doubts},
               {"contacts", LiveJson::array()},
               {"probes", LiveJson::array()},
               {"driven", twist_list(answer.driven)}};
    for (const ContactAnswer& c : answer.contacts) j["contacts"].push_back(contact_answer(c));
    for (const ProbeAnswer& p : answer.probes)
        j["probes"].push_back({{"part", p.part}, {"at", pair(p.at)}, {"displacement", pair(p.displacement)}});
    return dumped(j);
}

std::string fields_json(const Result& prepared, const std::vector<PartField>& fields, long version) {
    return "{\"version\":" + std::to_string(version) + ",\"fields\":" + report::fields_data(prepared.geometry, fields) + "}";
}

std::string edges_json(const Scene& scene, const std::string& text) {
    constexpr double drawn_turn = 0.1;  // radians between points of a curve
    LiveJson list = LiveJson::array();
    for (const ScenePart& part : scene.parts)
        for (const geometry::Edge& edge : part.part.edges) {
            const int steps = std::max(1, static_cast<int>(std::ceil(turning(edge.curve, 0, 1) / drawn_turn)));
            LiveJson points = LiveJson::array();
            for (int q = 0; q <= steps; ++q) points.push_back(pair(point(edge.curve, static_cast<double>(q) / steps)));
            list.push_back({{"name", part.name + "/" + edge.name}, {"points", points}});
        }
    const LiveJson whole = LiveJson::parse(text, nullptr, false, true);
    const auto own = [&](const char* key) { return whole.is_object() && whole.contains(key) ? whole[key] : LiveJson::array(); };
    return dumped({{"edges", list}, {"supports", own("supports")}, {"loads", own("loads")}});
}

std::string problems_json(const std::vector<Problem>& problems) {
    return dumped(problem_list(problems));
}

std::string saved_json(const std::string& path) {
    return dumped({{"saved", path}});
}

LiveRequest read_live_request(const std::string& text, const Scene& scene, const LiveControls& controls,
                              const LiveInputs& before) {
    const LiveJson j = request_object(text, {"client", "after", "parameters", "loads", "settings"});
    LiveRequest request{"", 0, before};
    if (j.contains("client") && j["client"].is_string()) request.client = j["client"].get<std::string>();
    if (j.contains("after")) request.after = static_cast<long>(std::clamp(finite_number(j["after"], "/after"), -1.0, 1e15));
    if (j.contains("parameters")) read_parameters_moved(j["parameters"], controls, request.inputs);
    if (j.contains("loads")) read_loads_moved(j["loads"], scene, request.inputs);
    if (j.contains("settings")) read_settings_moved(j["settings"], controls, request.inputs);
    return request;
}

std::map<std::string, std::string> read_conditions_request(const std::string& text) {
    const LiveJson j = request_object(text, {"supports", "loads"});
    std::map<std::string, std::string> value_at;
    for (const auto& [key, value] : j.items()) {
        if (!value.is_array()) throw InputError("/" + key, "expected a list");
        value_at["/" + key] = dumped(value);
    }
    return value_at;
}

std::string json_text(const std::string& words) {
    return dumped(words);
}

std::string read_save_request(const std::string& text) {
    const LiveJson j = request_object(text, {"name"});
    const std::string name = j.contains("name") && j["name"].is_string() ? j["name"].get<std::string>() : "";
    const bool is_plain = std::all_of(name.begin(), name.end(),
                                      [](char c) { return static_cast<unsigned char>(c) >= ' ' && c != '/' && c != '\\'; });
    if (!is_plain || name.size() < 6 || name.size() > 200 || name[0] == '.' || name.substr(name.size() - 5) != ".json")
        throw InputError("/name", "'" + shortened(name) + "' is no name of a scene's file",
                         "give a name that ends in .json, without a folder");
    return name;
}

std::string scene_text_with(const std::string& text, const Scene& scene, const LiveControls& controls,
                            const LiveInputs& inputs) {
    const JsonDocument document = parse_json(text, scene.file);
    std::map<std::string, std::string> value_at = settings_as_text(text, scene, controls.settings, inputs.settings);
    for (const ParameterRange& p : controls.parameters)
        if (inputs.parameters.at(p.name) != p.value) value_at[p.where + "/value"] = dumped(inputs.parameters.at(p.name));
    for (std::size_t k = 0; k < scene.loads.size(); ++k) {
        if (inputs.loads[k] == std::vector<double>{1}) continue;
        const std::string place = scene.loads[k].where + "/" + controls.loads[k].kind;
        if (is_live_force(scene.loads[k])) {
            value_at[place] = dumped(pair(live_force(scene.loads[k], inputs.loads[k])));
            continue;
        }
        const JsonValue* value = find_pointer(document.root, place);
        const std::string scaled = value ? scaled_text(*value, inputs.loads[k][0]) : "";
        if (scaled.empty())
            throw InputError(
                place, "the load is no number in the file, and cannot be written times " + number_text(inputs.loads[k][0], 6),
                "write it as numbers, or move it back to 1");
        value_at[place] = scaled;
    }
    return with_values(text, value_at);
}

}  // namespace abut
