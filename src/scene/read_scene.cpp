// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a scene top down. Order matters: units come before parameters, these before all other numbers, parts before all that
// names parts.
#include "src/scene/read_scene.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "src/io/json_document.hpp"
#include "src/io/nearest_name.hpp"
#include "src/scene/dissertation_method.hpp"
#include "src/scene/read_accuracy.hpp"
#include "src/scene/read_cases.hpp"
#include "src/scene/read_contacts.hpp"
#include "src/scene/read_drawing.hpp"
#include "src/scene/read_materials.hpp"
#include "src/scene/read_output.hpp"
#include "src/scene/read_parts.hpp"
#include "src/scene/read_selection.hpp"
#include "src/scene/read_supports_loads.hpp"
#include "src/scene/scene.hpp"
#include "src/scene/scene_fields.hpp"

namespace abut {

namespace {

/// Problems beyond this number are counted, not printed.
constexpr std::size_t reported_problems = 20;

void read_version(SceneReading& reading) {
    const JsonValue* version = find_member(reading.root, "abut");
    if (!version) {
        report_problem(reading, reading.root, "the key 'abut' is missing", "a scene states its format version: \"abut\": 1");
    } else if (version->kind != JsonValue::Kind::number || version->number != 1) {
        report_problem(reading, *version, "this format version is not known", "write \"abut\": 1");
    }
}

void read_units(SceneReading& reading, const JsonValue& units, Scene& scene) {
    if (!check_object(reading, units, {"length", "force"})) return;
    scene.length_unit = reading.units.length = member_or(reading, units, "length", std::string(), read_text);
    scene.force_unit = reading.units.force = member_or(reading, units, "force", std::string(), read_text);
}

void read_general(SceneReading& reading, Scene& scene) {
    const JsonValue& root = reading.root;
    if (const JsonValue* schema = find_member(root, "$schema")) read_text(reading, *schema);  // for editors alone
    const JsonValue* title = find_member(root, "title");
    if (title && title->kind != JsonValue::Kind::string)
        report_problem(reading, *title, "expected a text, found " + described(*title));
    if (title) scene.title = title->text;
    if (const JsonValue* analysis = find_member(root, "analysis")) {
        const auto word = read_word(reading, *analysis, {"plane_stress", "plane_strain", "axisymmetric"});
        if (word == "plane_strain") scene.analysis = Analysis::plane_strain;
        if (word == "axisymmetric") scene.analysis = Analysis::axisymmetric;
    }
    if (const JsonValue* motion = find_member(root, "motion"))
        scene.follows_motion = read_word(reading, *motion, {"auto", "off"}) != "off";
}

void read_all_parts(SceneReading& reading, Scene& scene) {
    const JsonValue& root = reading.root;
    const JsonValue* parts = find_member(root, "parts");
    const JsonValue* assembly = find_member(root, "assembly");
    if (!parts && !assembly) {
        report_problem(reading, root, "the scene has no parts", "give 'parts' or 'assembly'");
        reading.all_parts_named = false;
    }
    Imports imports;
    imports.length_unit = scene.length_unit;
    const double thickness = member_or(reading, root, "thickness", 1.0, read_positive, dimension::length);
    if (parts) read_parts(reading, imports, *parts, thickness, scene);
    if (assembly) read_assembly(reading, imports, *assembly, thickness, scene);
    scene.imports = std::move(imports.records);
    geometry::Box2 all;
    for (const ScenePart& part : scene.parts) all.extend(bounding_box(part.part));
    for (ScenePart& part : scene.parts)
        if (part.tree) part.rounding = geometry::written_rounding(*part.tree, all.diagonal());
    for (const ImportRecord& record : scene.imports) {
        if (record.unit.empty() && !scene.length_unit.empty())
            scene.warnings.push_back(record.file + ": the file states no unit of length; its numbers are taken as " +
                                     scene.length_unit);
        for (const geometry::SketchProblem& warning : record.warnings)
            scene.warnings.push_back(warning_text(record.file, warning));
    }
}

/// The dissertation's method has contact by penalty alone, searched on its grid.
void refuse_contact_keys(SceneReading& reading) {
    const JsonValue* contacts = find_member(reading.root, "contacts");
    if (!contacts || contacts->kind != JsonValue::Kind::object) return;
    const JsonValue* formulation = find_member(*contacts, "formulation");
    if (formulation && formulation->text == "mortar")
        report_problem(reading, *formulation, "mortar contact does not go with the dissertation's method",
                       "its contact is by penalty: leave the formulation out");
    if (const JsonValue* distance = find_member(*contacts, "search_distance"))
        report_problem(reading, *distance, "'search_distance' does not go with the dissertation's method",
                       "it searches the cells of one grid: leave the distance out, and give accuracy.cell_size");
}

void read_sections(SceneReading& reading, Scene& scene) {
    const JsonValue& root = reading.root;
    if (const JsonValue* supports = find_member(root, "supports")) scene.supports = read_supports(reading, *supports);
    if (const JsonValue* loads = find_member(root, "loads")) scene.loads = read_loads(reading, *loads);
    const JsonValue *cases = find_member(root, "cases"), *steps = find_member(root, "steps");
    if (cases && steps)
        report_problem(reading, *steps, "a scene has load cases or steps, not both",
                       "cases do not know of each other; steps follow each other, and friction remembers");
    scene.in_steps = steps && !cases;
    if (cases || steps) read_cases(reading, cases ? *cases : *steps, scene);
    if (const JsonValue* contacts = find_member(root, "contacts"))
        scene.contacts = read_contacts(reading, *contacts, scene.warnings);
    if (const JsonValue* accuracy = find_member(root, "accuracy")) scene.accuracy = read_accuracy(reading, *accuracy);
    if (is_by_dissertation(scene)) {
        refuse_contact_keys(reading);
        take_dissertation_method(scene);
    }
    refuse_friction_where_unknown(reading, scene);
    if (const JsonValue* output = find_member(root, "output")) scene.output = read_output(reading, *output);
    if (const JsonValue* expect = find_member(root, "expect")) scene.expect = read_expectations(reading, *expect);
    check_cases_of_expectations(reading, scene);
}

/// Thicknesses have no meaning around an axis, where the full circle takes their place, nor levels.
void check_thickness(SceneReading& reading, Scene& scene) {
    if (scene.analysis != Analysis::axisymmetric) return;
    const auto refuse = [&](const JsonValue& in) {
        if (in.kind != JsonValue::Kind::object) return;
        if (const JsonValue* thickness = find_member(in, "thickness"))
            report_problem(reading, *thickness, "parts around an axis have no thickness",
                           "forces are totals over the full circle");
        if (const JsonValue* level = find_member(in, "level"))
            report_problem(reading, *level, "parts around an axis have no levels",
                           "their sections cannot lie above each other");
    };
    refuse(reading.root);
    if (const JsonValue* parts = find_member(reading.root, "parts"))
        for (const JsonValue& part : parts->items) refuse(part);
    const JsonValue* assembly = find_member(reading.root, "assembly");
    if (const JsonValue* rules = assembly ? find_member(*assembly, "parts") : nullptr)
        for (const JsonValue& rule : rules->items) refuse(rule);
    for (ScenePart& part : scene.parts) part.thickness = full_circle;
}

/// A slip in units is no error: the scene may mean it.
void check_units(const SceneReading& reading, Scene& scene) {
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        const auto is_of_it = [&](const ScenePart& part) { return part.material == static_cast<int>(m); };
        if (std::none_of(scene.parts.begin(), scene.parts.end(), is_of_it)) continue;
        for (const auto& implausible : {implausible_stiffness, implausible_density})
            if (const std::string doubt = implausible(scene.materials[m], reading.units); !doubt.empty())
                scene.warnings.push_back(doubt);
    }
    for (const Load& load : scene.loads) {
        const bool has_factor = !load.name.empty() && !scene.cases.empty();
        if (load.kind != Load::Kind::gravity || has_factor || !load.value[0].is_constant() || !load.value[1].is_constant())
            continue;
        const double gravity = std::hypot(load.value[0].constant(), load.value[1].constant());
        if (const std::string doubt = implausible_gravity(gravity, reading.units); !doubt.empty())
            scene.warnings.push_back(load.where + ": " + doubt);
    }
}

/// A plane part spins about a point, a part around an axis about that.
void check_spin_about(SceneReading& reading, const Scene& scene, const Load& load) {
    const JsonValue& spin = *find_member(*find_pointer(reading.root, load.where), "spin");
    const JsonValue* about = find_member(spin, "about");
    const bool is_ring = scene.analysis == Analysis::axisymmetric;
    if (about && is_ring)
        report_problem(reading, *about, "axisymmetric parts spin about the axis x = 0 alone", "leave 'about' out");
    if (!about && !is_ring)
        report_problem(reading, spin, "the key 'about' is missing", "give the point [x, y] that the part spins about");
}

/// What a load needs of the materials of the parts that it acts on (which may be given as 0).
void check_needed(SceneReading& reading, const Scene& scene, const Load& load, const std::string& effect,
                  const std::string& key, bool (*has)(const Material&)) {
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        bool used = false;
        for (const ScenePart& part : scene.parts)
            used |= part.material == static_cast<int>(m) && (load.part.empty() || load.part == part.name);
        if (!used || has(scene.materials[m])) continue;
        report_problem(
            reading, *find_pointer(reading.root, load.where),
            effect + " needs the '" + key + "' of the material '" + scene.materials[m].name + "'",
            "give the material " + std::string(key == "density" ? "a" : "an") + " '" + key + "', or 0 for no effect on it");
    }
}

void check_materials_of_loads(SceneReading& reading, const Scene& scene) {
    const auto has_density = [](const Material& m) { return m.has_density; };
    const auto has_expansion = [](const Material& m) { return m.expansion.has_value(); };
    const Load* gravity = nullptr;
    for (const Load& load : scene.loads) {
        if (load.kind == Load::Kind::gravity) gravity = &load;
        if (load.kind == Load::Kind::spin) check_spin_about(reading, scene, load);
        if (load.kind == Load::Kind::spin) check_needed(reading, scene, load, "spin", "density", has_density);
        if (load.kind == Load::Kind::temperature) check_needed(reading, scene, load, "temperature", "expansion", has_expansion);
    }
    if (gravity) check_needed(reading, scene, *gravity, "gravity", "density", has_density);
}

/// Parameters given from outside must be the scene's own.
void check_replaced(SceneReading& reading) {
    std::vector<std::string> known;
    for (const auto& [name, value] : reading.parameters) known.push_back(name);
    for (const auto& [name, value] : reading.replaced)
        if (!reading.parameters.contains(name))
            report_problem(reading, reading.root, "there is no parameter '" + shortened(name) + "'",
                           nearest_name_hint(name, known));
}

/// A key of former scenes.
void refuse_symmetry(SceneReading& reading) {
    const JsonValue* symmetry = reading.root.kind == JsonValue::Kind::object ? find_member(reading.root, "symmetry") : nullptr;
    if (!symmetry) return;
    report_problem(reading, *symmetry, "every part is solved as drawn: no half of a symmetric scene is solved alone any more",
                   "leave \"symmetry\" out; the answer is the same");
    std::erase_if(reading.root.items, [](const JsonValue& item) { return item.key == "symmetry"; });
}

[[noreturn]] void throw_problems(std::vector<Problem> problems) {
    const std::size_t n = problems.size();
    if (n > reported_problems) {
        problems.resize(reported_problems);
        problems.push_back({"", "and " + std::to_string(n - reported_problems) + " more problems", ""});
    }
    throw InputError(std::move(problems));
}

Scene scene_of(JsonDocument document, const std::map<std::string, double>& replaced, const std::string& given_file = {}) {
    SceneReading reading{document.file, std::move(document.root), {}, std::move(document.problems), {}, true, replaced, {}, {},
                         given_file};
    Scene scene;
    scene.file = document.file;
    refuse_symmetry(reading);
    const Words keys{"$schema",   "abut",   "title",    "units",    "analysis", "thickness", "parameters",
                     "materials", "parts",  "assembly", "supports", "loads",    "cases",     "steps",
                     "contacts",  "motion", "accuracy", "output",   "expect"};
    if (!check_object(reading, reading.root, keys)) throw_problems(std::move(reading.problems));
    read_version(reading);
    if (const JsonValue* units = find_member(reading.root, "units")) read_units(reading, *units, scene);
    if (const JsonValue* parameters = find_member(reading.root, "parameters")) read_parameters(reading, *parameters);
    check_replaced(reading);
    read_general(reading, scene);
    if (const JsonValue* materials = find_member(reading.root, "materials")) {
        scene.materials = read_materials(reading, *materials, scene.analysis);
    }
    scene.materials.push_back(built_in_rigid());
    read_all_parts(reading, scene);
    drop_unused_rigid(scene);
    check_thickness(reading, scene);
    read_sections(reading, scene);
    check_units(reading, scene);
    // Edges can be looked up only where every part has its geometry.
    if (scene.parts.size() == reading.part_names.size() && reading.all_parts_named) check_selections(reading, scene);
    check_materials_of_loads(reading, scene);
    if (!reading.problems.empty()) throw_problems(std::move(reading.problems));
    return scene;
}

JsonDocument read_document(const std::string& path) {
    if (is_importable(path) && std::filesystem::exists(path))
        throw InputError(path, "this is a drawing or a solid, not a scene: it says nothing of materials, supports and loads",
                         "abut init FILE > scene.json begins a scene with it; abut inspect FILE shows what is in it");
    return read_json(path);
}

}  // namespace

Scene read_scene(const std::string& path) {
    return scene_of(read_document(path), {});
}

Scene read_scene(const std::string& path, const std::map<std::string, double>& parameters) {
    return scene_of(read_document(path), parameters);
}

Scene read_scene(const std::string& path, const std::map<std::string, double>& parameters, const std::string& file) {
    return scene_of(read_document(path), parameters, file);
}

std::vector<ParameterRange> parameter_ranges(const std::string& path) {
    JsonDocument document = read_document(path);
    SceneReading reading{document.file, std::move(document.root), {}, std::move(document.problems), {}};
    Scene named;
    if (const JsonValue* units = find_member(reading.root, "units")) read_units(reading, *units, named);
    if (const JsonValue* parameters = find_member(reading.root, "parameters")) read_parameters(reading, *parameters);
    if (!reading.problems.empty()) throw_problems(std::move(reading.problems));
    return reading.ranges;
}

Scene read_scene_text(const std::string& text, const std::string& file) {
    return scene_of(parse_json(text, file), {});
}

}  // namespace abut
