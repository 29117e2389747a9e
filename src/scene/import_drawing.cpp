// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/import_drawing.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "src/io/nearest_name.hpp"
#include "src/io/number_text.hpp"
#include "src/scene/read_drawing.hpp"
#include "src/scene/read_scene.hpp"
#include "src/scene/scene_words.hpp"

namespace abut {

namespace {

using geometry::Drawing;

void scale(Drawing& drawing, double factor) {
    geometry::Similarity larger;
    larger.scale = factor;
    drawing.factor = factor;
    for (geometry::SketchEntity& entity : drawing.entities) entity.curve = transformed(entity.curve, larger);
    for (geometry::SketchProblem& problem : drawing.problems) problem.at *= factor;
    for (geometry::SketchProblem& warning : drawing.warnings) warning.at *= factor;
    for (Vec2& tip : drawing.arrows) tip *= factor;
    for (geometry::DrawnText& text : drawing.texts) {
        text.at *= factor;
        text.height *= factor;
    }
    for (geometry::Hatch& hatch : drawing.hatches)
        for (std::vector<geometry::Curve>& loop : hatch.loops)
            for (geometry::Curve& curve : loop) curve = transformed(curve, larger);
    for (geometry::Repair& repair : drawing.repairs) {
        repair.at *= factor;
        repair.size *= factor;
    }
}

/// Nothing is converted unless both sides state a unit.
std::optional<double> factor_to_scene(SceneReading& reading, const Imports& imports, const Drawing& drawing,
                                      const JsonValue& at) {
    if (drawing.unit.empty() || imports.length_unit.empty() || drawing.unit == imports.length_unit) return 1;
    const double factor = geometry::unit_factor(drawing.unit, imports.length_unit);
    if (factor > 0) return factor;
    report_problem(
        reading, at,
        "the drawing is in '" + drawing.unit + "', the scene in '" + imports.length_unit + "': no conversion is known",
        "units are um, mm, cm, m, in, ft");
    return std::nullopt;
}

void report_sketch_problem(SceneReading& reading, const JsonValue& at, const Drawing& drawing,
                           const geometry::SketchProblem& problem) {
    std::string what = problem.what;
    if (!problem.entity.empty() && what.find(problem.entity) == std::string::npos) what += " (" + problem.entity + ")";
    what += ", in " + drawing.file;
    if (problem.line > 0) what += ":" + std::to_string(problem.line);
    report_problem(reading, at, what, problem.hint);
}

/// One record for each file, however many parts take something from it.
void add_record(Imports& imports, ImportRecord record) {
    for (ImportRecord& known : imports.records) {
        if (known.file != record.file) continue;
        for (geometry::Repair& repair : record.repairs) {  // those of the file itself come with every part of it
            const auto same = [&](const geometry::Repair& r) { return r.what == repair.what && r.at == repair.at; };
            if (std::none_of(known.repairs.begin(), known.repairs.end(), same)) known.repairs.push_back(std::move(repair));
        }
        for (geometry::SketchProblem& warning : record.warnings) {
            const auto same = [&](const geometry::SketchProblem& w) { return w.what == warning.what && w.at == warning.at; };
            if (std::none_of(known.warnings.begin(), known.warnings.end(), same)) known.warnings.push_back(std::move(warning));
        }
        return;
    }
    imports.records.push_back(std::move(record));
}

}  // namespace

std::vector<std::string> layers_of(const Drawing& drawing) {
    std::vector<std::string> layers;
    for (const geometry::SketchEntity& entity : drawing.entities) {
        if (std::find(layers.begin(), layers.end(), entity.layer) == layers.end()) layers.push_back(entity.layer);
    }
    return layers;
}

ImportRecord import_record(const Drawing& drawing, double factor, std::vector<geometry::Repair> repairs,
                           const std::vector<geometry::SketchProblem>& warnings) {
    repairs.insert(repairs.begin(), drawing.repairs.begin(), drawing.repairs.end());
    std::vector<geometry::SketchProblem> all = drawing.warnings;
    all.insert(all.end(), warnings.begin(), warnings.end());
    return {drawing.file,   drawing.format,  drawing.unit,       factor,
            drawing.counts, drawing.ignored, std::move(repairs), std::move(all)};
}

namespace {

std::string key_of(const std::string& name, const ImportOptions& options) {
    constexpr int all_digits = 17;
    std::string layers;
    for (const std::string& pattern : options.layers.only) layers += "+" + pattern;
    for (const std::string& pattern : options.layers.ignore) layers += "-" + pattern;
    std::string key = name + "|" + layers + "|" + std::to_string(options.section.axis) + "|" +
                      number_text(options.tolerance, all_digits) + "|" + std::to_string(options.recognise_arcs);
    return options.section.at ? key + "|" + number_text(*options.section.at, all_digits) : key;
}

/// {"axis": "z", "at": 0}; both may be left out.
void read_section(SceneReading& reading, const JsonValue& section, ImportOptions& options) {
    if (!check_object(reading, section, {"axis", "at"})) return;
    if (const JsonValue* axis = find_member(section, "axis")) {
        const auto word = read_word(reading, *axis, {"x", "y", "z"});
        if (word) options.section.axis = static_cast<int>(std::string("xyz").find(*word));
    }
    if (const JsonValue* at = find_member(section, "at"))
        options.section.at = read_number(reading, *at, dimension::none);  // in the file's unit
}

std::vector<std::string> read_texts(SceneReading& reading, const JsonValue& object, const char* key) {
    std::vector<std::string> texts;
    const JsonValue* list = find_member(object, key);
    if (!list) return texts;
    if (list->kind != JsonValue::Kind::array) {
        report_problem(reading, *list, "expected a list of texts, found " + described(*list));
        return texts;
    }
    for (const JsonValue& item : list->items)
        if (const auto text = read_text(reading, item)) texts.push_back(*text);
    return texts;
}

/// {"r3": "PIN", "r4": "void"}
void read_regions(SceneReading& reading, const JsonValue& regions, ImportOptions& options) {
    if (regions.kind != JsonValue::Kind::object) {
        report_problem(reading, regions, "expected an object with a key for each region, found " + described(regions));
        return;
    }
    for (const JsonValue& item : regions.items)
        if (const auto text = read_text(reading, item)) options.regions[item.key] = *text;
}

bool matches_block(const geometry::SketchEntity& entity, const std::string& name) {
    return entity.block == name || entity.instance == name || entity.block.substr(entity.block.rfind('/') + 1) == name;
}

std::vector<std::string> blocks_of(const Drawing& drawing) {
    std::vector<std::string> blocks;
    for (const geometry::SketchEntity& entity : drawing.entities)
        for (const std::string& name : {entity.block.substr(entity.block.rfind('/') + 1), entity.instance})
            if (!name.empty() && std::find(blocks.begin(), blocks.end(), name) == blocks.end()) blocks.push_back(name);
    return blocks;
}

/// A name that must be one of the known ones; empty where the key is not there, or wrong (reported).
std::string read_choice(SceneReading& reading, const JsonValue& node, const char* key, const std::string& what,
                        const std::vector<std::string>& known) {
    const JsonValue* value = find_member(node, key);
    const std::string name = value ? member_or(reading, node, key, std::string(), read_text) : "";
    if (!value || std::find(known.begin(), known.end(), name) != known.end()) return name;
    report_problem(reading, *value, "the file has no " + what + " '" + shortened(name) + "' with anything to read",
                   nearest_name_hint(name, known));
    return "";
}

std::optional<geometry::Imported> the_only_part(SceneReading& reading, const JsonValue& node,
                                                std::optional<geometry::SketchParts> sketch, const std::string& choose) {
    if (!sketch) return std::nullopt;
    if (sketch->parts.size() == 1) return geometry::Imported{std::move(sketch->parts.front()), sketch->rounding};
    std::vector<std::string> names;
    for (const geometry::Part& part : sketch->parts) names.push_back(part.name);
    report_problem(reading, node,
                   "the file bounds " + std::to_string(names.size()) + " parts here, not one" +
                       (names.empty() ? "" : ": " + listed(names)),
                   "choose one by " + choose + ", or use 'assembly'");
    return std::nullopt;
}

/// Where the file is that a scene calls by this name.
std::string path_of(const SceneReading& reading, const std::string& name) {
    if (name != any_file) return (std::filesystem::path(reading.file).parent_path() / name).string();
    if (!reading.given_file.empty()) return reading.given_file;
    throw InputError("", "this scene is a template, whose file '" + name + "' stands for any drawing or mesh",
                     "use it by abut batch SOURCE --template, or name a file");
}

}  // namespace

const ImportedDrawing* import_drawing(SceneReading& reading, Imports& imports, const JsonValue& file,
                                      const ImportOptions& options) {
    const std::optional<std::string> name = read_text(reading, file);
    if (!name) return nullptr;
    const std::string key = key_of(*name, options);
    const auto known = imports.drawings.find(key);
    if (known != imports.drawings.end()) return &known->second;
    try {
        ImportOptions of_scene = options;
        of_scene.length_unit = imports.length_unit;
        ImportedDrawing import{read_drawing(path_of(reading, *name), of_scene), 1};
        const std::optional<double> factor = factor_to_scene(reading, imports, import.drawing, file);
        if (!factor) return nullptr;
        import.factor = *factor;
        if (import.factor != 1) scale(import.drawing, import.factor);
        return &imports.drawings.emplace(key, std::move(import)).first->second;
    } catch (const InputError& error) {
        for (const Problem& p : error.problems())
            report_problem(reading, file, p.where.empty() ? p.what : p.where + ": " + p.what, p.hint);
        return nullptr;
    }
}

ImportOptions read_import_options(SceneReading& reading, const JsonValue& object) {
    ImportOptions options;
    options.tolerance = member_or(reading, object, "tolerance", 0.0, read_positive, dimension::length);
    if (const JsonValue* parts_by = find_member(object, "parts_by")) {
        const auto word = read_word(reading, *parts_by, parts_by_words());
        if (word) options.parts_by = parts_by_of(*word).value_or(options.parts_by);
    }
    options.recognise_arcs = member_or(reading, object, "recognise_arcs", true, read_flag);
    if (const JsonValue* section = find_member(object, "section")) read_section(reading, *section, options);
    options.layers.only = read_texts(reading, object, "only_layers");
    options.layers.ignore = read_texts(reading, object, "ignore_layers");
    options.leave_open = member_or(reading, object, "leave_open", false, read_flag);
    options.keep_drafting = member_or(reading, object, "keep_drafting", false, read_flag);
    options.block_outline = read_texts(reading, object, "block_outline");
    if (const JsonValue* regions = find_member(object, "regions")) read_regions(reading, *regions, options);
    return options;
}

std::optional<geometry::SketchParts> import_parts(SceneReading& reading, Imports& imports, const ImportedDrawing& import,
                                                  const JsonValue& at, const ImportOptions& options,
                                                  const std::function<bool(const geometry::SketchEntity&)>& wanted) {
    Drawing drawing = import.drawing;
    std::erase_if(drawing.entities, [&](const geometry::SketchEntity& entity) { return !wanted(entity); });
    geometry::SketchParts sketch = geometry::parts_of(drawing, sketch_options(drawing, options));
    const std::size_t before = reading.problems.size();
    for (const auto& problem : drawing.problems) report_sketch_problem(reading, at, drawing, problem);
    for (const auto& problem : sketch.problems) report_sketch_problem(reading, at, drawing, problem);
    if (reading.problems.size() > before) return std::nullopt;
    add_record(imports, import_record(drawing, import.factor, sketch.repairs, sketch.warnings));
    return sketch;
}

std::optional<geometry::Imported> import_part(SceneReading& reading, Imports& imports, const JsonValue& node) {
    if (!check_object(reading, node, {"file", "layer", "block", "tolerance", "recognise_arcs"})) return std::nullopt;
    const JsonValue* file = required(reading, node, "file");
    const ImportOptions options = read_import_options(reading, node);
    const ImportedDrawing* import = file ? import_drawing(reading, imports, *file, options) : nullptr;
    if (!import) return std::nullopt;
    const std::size_t before = reading.problems.size();
    const std::string layer = read_choice(reading, node, "layer", "layer", layers_of(import->drawing));
    const std::string block = read_choice(reading, node, "block", "block", blocks_of(import->drawing));
    if (reading.problems.size() > before) return std::nullopt;
    auto sketch = import_parts(reading, imports, *import, node, options, [&](const geometry::SketchEntity& entity) {
        return (layer.empty() || entity.layer == layer) && (block.empty() || matches_block(entity, block));
    });
    return the_only_part(reading, node, std::move(sketch), "'layer' or 'block'");
}

std::optional<geometry::Imported> import_body(SceneReading& reading, Imports& imports, const JsonValue& node, BodiesOf bodies) {
    Words keys{"file", "node", "section", "tolerance"};
    if (bodies == BodiesOf::mesh) keys.emplace_back("recognise_arcs");
    if (!check_object(reading, node, keys)) return std::nullopt;
    const JsonValue* file = required(reading, node, "file");
    const ImportOptions options = read_import_options(reading, node);
    const ImportedDrawing* import = file ? import_drawing(reading, imports, *file, options) : nullptr;
    if (!import) return std::nullopt;
    const std::size_t before = reading.problems.size();
    const std::string body = read_choice(reading, node, "node", "node", layers_of(import->drawing));
    if (reading.problems.size() > before) return std::nullopt;
    auto sketch = import_parts(reading, imports, *import, node, options,
                               [&](const geometry::SketchEntity& entity) { return body.empty() || entity.layer == body; });
    return the_only_part(reading, node, std::move(sketch), "'node'");
}

}  // namespace abut
