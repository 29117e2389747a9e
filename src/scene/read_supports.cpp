// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>
#include <utility>

#include "src/scene/read_selection.hpp"
#include "src/scene/read_supports_loads.hpp"

namespace abut {

namespace {

using Kind = JsonValue::Kind;

void read_fix(SceneReading& reading, const JsonValue& value, Support& support) {
    support.kind = Support::Kind::fix;
    if (!check_list(reading, value, 1, "\"x\" and \"y\"")) return;
    for (const JsonValue& item : value.items) {
        const auto word = read_word(reading, item, {"x", "y"});
        if ((word == "x" && support.x) || (word == "y" && support.y))
            report_problem(reading, item, "\"" + *word + "\" is there twice", "hold each direction once, by \"x\" and \"y\"");
        support.x |= word == "x";
        support.y |= word == "y";
    }
}

void read_displacement(SceneReading& reading, const JsonValue& value, Support& support) {
    support.kind = Support::Kind::displacement;
    if (!check_object(reading, value, {"x", "y"})) return;
    const JsonValue* x = find_member(value, "x");
    const JsonValue* y = find_member(value, "y");
    support.x = x != nullptr;
    support.y = y != nullptr;
    if (x) support.value[0] = read_field(reading, *x, dimension::length).value_or(Expression());
    if (y) support.value[1] = read_field(reading, *y, dimension::length).value_or(Expression());
    if (!x && !y) report_problem(reading, value, "no component is prescribed", "give 'x', 'y' or both");
}

void read_symmetry(SceneReading& reading, const JsonValue& value, Support& support) {
    support.kind = Support::Kind::symmetry;
    if (read_flag(reading, value) == false)
        report_problem(reading, value, "'" + value.key + "' can only be true", "remove the entry");
}

/// A component of a rigid motion: null leaves it free.
std::optional<double> read_rigid_component(SceneReading& reading, const JsonValue& value, const Dimension& dimension) {
    return value.kind == Kind::null ? std::nullopt : read_number(reading, value, dimension);
}

void read_rigid(SceneReading& reading, const JsonValue& value, Support& support) {
    support.kind = Support::Kind::rigid;
    if (!check_object(reading, value, {"translation", "rotation"})) return;
    const std::size_t before = reading.problems.size();
    const JsonValue* translation = find_member(value, "translation");
    if (translation && translation->kind == Kind::array && translation->items.size() == 2) {
        support.rigid_x = read_rigid_component(reading, translation->items[0], dimension::length);
        support.rigid_y = read_rigid_component(reading, translation->items[1], dimension::length);
    } else if (translation && translation->kind != Kind::null) {
        report_problem(reading, *translation, "expected two numbers [tx, ty], found " + described(*translation),
                       "null leaves a component free");
    }
    const JsonValue* rotation = find_member(value, "rotation");
    if (rotation) support.rigid_rotation = read_rigid_component(reading, *rotation, dimension::angle);
    if (support.rigid_rotation) *support.rigid_rotation *= std::numbers::pi / 180;
    const bool all_free = !support.rigid_x && !support.rigid_y && !support.rigid_rotation;
    if (all_free && reading.problems.size() == before)
        report_problem(reading, value, "this leaves the part free", "give 'translation', 'rotation' or both");
}

std::optional<double> read_stiffness(SceneReading& reading, const JsonValue& value) {
    const auto k = read_number(reading, value, dimension::foundation);
    if (k && *k < 0) report_problem(reading, value, "a spring's stiffness must not be negative", "0 leaves the direction free");
    return k;
}

void read_spring(SceneReading& reading, const JsonValue& value, Support& support) {
    support.kind = Support::Kind::spring;
    if (!check_object(reading, value, {"normal", "tangential"})) return;
    const std::size_t before = reading.problems.size();
    support.spring_normal = member_or(reading, value, "normal", 0.0, read_stiffness);
    support.spring_tangential = member_or(reading, value, "tangential", 0.0, read_stiffness);
    if (reading.problems.size() == before && support.spring_normal == 0 && support.spring_tangential == 0)
        report_problem(reading, value, "the spring has no stiffness", "give 'normal', 'tangential' or both");
}

/// "at" with "fix": held points, or one.
void read_points(SceneReading& reading, const JsonValue& value, const JsonValue& what, Support& support) {
    if (what.key != "fix") {
        report_problem(reading, value, "'at' does not go with '" + what.key + "'", "points can be held by 'fix' only");
        return;
    }
    support.kind = Support::Kind::points;
    if (!check_list(reading, value, 1, "a point [x, y], or several")) return;
    if (value.items.front().kind != JsonValue::Kind::array) {
        if (const auto p = read_vector(reading, value, dimension::length)) support.at.push_back(*p);
        return;
    }
    for (const JsonValue& item : value.items)
        if (const auto p = read_vector(reading, item, dimension::length)) support.at.push_back(*p);
}

/// What the support acts on: a part, or edges.
void read_place(SceneReading& reading, const JsonValue& value, const JsonValue& what, Support& support) {
    const bool of_part = support.kind == Support::Kind::rigid || support.kind == Support::Kind::points;
    if (const JsonValue* other = find_member(value, of_part ? "on" : "part"))
        report_problem(
            reading, *other,
            "'" + other->key + "' does not go with '" + (support.kind == Support::Kind::points ? "at" : what.key) + "'",
            of_part ? "name the 'part'" : "select edges by 'on'");
    else if (of_part)
        support.part = required_member(reading, value, "part", read_part_name).value_or("");
    else
        support.on = required_member(reading, value, "on", read_selection).value_or(Selection{});
}

std::optional<Support> read_support(SceneReading& reading, const JsonValue& value) {
    const std::size_t before = reading.problems.size();
    if (!check_object(reading, value, {"on", "fix", "displacement", "symmetry", "roller", "part", "rigid", "at", "spring"}))
        return std::nullopt;
    if (reading.problems.size() > before) return std::nullopt;
    const JsonValue* what = exactly_one(reading, value, {"fix", "displacement", "symmetry", "roller", "rigid", "spring"});
    if (!what) return std::nullopt;
    Support support;
    support.where = value.pointer;
    if (what->key == "fix") read_fix(reading, *what, support);
    if (what->key == "displacement") read_displacement(reading, *what, support);
    if (what->key == "symmetry" || what->key == "roller") read_symmetry(reading, *what, support);
    if (what->key == "rigid") read_rigid(reading, *what, support);
    if (what->key == "spring") read_spring(reading, *what, support);
    if (const JsonValue* points = find_member(value, "at")) read_points(reading, *points, *what, support);
    read_place(reading, value, *what, support);
    if (reading.problems.size() > before) return std::nullopt;
    return support;
}

}  // namespace

std::vector<Support> read_supports(SceneReading& reading, const JsonValue& supports) {
    std::vector<Support> result;
    if (!check_list(reading, supports, 0, "supports")) return result;
    for (const JsonValue& item : supports.items) {
        if (auto support = read_support(reading, item)) result.push_back(std::move(*support));
    }
    return result;
}

}  // namespace abut
