// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/read_materials.hpp"

#include <algorithm>
#include <cctype>
#include <limits>
#include <utility>

#include "src/io/nearest_name.hpp"
#include "src/io/number_text.hpp"
#include "src/scene/material_library.hpp"

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

Material material_of(SceneReading& reading, const JsonValue& value, Analysis analysis) {
    Material material;
    material.name = value.key;
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

Material read_material(SceneReading& reading, const JsonValue& value, Analysis analysis) {
    if (check_object(reading, value, {"E", "nu", "density", "expansion", "yield"}))
        return material_of(reading, value, analysis);
    Material wrong;
    wrong.name = value.key;
    return wrong;
}

/// Near names of the scene first, then those of the library.
std::string material_hint(const std::string& name, std::vector<std::string> known) {
    const std::string hint = nearest_name_hint(name, known);
    if (hint.starts_with("did you mean")) return hint;
    for (std::string& of_library : library_material_names())
        if (std::find(known.begin(), known.end(), of_library) == known.end()) known.push_back(std::move(of_library));
    return nearest_name_hint(name, known);
}

/// "steel: E = 210 GPa (EN 1993-1-1), nu = 0.3 (typical), ...".
std::string library_note(const std::string& name, const JsonValue& material) {
    std::string text, source;
    const JsonValue* sources = find_member(material, "sources");
    for (const JsonValue& from : sources->items) {
        const JsonValue& value = *find_member(material, from.key);
        const std::string number = value.kind == JsonValue::Kind::string ? value.text : number_text(value.number, 6);
        // One source of several values is said once, behind the last of them.
        if (!text.empty()) text += (from.text == source ? "" : " (" + source + ")") + std::string(", ");
        text += from.key + " = " + number;
        source = from.text;
    }
    return "material " + name + " from the library, " + find_member(material, "about")->text + ": " + text + " (" + source +
           ")";
}

/// The library's material becomes one of the scene's, in its units.
std::optional<int> take_from_library(SceneReading& reading, const JsonValue& at, Scene& scene) {
    if (!knows_stress(reading.units)) {
        report_problem(
            reading, at, "the scene defines no material '" + at.text + "', and the library's needs units to be converted into",
            R"(give the scene its "units", for instance {"length": "mm", "force": "N"}, or the material under 'materials')");
        return std::nullopt;
    }
    scene.materials.push_back(material_from_library(at.text, reading.units));
    scene.notes.push_back(library_note(at.text, *library_material(at.text)));
    return static_cast<int>(scene.materials.size()) - 1;
}

/// A parameter's value: a number, or what an object with a range calls so.
std::optional<double> read_with_range(SceneReading& reading, const JsonValue& item) {
    if (item.kind != JsonValue::Kind::object) return read_parameter(reading, item);
    if (!check_object(reading, item, {"value", "min", "max"})) return std::nullopt;
    const JsonValue* given = required(reading, item, "value");
    if (!given) return std::nullopt;
    JsonValue value = *given;
    value.key = item.key;  // by which its dimension is noted
    const std::optional<double> number = read_parameter(reading, value);
    const std::optional<double> least = required_member(reading, item, "min", read_of_any_dimension);
    const std::optional<double> most = required_member(reading, item, "max", read_of_any_dimension);
    if (!number || !least || !most) return std::nullopt;
    if (*least >= *most)
        report_problem(reading, item, "'min' is not below 'max'", "give the smallest value as 'min'");
    else if (*number < *least || *number > *most)
        report_problem(reading, *given, "the value is not between 'min' and 'max'", "give one in between, or other ends");
    reading.ranges.push_back({item.key, *number, *least, *most, item.pointer});
    return number;
}

/// A unit in those of the scene; nothing where the scene names none.
std::optional<double> known_factor(const char* unit, const Dimension& dimension, const SceneUnits& units) {
    try {
        return unit_factor(unit, dimension, units);
    } catch (const InputError&) { return std::nullopt; }
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
        } else if (const std::optional<double> number = read_with_range(reading, item)) {
            const auto given = reading.replaced.find(item.key);  // in the scene's units, of the same dimension
            reading.parameters[item.key] = given != reading.replaced.end() ? given->second : *number;
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

std::optional<int> read_material_name(SceneReading& reading, const JsonValue& value, Scene& scene) {
    const std::optional<std::string> name = read_text(reading, value);
    if (!name) return std::nullopt;
    std::vector<std::string> known;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        if (scene.materials[i].name == *name) return static_cast<int>(i);
        if (!scene.materials[i].rigid) known.push_back(scene.materials[i].name);
    }
    if (library_material(*name)) return take_from_library(reading, value, scene);
    report_problem(reading, value, "there is no material '" + shortened(*name) + "'", material_hint(*name, known));
    return std::nullopt;
}

void drop_unused_rigid(Scene& scene) {
    const auto rigid = std::find_if(scene.materials.begin(), scene.materials.end(), [](const Material& m) { return m.rigid; });
    const int index = static_cast<int>(rigid - scene.materials.begin());
    const auto is_of_it = [&](const ScenePart& part) { return part.material == index; };
    if (std::any_of(scene.parts.begin(), scene.parts.end(), is_of_it)) return;
    scene.materials.erase(rigid);
    for (ScenePart& part : scene.parts) part.material -= part.material > index ? 1 : 0;
}

bool knows_stress(const SceneUnits& units) {
    return known_factor("Pa", dimension::stress, units).has_value();
}

Material material_from_library(const std::string& name, const SceneUnits& units) {
    const JsonValue* entry = library_material(name);
    if (!entry)
        throw InputError("", "the library has no material '" + shortened(name) + "'",
                         nearest_name_hint(name, library_material_names()));
    SceneReading reading{};
    reading.units = units;
    Material material = material_of(reading, *entry, Analysis::plane_stress);
    if (!reading.problems.empty()) throw InputError(std::move(reading.problems));
    material.name = name;
    return material;
}

std::string implausible_stiffness(const Material& material, const SceneUnits& units) {
    constexpr double softest = 1e5, stiffest = 1.2e12;  // Pa: soft rubber, diamond
    const std::optional<double> pascal = known_factor("Pa", dimension::stress, units);
    if (material.rigid || !pascal) return "";
    const double pascals = material.E / *pascal;
    if (pascals >= softest && pascals <= stiffest) return "";
    return "material " + material.name + ": E = " + number_text(material.E, 6) + " is " + number_text(1e-9 * pascals, 4) +
           " GPa in the scene's units (" + units.length + ", " + units.force +
           "), and materials have 0.0001 to 1200 GPa: check E, or write it with its unit (\"210 GPa\")";
}

std::string implausible_density(const Material& material, const SceneUnits& units) {
    constexpr double lightest = 1, heaviest = 23000;  // kg/m^3: aerogel, osmium
    const std::optional<double> unit = known_factor("kg/m^3", dimension::density, units);
    if (material.density == 0 || !unit) return "";
    const double density = material.density / *unit;
    if (density >= lightest && density <= heaviest) return "";
    return "material " + material.name + ": a density of " + number_text(material.density, 6) + " is " +
           number_text(density, 3) + " kg/m^3 in the scene's units (" + units.length + ", " + units.force +
           "), and materials have 1 to 23000 kg/m^3: check it, or write it with its unit (\"7850 kg/m^3\")";
}

std::string implausible_gravity(double gravity, const SceneUnits& units) {
    constexpr double weakest = 0.1;  // m/s^2: less than on Ceres
    const std::optional<double> unit = known_factor("m/s^2", dimension::acceleration, units);
    if (gravity == 0 || !unit || gravity >= weakest * *unit) return "";
    return "a gravity of " + number_text(gravity, 4) + " is " + number_text(gravity / *unit, 3) +
           " m/s^2 in the scene's units (" + units.length + "): check it, or write it with its unit (\"9.81 m/s^2\")";
}

}  // namespace abut
