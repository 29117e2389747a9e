// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/read_materials.hpp"

#include <algorithm>
#include <cctype>
#include <limits>
#include <utility>

#include "src/io/nearest_name.hpp"

namespace abut {

namespace {

bool is_identifier(const std::string& name) {
    const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    const auto rest = [&](char c) { return letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0; };
    return !name.empty() && letter(name[0]) && std::all_of(name.begin(), name.end(), rest);
}

/// Names that mean something in expressions already.
bool is_taken(const std::string& name) {
    static const std::vector<std::string> taken{"pi",  "x",    "y",    "sqrt",  "exp", "log", "sin", "cos",
                                                "tan", "asin", "acos", "atan2", "min", "max", "abs"};
    return std::find(taken.begin(), taken.end(), name) != taken.end();
}

void check_poisson(SceneReading& reading, const JsonValue& value, double nu, Analysis analysis) {
    const bool stress = analysis == Analysis::plane_stress;
    if (nu > -1 && (nu < 0.5 || (stress && nu == 0.5))) return;
    report_problem(reading, value,
                   stress ? "Poisson's ratio must be greater than -1 and at most 0.5 in plane stress"
                          : "Poisson's ratio must be greater than -1 and less than 0.5 in plane strain and around an axis");
}

std::optional<double> read_density(SceneReading& reading, const JsonValue& value) {
    const std::optional<double> number = read_number(reading, value, dimension::density);
    if (number && *number < 0) report_problem(reading, value, "'" + value.key + "' must not be negative");
    return number;
}

Material read_material(SceneReading& reading, const JsonValue& value, Analysis analysis) {
    Material material;
    material.name = value.key;
    if (!check_object(reading, value, {{"E", "nu", "density", "expansion", "yield"}, {}})) return material;
    material.E = required_member(reading, value, "E", read_positive, dimension::stress).value_or(1);
    material.nu = required_member(reading, value, "nu", read_number, dimension::none).value_or(0);
    if (const JsonValue* nu = find_member(value, "nu")) check_poisson(reading, *nu, material.nu, analysis);
    material.density = member_or(reading, value, "density", 0.0, read_density);
    material.has_density = find_member(value, "density") != nullptr;
    if (const JsonValue* expansion = find_member(value, "expansion"))
        material.expansion = read_number(reading, *expansion, dimension::expansion);
    if (const JsonValue* yield = find_member(value, "yield"))
        material.yield = read_positive(reading, *yield, dimension::stress);
    return material;
}

}  // namespace

void read_parameters(SceneReading& reading, const JsonValue& parameters) {
    if (parameters.kind != JsonValue::Kind::object) {
        report_problem(reading, parameters, "expected an object of named numbers, found " + described(parameters));
        return;
    }
    for (const JsonValue& item : parameters.items) {
        if (!is_identifier(item.key)) {
            report_problem(reading, item, "'" + shortened(item.key) + "' cannot name a parameter",
                           "use letters, digits and _, beginning with a letter");
        } else if (is_taken(item.key)) {
            report_problem(reading, item, "'" + item.key + "' has a meaning in expressions already",
                           "give the parameter another name");
        } else if (const auto given = reading.replaced.find(item.key); given != reading.replaced.end()) {
            reading.parameters[item.key] = given->second;
        } else if (const std::optional<double> number = read_parameter(reading, item)) {
            reading.parameters[item.key] = *number;
        } else {
            // Already reported; a value keeps those that refer to it from being reported too, and edges of parts that this
            // value does not make.
            reading.parameters[item.key] = 1;
            reading.all_parts_named = false;
        }
    }
}

Material built_in_rigid() {
    Material rigid;
    rigid.name = "rigid";
    rigid.rigid = true;
    rigid.E = std::numeric_limits<double>::infinity();
    rigid.has_density = true;  // weightless: it has none to give
    return rigid;
}

std::vector<Material> read_materials(SceneReading& reading, const JsonValue& materials, Analysis analysis) {
    std::vector<Material> result;
    if (materials.kind != JsonValue::Kind::object) {
        report_problem(reading, materials, "expected an object of named materials, found " + described(materials));
        return result;
    }
    for (const JsonValue& item : materials.items) {
        if (item.key == "rigid")
            report_problem(reading, item, "'rigid' is the name of the built-in material", "give this one another name");
        result.push_back(read_material(reading, item, analysis));
    }
    return result;
}

std::optional<int> read_material_name(SceneReading& reading, const JsonValue& value, const std::vector<Material>& materials) {
    const std::optional<std::string> name = read_text(reading, value);
    if (!name) return std::nullopt;
    std::vector<std::string> known;
    for (std::size_t i = 0; i < materials.size(); ++i) {
        if (materials[i].name == *name) return static_cast<int>(i);
        if (!materials[i].rigid) known.push_back(materials[i].name);
    }
    report_problem(reading, value, "there is no material '" + shortened(*name) + "'",
                   known.empty() ? "the scene has no 'materials'" : nearest_name_hint(*name, known));
    return std::nullopt;
}

}  // namespace abut
