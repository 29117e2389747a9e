// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "geometry/sketch/sketch_views.hpp"
#include "src/io/nearest_name.hpp"
#include "src/scene/part_levels.hpp"
#include "src/scene/read_drawing.hpp"
#include "src/scene/read_materials.hpp"
#include "src/scene/read_parts.hpp"

namespace abut {

namespace {

/// What the assembly says about one layer (block, colour), or about one of the parts there.
struct PartRule {
    const JsonValue* at = nullptr;
    bool ignore = false;
    std::optional<std::string> name;
    std::optional<int> material;
    std::optional<double> thickness;
    std::optional<Levels> level;
};
using PartRules = std::map<std::string, PartRule>;

PartRule read_rule(SceneReading& reading, const JsonValue& value, Scene& scene) {
    PartRule rule;
    rule.at = &value;
    if (value.kind == JsonValue::Kind::string) {
        rule.ignore = read_word(reading, value, {"ignore"}).has_value();
        return rule;
    }
    if (!check_object(reading, value, {"name", "material", "thickness", "level"})) return rule;
    if (const JsonValue* name = find_member(value, "name")) rule.name = read_new_part_name(reading, *name);
    if (const JsonValue* material = find_member(value, "material"))
        rule.material = read_material_name(reading, *material, scene);
    if (const JsonValue* thickness = find_member(value, "thickness"))
        rule.thickness = read_positive(reading, *thickness, dimension::length);
    if (const JsonValue* level = find_member(value, "level")) rule.level = read_levels(reading, *level);
    return rule;
}

PartRules read_rules(SceneReading& reading, const JsonValue& assembly, Scene& scene) {
    PartRules rules;
    const JsonValue* parts = find_member(assembly, "parts");
    if (!parts) return rules;
    if (parts->kind != JsonValue::Kind::object) {
        report_problem(reading, *parts, "expected an object with a key for each layer, found " + described(*parts));
        return rules;
    }
    for (const JsonValue& item : parts->items) rules[item.key] = read_rule(reading, item, scene);
    return rules;
}

const PartRule* find_rule(const PartRules& rules, const std::string& name) {
    const auto rule = rules.find(name);
    return rule == rules.end() ? nullptr : &rule->second;
}

/// What holds for one part of the drawing: its own rule's word first, then its layer's.
struct PartPlan {
    std::string name;
    bool ignore = false;
    std::optional<int> material;
    std::optional<double> thickness;
    Levels level{};
    const JsonValue* at = nullptr;
};

PartPlan plan_part(const PartRules& rules, const std::string& part, const std::string& layer, const JsonValue& assembly) {
    PartPlan plan{part, false, {}, {}, {}, &assembly};
    // "" or "#2": a layer's new name keeps the number of the piece. An instance's part stands for itself: "PIN#1:PIN".
    const std::string piece = part.starts_with(layer) ? part.substr(layer.size()) : "";
    if (const PartRule* rule = find_rule(rules, layer)) {
        plan = {rule->name ? *rule->name + piece : part, rule->ignore, rule->material, rule->thickness,
                rule->level.value_or(Levels()),          rule->at};
    }
    const PartRule* own = part == layer ? nullptr : find_rule(rules, part);
    if (!own) return plan;
    plan.ignore = own->ignore;
    if (own->name) plan.name = *own->name;
    if (own->material) plan.material = own->material;
    if (own->thickness) plan.thickness = own->thickness;
    if (own->level) plan.level = *own->level;
    plan.at = own->at;
    return plan;
}

void check_rules_used(SceneReading& reading, const PartRules& rules, const geometry::Drawing& drawing,
                      const geometry::SketchParts& sketch) {
    std::vector<std::string> known = layers_of(drawing);
    const std::vector<std::string>& drafting = drawing.drafting_layers;
    for (const geometry::Part& part : sketch.parts) {
        if (std::find(known.begin(), known.end(), part.name) == known.end()) known.push_back(part.name);
    }
    for (const auto& [name, rule] : rules) {
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        // An ignored layer may well hold nothing but texts and dimensions, which are not read.
        if (rule.ignore) continue;
        const bool is_drafting = std::find(drafting.begin(), drafting.end(), name) != drafting.end();
        report_problem(reading, *rule.at, "the drawing has no part '" + shortened(name) + "'",
                       is_drafting ? "the layer was left out for its name, as drafting: \"keep_drafting\": true takes it"
                                   : nearest_name_hint(name, known));
    }
}

/// Material of all parts that have none of their own; -1 where the assembly names none or a wrong one.
int default_material(SceneReading& reading, const JsonValue& assembly, Scene& scene) {
    const JsonValue* name = find_member(assembly, "material");
    return name ? read_material_name(reading, *name, scene).value_or(-1) : -1;
}

ImportRecord& record_of(const ImportedDrawing& import, Imports& imports) {
    return *std::find_if(imports.records.begin(), imports.records.end(),
                         [&](const ImportRecord& r) { return r.file == import.drawing.file; });
}

/// Layers that have a material or another word of the scene's, and no part: whoever wrote that expects one.
void tell_layers_without_part(const ImportedDrawing& import, const PartRules& rules, const geometry::SketchParts& sketch,
                              Imports& imports) {
    for (const auto& [name, rule] : rules) {
        const auto is_named = [&layer = name](const geometry::Part& part) { return part.name == layer; };
        if (rule.ignore || std::find(sketch.layers.begin(), sketch.layers.end(), name) != sketch.layers.end() ||
            std::any_of(sketch.parts.begin(), sketch.parts.end(), is_named))
            continue;
        record_of(import, imports)
            .warnings.push_back({"layer '" + name + "', which has an entry in parts, bounds no part: nothing on it closes an " +
                                     "outline of its own",
                                 {0, 0},
                                 {},
                                 0,
                                 "abut inspect shows what was left out, and why; \"ignore\": true says that this is meant"});
    }
}

/// Of the parts that are not ignored, by the names that the drawing gives them.
void tell_views(const ImportedDrawing& import, const std::vector<geometry::Part>& parts, Imports& imports) {
    if (is_solid_file(import.drawing.file)) return;
    for (geometry::SketchProblem& warning : geometry::views_of_one_part(parts))
        record_of(import, imports).warnings.push_back(std::move(warning));
}

}  // namespace

void read_assembly(SceneReading& reading, Imports& imports, const JsonValue& assembly, double thickness, Scene& scene) {
    const std::size_t before = reading.problems.size();
    const bool is_object =
        check_object(reading, assembly,
                     {"file", "parts_by", "tolerance", "section", "recognise_arcs", "only_layers", "ignore_layers",
                      "leave_open", "keep_drafting", "block_outline", "regions", "material", "parts"});
    const JsonValue* file = is_object ? required(reading, assembly, "file") : nullptr;
    const ImportOptions options = is_object ? read_import_options(reading, assembly) : ImportOptions{};
    const int material = default_material(reading, assembly, scene);
    const PartRules rules = read_rules(reading, assembly, scene);

    const ImportedDrawing* import = file ? import_drawing(reading, imports, *file, options) : nullptr;
    const auto wanted = [&](const geometry::SketchEntity& entity) {
        const PartRule* rule = find_rule(rules, entity.layer);
        return !rule || !rule->ignore;
    };
    auto sketch = import ? import_parts(reading, imports, *import, *file, options, wanted) : std::nullopt;
    if (!sketch) {
        reading.all_parts_named = false;
        return;
    }
    for (const auto& [name, what] : options.regions) {
        const auto same = [&wanted = name](const geometry::SketchRegion& region) { return region.name == wanted; };
        if (std::none_of(sketch->regions.begin(), sketch->regions.end(), same))
            report_problem(reading, *find_member(*find_member(assembly, "regions"), name),
                           "the drawing has no region '" + shortened(name) + "'",
                           "abut inspect -o DIR draws them, r1 to r" + std::to_string(sketch->regions.size()));
    }
    check_rules_used(reading, rules, import->drawing, *sketch);
    if (reading.problems.size() == before) tell_layers_without_part(*import, rules, *sketch, imports);
    // With faults in the rules a part may go by another name than the one meant.
    if (reading.problems.size() > before) reading.all_parts_named = false;
    if (sketch->parts.empty())
        report_problem(reading, *file, "the drawing bounds no part", "lines and arcs must form closed loops");

    std::vector<geometry::Part> drawn;
    const bool material_given = find_member(assembly, "material") != nullptr;
    for (std::size_t i = 0; i < sketch->parts.size(); ++i) {
        geometry::Part& part = sketch->parts[i];
        PartPlan plan = plan_part(rules, part.name, sketch->layers[i], assembly);
        if (plan.ignore) continue;
        drawn.push_back(part);
        const bool own_material = find_member(*plan.at, "material") != nullptr && plan.at != &assembly;
        if (!plan.material && !own_material && !material_given) {
            report_problem(reading, *plan.at, "the part '" + plan.name + "' has no material",
                           "give the assembly a 'material', or this part one under 'parts'");
        }
        note_part_name(reading, *plan.at, plan.name);
        part.name = plan.name;
        scene.parts.push_back({plan.name,
                               std::move(part),
                               plan.material.value_or(material),
                               plan.thickness.value_or(thickness),
                               plan.at->pointer,
                               {},
                               std::move(plan.level),
                               {},
                               sketch->rounding});
    }
    tell_views(*import, drawn, imports);
}

}  // namespace abut
