// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/read_parts.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <utility>

#include "src/scene/part_levels.hpp"
#include "src/scene/read_array.hpp"
#include "src/scene/read_geometry.hpp"
#include "src/scene/read_materials.hpp"

namespace abut {

namespace {

std::optional<geometry::CsgNode> read_tree(SceneReading& reading, Imports& imports, const JsonValue& part) {
    const JsonValue* geometry = required(reading, part, "geometry");
    std::optional<geometry::CsgNode> tree = geometry ? read_geometry(reading, imports, *geometry) : std::nullopt;
    const JsonValue* place = find_member(part, "place");
    if (!place) return tree;
    if (!check_object(reading, *place, place_keys())) return std::nullopt;
    const bool complete = tree.has_value();
    auto placed = read_place(reading, *place, complete ? std::move(*tree) : geometry::CsgNode{});
    return complete ? std::move(placed) : std::nullopt;
}

void report_geometry_problem(SceneReading& reading, const JsonValue& part, const geometry::GeometryProblem& problem) {
    const JsonValue* at = problem.where.empty() ? nullptr : find_pointer(reading.root, problem.where);
    std::ostringstream what;
    what << std::setprecision(10);
    if (!at && !problem.where.empty()) what << problem.where << ": ";
    what << problem.what;
    const bool has_place = problem.at.isZero(0) || problem.what.find('(') != std::string::npos;
    if (!has_place) what << " near (" << problem.at.x() << ", " << problem.at.y() << ")";
    report_problem(reading, at ? *at : part, what.str(), problem.hint);
}

/// What the tree bounds; nothing where it bounds no part (reported).
std::optional<geometry::CsgResult> evaluated(SceneReading& reading, const JsonValue& part, const geometry::CsgNode& tree) {
    geometry::CsgResult result = geometry::evaluate(tree);
    for (const geometry::GeometryProblem& problem : result.problems) report_geometry_problem(reading, part, problem);
    if (!result.problems.empty()) return std::nullopt;
    return result;
}

/// In one line, however many there are: an analysis is to say that it solved something else than was drawn.
std::string repairs_warning(const std::string& part, const std::vector<geometry::Repair>& repairs) {
    const auto largest = std::max_element(repairs.begin(), repairs.end(),
                                          [](const geometry::Repair& a, const geometry::Repair& b) { return a.size < b.size; });
    std::ostringstream text;
    text << "part " << part << ": " << largest->what << " (size " << largest->size << ") near (" << largest->at.x() << ", "
         << largest->at.y() << ")";
    if (repairs.size() > 1) text << " and " << repairs.size() - 1 << " smaller " << (repairs.size() > 2 ? "repairs" : "repair");
    return text.str();
}

/// A part as one of the scene, or one for each copy.
struct NamedCopy {
    std::string name;
    geometry::Placed place{};
};

std::vector<NamedCopy> read_copies(SceneReading& reading, const JsonValue& part) {
    const auto name = required_member(reading, part, "name", read_new_part_name);
    const JsonValue* array = find_member(part, "array");
    std::vector<NamedCopy> copies;
    if (array)
        for (geometry::Placed& place : read_array(reading, *array))
            copies.push_back({name.value_or("") + "[" + std::to_string(copies.size()) + "]", std::move(place)});
    else
        copies.push_back({name.value_or("")});
    if (!name || copies.empty()) {
        reading.all_parts_named = false;
        return {};
    }
    for (const NamedCopy& copy : copies) note_part_name(reading, part, copy.name);
    return copies;
}

void read_part(SceneReading& reading, Imports& imports, const JsonValue& value, double thickness, Scene& scene) {
    if (!check_object(reading, value, {"name", "material", "thickness", "level", "geometry", "place", "array"})) {
        reading.all_parts_named = false;
        return;
    }
    std::vector<NamedCopy> copies = read_copies(reading, value);

    const JsonValue* material_name = required(reading, value, "material");
    const auto material = material_name ? read_material_name(reading, *material_name, scene) : std::nullopt;
    thickness = member_or(reading, value, "thickness", thickness, read_positive, dimension::length);
    Levels level = member_or(reading, value, "level", Levels(), read_levels);
    std::optional<geometry::CsgNode> read = read_tree(reading, imports, value);
    if (!read) return;
    const auto tree = std::make_shared<const geometry::CsgNode>(std::move(*read));
    const bool is_array = find_member(value, "array") != nullptr;
    if (copies.empty()) evaluated(reading, value, *tree);  // for its problems
    for (NamedCopy& copy : copies) {
        auto own = tree;
        if (is_array) {
            copy.place.of.push_back(*tree);
            own = std::make_shared<const geometry::CsgNode>(geometry::CsgNode{std::move(copy.place), "", value.pointer});
        }
        std::optional<geometry::CsgResult> result = evaluated(reading, value, *own);
        if (!result) return;
        result->part.name = copy.name;
        if (!result->repairs.empty()) scene.warnings.push_back(repairs_warning(copy.name, result->repairs));
        scene.parts.push_back({copy.name, std::move(result->part), material.value_or(-1), thickness, value.pointer,
                               std::move(result->repairs), level, std::move(own)});
    }
}

}  // namespace

void note_part_name(SceneReading& reading, const JsonValue& at, const std::string& name) {
    const auto known = std::find(reading.part_names.begin(), reading.part_names.end(), name);
    if (known == reading.part_names.end())
        reading.part_names.push_back(name);
    else
        report_problem(reading, at, "there are two parts with the name '" + name + "'", "rename one of them");
}

std::optional<std::string> read_new_part_name(SceneReading& reading, const JsonValue& value) {
    const std::optional<std::string> name = read_text(reading, value);
    if (!name || name->find_first_of("/#*") == std::string::npos) return name;
    report_problem(reading, value, "the part's name '" + *name + "' contains '/', '#' or '*'",
                   "these have a meaning where edges are selected");
    return std::nullopt;
}

void read_parts(SceneReading& reading, Imports& imports, const JsonValue& parts, double thickness, Scene& scene) {
    const std::size_t least = find_member(reading.root, "assembly") ? 0 : 1;
    if (!check_list(reading, parts, least, "parts")) {
        reading.all_parts_named = false;
        return;
    }
    for (const JsonValue& part : parts.items) read_part(reading, imports, part, thickness, scene);
}

}  // namespace abut
