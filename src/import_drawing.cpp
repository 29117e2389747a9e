// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/import_drawing.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "src/nearest_name.hpp"

namespace abut {

namespace {

using geometry::Arc;
using geometry::Curve;
using geometry::Drawing;
using geometry::Segment;

Curve scaled(const Curve& curve, double factor) {
    if (const auto* arc = std::get_if<Arc>(&curve))
        return Arc{factor * arc->center, factor * arc->radius, arc->start, arc->sweep};
    const auto& segment = std::get<Segment>(curve);
    return Segment{factor * segment.from, factor * segment.to};
}

void scale(Drawing& drawing, double factor) {
    for (geometry::SketchEntity& entity : drawing.entities) entity.curve = scaled(entity.curve, factor);
    for (geometry::SketchProblem& problem : drawing.problems) problem.at *= factor;
}

/// Nothing is converted unless both sides state a unit.
std::optional<double> factor_to_scene(SceneReading& reading, const Imports& imports, const Drawing& drawing,
                                      const JsonValue& at) {
    if (drawing.unit.empty() || imports.length_unit.empty() || drawing.unit == imports.length_unit) return 1;
    const double factor = geometry::unit_factor(drawing.unit, imports.length_unit);
    if (factor > 0) return factor;
    report(reading, at,
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
    report(reading, at, what, problem.hint);
}

/// One record for each file, however many parts take something from it.
void add_record(Imports& imports, ImportRecord record) {
    for (ImportRecord& known : imports.records) {
        if (known.file != record.file) continue;
        known.repairs.insert(known.repairs.end(), record.repairs.begin(), record.repairs.end());
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

ImportRecord import_record(const Drawing& drawing, double factor, std::vector<geometry::Repair> repairs) {
    return {drawing.file, drawing.format, drawing.unit, factor, drawing.counts, drawing.ignored, std::move(repairs)};
}

const ImportedDrawing* import_drawing(SceneReading& reading, Imports& imports, const JsonValue& file) {
    const std::optional<std::string> name = read_text(reading, file);
    if (!name) return nullptr;
    const auto known = imports.drawings.find(*name);
    if (known != imports.drawings.end()) return &known->second;
    try {
        ImportedDrawing import{geometry::read_dxf((std::filesystem::path(reading.file).parent_path() / *name).string()), 1};
        const std::optional<double> factor = factor_to_scene(reading, imports, import.drawing, file);
        if (!factor) return nullptr;
        import.factor = *factor;
        if (import.factor != 1) scale(import.drawing, import.factor);
        return &imports.drawings.emplace(*name, std::move(import)).first->second;
    } catch (const InputError& error) {
        for (const Problem& p : error.problems())
            report(reading, file, p.where.empty() ? p.what : p.where + ": " + p.what, p.hint);
        return nullptr;
    }
}

std::optional<geometry::SketchParts> import_parts(SceneReading& reading, Imports& imports, const ImportedDrawing& import,
                                                  const JsonValue& at, double tolerance,
                                                  const std::function<bool(const std::string& layer)>& wanted) {
    Drawing drawing = import.drawing;
    std::erase_if(drawing.entities, [&](const geometry::SketchEntity& entity) { return !wanted(entity.layer); });
    geometry::SketchParts sketch = geometry::parts_by_layer(drawing, {tolerance});
    const std::size_t before = reading.problems.size();
    for (const auto& problem : drawing.problems) report_sketch_problem(reading, at, drawing, problem);
    for (const auto& problem : sketch.problems) report_sketch_problem(reading, at, drawing, problem);
    if (reading.problems.size() > before) return std::nullopt;
    add_record(imports, import_record(drawing, import.factor, sketch.repairs));
    return sketch;
}

std::optional<geometry::Part> import_part(SceneReading& reading, Imports& imports, const JsonValue& node) {
    if (!check_object(reading, node, {{"file", "layer", "tolerance"}, {"block"}})) return std::nullopt;
    const JsonValue* file = required(reading, node, "file");
    const JsonValue* layer = find_member(node, "layer");
    const double tolerance = member_or(reading, node, "tolerance", 0.0, read_positive);
    const std::string name = member_or(reading, node, "layer", std::string(), read_text);
    const ImportedDrawing* import = file ? import_drawing(reading, imports, *file) : nullptr;
    if (!import || (layer && name.empty())) return std::nullopt;
    const std::vector<std::string> layers = layers_of(import->drawing);
    if (layer && std::find(layers.begin(), layers.end(), name) == layers.end()) {
        report(reading, *layer, "the drawing has no layer '" + shortened(name) + "' with lines, arcs or circles",
               nearest_name_hint(name, layers));
        return std::nullopt;
    }
    auto sketch =
        import_parts(reading, imports, *import, node, tolerance, [&](const std::string& l) { return !layer || l == name; });
    if (!sketch) return std::nullopt;
    if (sketch->parts.size() == 1) return std::move(sketch->parts.front());
    std::vector<std::string> names;
    for (const geometry::Part& part : sketch->parts) names.push_back(part.name);
    report(reading, node,
           "the drawing bounds " + std::to_string(names.size()) + " parts here, not one" +
               (names.empty() ? "" : ": " + listed(names)),
           "choose one by 'layer', or use 'assembly'");
    return std::nullopt;
}

}  // namespace abut
