// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "src/scene/read_selection.hpp"
#include "src/scene/read_supports_loads.hpp"

namespace abut {

namespace {

/// A total force: its components do not vary.
std::optional<std::array<Expression, 2>> read_total(SceneReading& reading, const JsonValue& value, const Dimension& dimension) {
    const std::optional<Vec2> force = read_vector(reading, value, dimension);
    if (!force) return std::nullopt;
    return std::array<Expression, 2>{Expression(force->x()), Expression(force->y())};
}

/// A total moment.
std::optional<std::array<Expression, 2>> read_number_alone(SceneReading& reading, const JsonValue& value,
                                                           const Dimension& dimension) {
    const std::optional<double> number = read_number(reading, value, dimension);
    if (!number) return std::nullopt;
    return std::array<Expression, 2>{Expression(*number), Expression()};
}

/// One field: a pressure, a temperature.
std::optional<std::array<Expression, 2>> read_one(SceneReading& reading, const JsonValue& value, const Dimension& dimension) {
    const std::optional<Expression> field = read_field(reading, value, dimension);
    if (!field) return std::nullopt;
    return std::array<Expression, 2>{*field, Expression()};
}

/// A spin: checked here, its numbers are read by read_spin_numbers.
std::optional<std::array<Expression, 2>> read_spin(SceneReading& reading, const JsonValue& value, const Dimension&) {
    if (!check_object(reading, value, {"about", "omega"})) return std::nullopt;
    return std::array<Expression, 2>{};
}

void read_spin_numbers(SceneReading& reading, const JsonValue& value, Load& load) {
    load.omega = required_member(reading, value, "omega", read_number, dimension::angular_speed).value_or(0);
    load.about = member_or(reading, value, "about", Vec2(0, 0), read_vector,
                           dimension::length);  // whether it has to be there: read_scene
}

/// A preload: checked here, its numbers are read by read_preload_numbers.
std::optional<std::array<Expression, 2>> read_preload(SceneReading& reading, const JsonValue& value, const Dimension&) {
    if (!check_object(reading, value, {"across", "force"})) return std::nullopt;
    return std::array<Expression, 2>{};
}

void read_preload_numbers(SceneReading& reading, const JsonValue& value, Load& load) {
    const std::optional<double> force = required_member(reading, value, "force", read_number, dimension::force);
    load.value[0] = Expression(force.value_or(0));
    if (force && *force <= 0)
        report_problem(reading, *find_member(value, "force"), "a preload is a force above 0",
                       "give the force that the part is tightened to; a load with a name can be left out of a case");
    const JsonValue* across = find_member(value, "across");
    if (!across) {
        report_problem(reading, value, "the key 'across' is missing",
                       "give the two ends of a line across the part: [[x, y], [x, y]]");
        return;
    }
    if (!check_list(reading, *across, 2, "points")) return;
    if (across->items.size() != 2) {
        report_problem(reading, *across, "a line across the part has two ends", "give [[x, y], [x, y]]");
        return;
    }
    for (std::size_t k = 0; k < 2; ++k)
        load.across[k] = read_vector(reading, across->items[k], dimension::length).value_or(Vec2(0, 0));
    if (load.across[0] == load.across[1])
        report_problem(reading, *across, "the two ends of the line across the part are one point",
                       "give two points, one on each side of it");
}

/// The part of a body force, where "*" stands for all parts.
std::optional<std::string> read_part_or_all(SceneReading& reading, const JsonValue& value) {
    if (value.kind == JsonValue::Kind::string && value.text == "*") return value.text;
    return read_part_name(reading, value);
}

/// What a kind of load says, and what it acts on.
struct LoadKind {
    const char* key;
    Load::Kind kind;
    std::optional<std::array<Expression, 2>> (*read)(SceneReading&, const JsonValue&, const Dimension&);
    Dimension dimension;
    enum class Acts { on_edges, on_part, on_part_or_all, everywhere } acts;
};
constexpr LoadKind load_kinds[] = {
    {"pressure", Load::Kind::pressure, read_one, dimension::stress, LoadKind::Acts::on_edges},
    {"traction", Load::Kind::traction, read_vector_field, dimension::stress, LoadKind::Acts::on_edges},
    {"force", Load::Kind::edge_force, read_total, dimension::force, LoadKind::Acts::on_edges},
    {"moment", Load::Kind::edge_moment, read_number_alone, dimension::moment, LoadKind::Acts::on_edges},
    {"moment", Load::Kind::part_moment, read_number_alone, dimension::moment, LoadKind::Acts::on_part},
    {"bearing", Load::Kind::bearing, read_total, dimension::force, LoadKind::Acts::on_edges},
    {"force", Load::Kind::part_force, read_total, dimension::force, LoadKind::Acts::on_part},
    {"body_force", Load::Kind::body_force, read_vector_field, dimension::body_force, LoadKind::Acts::on_part_or_all},
    {"gravity", Load::Kind::gravity, read_total, dimension::acceleration, LoadKind::Acts::everywhere},
    {"spin", Load::Kind::spin, read_spin, dimension::angular_speed, LoadKind::Acts::on_part},
    {"temperature", Load::Kind::temperature, read_one, dimension::temperature, LoadKind::Acts::on_part},
    {"preload", Load::Kind::preload, read_preload, dimension::force, LoadKind::Acts::on_part},
};

/// "force" and "moment" mean one thing with "on" and another with "part".
const LoadKind& kind_of(const std::string& key, bool has_part) {
    const LoadKind* found = nullptr;
    for (const LoadKind& kind : load_kinds) {
        if (kind.key == key && (!found || has_part)) found = &kind;
    }
    return *found;
}

void read_target(SceneReading& reading, const JsonValue& value, const LoadKind& kind, Load& load) {
    const bool on_edges = kind.acts == LoadKind::Acts::on_edges;
    const std::string wanted = on_edges ? "on" : kind.acts == LoadKind::Acts::everywhere ? "" : "part";
    for (const char* key : {"on", "part"}) {
        const JsonValue* other = find_member(value, key);
        if (!other || key == wanted) continue;
        report_problem(reading, *other, "'" + other->key + "' does not go with '" + kind.key + "'",
                       wanted.empty() ? "it acts on all parts" : "give '" + wanted + "' alone");
        return;
    }
    if (on_edges) load.on = required_member(reading, value, "on", read_selection).value_or(Selection{});
    if (wanted != "part") return;
    const auto read = kind.acts == LoadKind::Acts::on_part ? read_part_name : read_part_or_all;
    load.part = required_member(reading, value, "part", read).value_or("");
}

std::optional<Load> read_load(SceneReading& reading, const JsonValue& value) {
    const std::size_t before = reading.problems.size();
    const Words keys{"on",   "pressure",   "traction", "force", "at",          "moment",  "bearing",
                     "part", "body_force", "gravity",  "spin",  "temperature", "preload", "name"};
    if (!check_object(reading, value, keys) || reading.problems.size() > before) return std::nullopt;
    const JsonValue* what = exactly_one(
        reading, value,
        {"pressure", "traction", "force", "moment", "bearing", "body_force", "gravity", "spin", "temperature", "preload"});
    if (!what) return std::nullopt;
    const LoadKind& kind = kind_of(what->key, find_member(value, "part") != nullptr);
    Load load;
    load.kind = kind.kind;
    load.where = value.pointer;
    load.name = member_or(reading, value, "name", std::string(), read_text);
    load.value = kind.read(reading, *what, kind.dimension).value_or(std::array<Expression, 2>{});
    if (kind.kind == Load::Kind::spin && what->kind == JsonValue::Kind::object) read_spin_numbers(reading, *what, load);
    if (kind.kind == Load::Kind::preload && what->kind == JsonValue::Kind::object) read_preload_numbers(reading, *what, load);
    read_target(reading, value, kind, load);
    if (const JsonValue* at = find_member(value, "at")) {
        if (kind.kind == Load::Kind::edge_force)
            load.at = read_vector(reading, *at, dimension::length);
        else if (kind.kind == Load::Kind::part_force)
            report_problem(
                reading, *at, "a force at a point of a part is not there yet: beside it stress has no limit",
                "name the edge that it acts on (\"on\" in place of \"part\", with the same \"at\"); without \"at\" a "
                "part's force acts on all of it, like a weight");
        else
            report_problem(reading, *at, "'at' goes with 'force' on edges ('on') alone", "take it away");
    }
    if (reading.problems.size() > before) return std::nullopt;
    return load;
}

}  // namespace

std::vector<Load> read_loads(SceneReading& reading, const JsonValue& loads) {
    std::vector<Load> result;
    if (!check_list(reading, loads, 0, "loads")) return result;
    for (const JsonValue& item : loads.items) {
        if (auto load = read_load(reading, item)) result.push_back(std::move(*load));
    }
    return result;
}

}  // namespace abut
