// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/live/live_settings.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "src/base/ensure.hpp"
#include "src/io/json_document.hpp"
#include "src/scene/selection.hpp"

namespace abut {

namespace {

constexpr double most_friction = 1,
                 most_interference = 1e-3;  ///< the latter of the model's size; more where the scene has more
constexpr std::size_t most_pairs = 24;      ///< a page with more sliders helps nobody

double size_of(const Scene& scene) {
    geometry::Box2 box;
    for (const ScenePart& part : scene.parts) box.extend(geometry::bounding_box(part.part));
    return box.empty() ? 1 : box.diagonal();
}

/// 1, 2 or 5 times a power of ten, not below.
double nice_above(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double m : {1.0, 2.0, 5.0})
        if (m * decade >= value) return m * decade;
    return 10 * decade;
}

/// The part that a selector speaks of, as far as its words say; "" stands for any.
std::string part_in(const Selector& selector) {
    if (selector.pattern.empty()) return selector.part;
    const std::string part = selector.pattern.substr(0, selector.pattern.find('/'));
    return part.find('*') == std::string::npos ? part : "";
}

/// The part that all of a rule's side speaks of; "" where there are several.
std::string part_in(const Selection& side) {
    const std::string part = part_in(side.front());
    const bool is_one = std::all_of(side.begin(), side.end(), [&](const Selector& s) { return part_in(s) == part; });
    return is_one ? part : "";
}

bool speaks_of(const PairRule& rule, const std::array<std::string, 2>& parts) {
    const auto is = [&](std::size_t side, const std::string& part) {
        return std::any_of(rule.between[side].begin(), rule.between[side].end(), [&](const Selector& selector) {
            const std::string own = part_in(selector);
            return own.empty() || own == part;
        });
    };
    return (is(0, parts[0]) && is(1, parts[1])) || (is(0, parts[1]) && is(1, parts[0]));
}

Selection all_edges_of(const std::string& part) {
    Selector all;
    all.pattern = part + "/*";
    return {all};
}

void move_selection(Selector& selector, const std::string& part, const Vec2& by) {
    if (selector.part != part) return;
    if (selector.near) *selector.near += by;
    if (selector.box)
        for (Vec2& corner : *selector.box) corner += by;
}

void move_part(Scene& scene, const std::string& name, const Vec2& by) {
    for (ScenePart& part : scene.parts)
        if (part.name == name) turn_and_shift(part, 1, 0, by);
    for (Probe& probe : scene.output.probes)
        if (probe.part == name) probe.at += by;
    for (Support& support : scene.supports) {
        for (Selector& selector : support.on) move_selection(selector, name, by);
        if (support.part == name)
            for (Vec2& at : support.at) at += by;
    }
    for (Load& load : scene.loads) {
        for (Selector& selector : load.on) move_selection(selector, name, by);
        if (load.part == name && load.kind == Load::Kind::preload)
            for (Vec2& end : load.across) end += by;
    }
}

const LiveSetting& setting_of(const std::vector<LiveSetting>& settings, const std::string& key) {
    const auto own = std::find_if(settings.begin(), settings.end(), [&](const LiveSetting& s) { return s.key == key; });
    ENSURE(own != settings.end(), "a setting that was moved is one of the scene's");
    return *own;
}

using TextJson = nlohmann::ordered_json;

/// "place" of a part with another translation.
TextJson moved_place(const JsonValue& part, const std::vector<double>& by) {
    const JsonValue* place = find_member(part, "place");
    const JsonValue* before = place ? find_member(*place, "translate") : nullptr;
    TextJson translate = TextJson::array();
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const bool is_number = !before || before->items[axis].kind == JsonValue::Kind::number;
        if (!is_number)
            throw InputError(part.pointer + "/place/translate", "this is no number in the file, and cannot be written moved",
                             "write it as numbers, or leave the part where it is");
        translate.push_back((before ? before->items[axis].number : 0) + by[axis]);
    }
    return translate;
}

}  // namespace

std::vector<LiveSetting> live_settings(const Scene& scene, const std::vector<ContactResult>& contacts) {
    using Kind = LiveSetting::Kind;
    std::vector<LiveSetting> settings;
    const double size = size_of(scene), usual = nice_above(most_interference * size);
    const bool has_friction = !scene.contacts.penalty && scene.analysis != Analysis::axisymmetric;
    if (has_friction && std::isfinite(scene.contacts.friction))
        settings.push_back({Kind::friction,
                            "friction",
                            0,
                            {},
                            {scene.contacts.friction},
                            0,
                            std::max(most_friction, scene.contacts.friction)});
    for (std::size_t r = 0; r < scene.contacts.pairs.size(); ++r) {
        const PairRule& rule = scene.contacts.pairs[r];
        if (rule.kind != PairRule::Kind::contact) continue;
        const double reach = std::max(usual, 2 * std::abs(rule.interference));
        settings.push_back({Kind::rule,
                            "rule " + std::to_string(r + 1),
                            r,
                            {part_in(rule.between[0]), part_in(rule.between[1])},
                            {rule.interference},
                            -reach,
                            reach});
    }
    std::set<std::array<std::string, 2>> told;
    for (const ContactResult& c : contacts) {
        const auto speaks = [&](const PairRule& rule) { return speaks_of(rule, c.parts); };
        const auto& rules = scene.contacts.pairs;
        if (c.kind != "contact" || told.size() >= most_pairs || std::any_of(rules.begin(), rules.end(), speaks)) continue;
        if (!told.insert(c.parts).second) continue;
        settings.push_back({Kind::pair, "pair " + c.parts[0] + ", " + c.parts[1], 0, c.parts, {0}, -usual, usual});
    }
    for (const ScenePart& part : scene.parts)
        settings.push_back({Kind::place, "place " + part.name, 0, {part.name, ""}, {0, 0}, -size, size});
    return settings;
}

Scene with_settings(Scene scene, const std::vector<LiveSetting>& settings, const LiveSettings& moved) {
    for (const auto& [key, value] : moved) {
        const LiveSetting& s = setting_of(settings, key);
        switch (s.kind) {
            case LiveSetting::Kind::friction:
                scene.contacts.friction = value[0];
                break;
            case LiveSetting::Kind::rule:
                scene.contacts.pairs[s.rule].interference = value[0];
                break;
            case LiveSetting::Kind::pair: {
                PairRule rule;
                rule.between = {all_edges_of(s.parts[0]), all_edges_of(s.parts[1])};
                rule.interference = value[0];
                resolve(scene, rule);
                scene.contacts.pairs.push_back(rule);
                break;
            }
            case LiveSetting::Kind::place:
                move_part(scene, s.parts[0], {value[0], value[1]});
                break;
        }
    }
    return scene;
}

std::map<std::string, std::string> settings_as_text(const std::string& text, const Scene& scene,
                                                    const std::vector<LiveSetting>& settings, const LiveSettings& moved) {
    const JsonDocument document = parse_json(text, scene.file);
    std::map<std::string, std::string> value_at;
    TextJson contacts = TextJson::object(), rules = TextJson::array();
    for (const auto& [key, value] : moved) {
        const LiveSetting& s = setting_of(settings, key);
        if (s.kind == LiveSetting::Kind::friction) contacts["friction"] = value[0];
        if (s.kind == LiveSetting::Kind::rule)
            value_at[scene.contacts.pairs[s.rule].where + "/interference"] = TextJson(value[0]).dump();
        if (s.kind == LiveSetting::Kind::pair)
            rules.push_back({{"between", {s.parts[0] + "/*", s.parts[1] + "/*"}}, {"interference", value[0]}});
        if (s.kind != LiveSetting::Kind::place) continue;
        const auto part =
            std::find_if(scene.parts.begin(), scene.parts.end(), [&](const ScenePart& p) { return p.name == s.parts[0]; });
        const JsonValue* own = find_pointer(document.root, part->where);
        const bool is_drawn_here = own && find_member(*own, "geometry") && !find_member(*own, "array");
        if (!is_drawn_here)
            throw InputError(part->where,
                             "the part " + part->name +
                                 " is one of several that are drawn together: it has no place "
                                 "of its own to write",
                             "put it back, or move it in its drawing");
        const TextJson translate = moved_place(*own, value);
        if (find_member(*own, "place"))
            value_at[part->where + "/place/translate"] = translate.dump();
        else
            value_at[part->where + "/place"] = TextJson{{"translate", translate}}.dump();
    }
    const JsonValue* before = find_member(document.root, "contacts");
    if (!before) {
        if (!rules.empty()) contacts["pairs"] = rules;
        if (!contacts.empty()) value_at["/contacts"] = contacts.dump();
        return value_at;
    }
    if (contacts.contains("friction")) value_at["/contacts/friction"] = contacts["friction"].dump();
    if (rules.empty()) return value_at;
    const std::string list = rules.dump();
    if (find_member(*before, "pairs"))
        value_at["/contacts/pairs/-"] = list.substr(1, list.size() - 2);
    else
        value_at["/contacts/pairs"] = list;
    return value_at;
}

}  // namespace abut
