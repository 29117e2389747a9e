// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/read_selection.hpp"

#include <utility>

#include "src/scene/part_levels.hpp"
#include "src/scene/selection.hpp"

namespace abut {

namespace {

std::optional<double> read_half_angle(SceneReading& reading, const JsonValue& value) {
    const std::optional<double> angle = read_number(reading, value, dimension::angle);
    if (!angle || (*angle >= 0 && *angle <= 180)) return angle;
    report_problem(reading, value, "'within' must lie between 0 and 180 degrees");
    return std::nullopt;
}

std::optional<std::array<Vec2, 2>> read_box(SceneReading& reading, const JsonValue& value) {
    if (value.kind != JsonValue::Kind::array || value.items.size() != 2) {
        report_problem(reading, value, "expected two corners [[x0, y0], [x1, y1]], found " + described(value));
        return std::nullopt;
    }
    const std::optional<Vec2> a = read_vector(reading, value.items[0], dimension::length),
                              b = read_vector(reading, value.items[1], dimension::length);
    if (!a || !b) return std::nullopt;
    return std::array<Vec2, 2>{a->cwiseMin(*b), a->cwiseMax(*b)};
}

/// Reads one selector: one text or one object.
std::optional<Selector> read_selector(SceneReading& reading, const JsonValue& value) {
    Selector selector;
    selector.where = value.pointer;
    if (value.kind == JsonValue::Kind::string) {
        const auto pattern = read_text(reading, value);
        selector.pattern = pattern.value_or("");
        return pattern ? std::optional(selector) : std::nullopt;
    }
    if (value.kind != JsonValue::Kind::object) {
        report_problem(reading, value, "expected an edge, found " + described(value),
                       "write \"part/edge\" or an object with 'part' and 'near', 'box' or 'facing'");
        return std::nullopt;
    }
    const std::size_t before = reading.problems.size();
    check_object(reading, value, {"part", "near", "box", "facing", "within"});
    const auto part = required_member(reading, value, "part", read_part_name);
    const JsonValue* way = exactly_one(reading, value, {"near", "box", "facing"});
    if (part) selector.part = *part;
    if (way && way->key == "near") selector.near = read_vector(reading, *way, dimension::length);
    if (way && way->key == "box") selector.box = read_box(reading, *way);
    if (way && way->key == "facing") selector.facing = read_direction(reading, *way);
    const JsonValue* within = find_member(value, "within");
    if (within && way && way->key != "facing") report_problem(reading, *within, "'within' belongs to 'facing'", "remove it");
    selector.within = member_or(reading, value, "within", selector.within, read_half_angle);
    if (!part || reading.problems.size() > before) return std::nullopt;
    return selector;
}

std::vector<EdgePortion> check_selector(SceneReading& reading, const Scene& scene, const Selector& selector) {
    const JsonValue* at = find_pointer(reading.root, selector.where);
    try {
        return select(scene, {selector});
    } catch (const InputError& error) {
        for (const Problem& problem : error.problems())
            report_problem(reading, at ? *at : reading.root, problem.what, problem.hint);
        return {};
    }
}

std::vector<EdgePortion> check_selection(SceneReading& reading, const Scene& scene, const Selection& selection) {
    std::vector<EdgePortion> portions;
    for (const Selector& selector : selection) {
        const std::vector<EdgePortion> own = check_selector(reading, scene, selector);
        portions.insert(portions.end(), own.begin(), own.end());
    }
    return portions;
}

/// A rule for parts that lie on different levels, all of them, says what cannot be.
void resolve_rule(SceneReading& reading, const Scene& scene, PairRule& rule) {
    const std::size_t before = reading.problems.size();
    for (const Selection& side : rule.between) check_selection(reading, scene, side);
    if (reading.problems.size() > before) return;
    resolve(scene, rule);
    if (rule.kind == PairRule::Kind::ignore) return;
    for (const EdgePortion& a : rule.on[0])
        for (const EdgePortion& b : rule.on[1])
            if (have_common_level(scene_part(scene, a.part).level, scene_part(scene, b.part).level)) return;
    report_problem(reading, *find_pointer(reading.root, rule.where),
                   "these edges belong to parts that have no level in common: they cannot meet",
                   "give the parts a common \"level\", or take the rule away");
}

}  // namespace

std::optional<Selection> read_selection(SceneReading& reading, const JsonValue& value) {
    Selection selection;
    if (value.kind != JsonValue::Kind::array) {
        if (auto selector = read_selector(reading, value)) selection.push_back(std::move(*selector));
    } else if (check_list(reading, value, 1, "edges")) {
        for (const JsonValue& item : value.items) {
            if (auto selector = read_selector(reading, item)) selection.push_back(std::move(*selector));
        }
    }
    if (selection.empty()) return std::nullopt;
    return selection;
}

void check_selections(SceneReading& reading, Scene& scene) {
    for (const Support& support : scene.supports) check_selection(reading, scene, support.on);
    for (const Load& load : scene.loads) check_selection(reading, scene, load.on);
    for (PairRule& pair : scene.contacts.pairs) resolve_rule(reading, scene, pair);
}

}  // namespace abut
