// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/inspection/inspect.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "src/scene/read_scene.hpp"
#include "src/scene/read_sketch.hpp"

namespace abut {

namespace {

using Json = nlohmann::ordered_json;

std::string extension_of(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

Inspection inspect_scene(const std::string& path) {
    Inspection inspection;
    inspection.scene = read_scene(path);
    inspection.file = path;
    inspection.format = "abut scene";
    inspection.unit = inspection.scene.length_unit;
    inspection.imports = inspection.scene.imports;
    return inspection;
}

/// Entities that no part's boundary was made of; edges carry the names of their entities.
std::vector<geometry::Curve> loose_curves(const SketchReading& reading) {
    std::set<std::string> used;
    for (const ScenePart& part : reading.scene.parts)
        for (const geometry::Edge& edge : part.part.edges) used.insert(edge.source);
    std::vector<geometry::Curve> loose;
    for (const geometry::SketchEntity& entity : reading.drawing.entities)
        if (used.count(entity.name) == 0) loose.push_back(entity.curve);
    return loose;
}

std::vector<std::string> notes_of(const SketchReading& reading) {
    const geometry::Drawing& drawing = reading.drawing;
    std::vector<std::string> notes;
    if (!drawing.replaced_unit.empty())
        notes.push_back("the file states " + drawing.replaced_unit + "; its numbers are taken as " + drawing.unit +
                        ", as asked for");
    if (!reading.sketch.parts.empty() && !is_solid_file(drawing.file))
        notes.push_back("parts by " + parts_by_name(reading.sketch.parts_by) + ": " + reading.sketch.why);
    return notes;
}

Inspection inspect_drawing(const std::string& path, const ImportOptions& options) {
    SketchReading reading = read_sketch(path, options);
    Inspection inspection;
    inspection.file = path;
    inspection.format = reading.drawing.format;
    inspection.unit = reading.scene.length_unit.empty() ? reading.drawing.unit : reading.scene.length_unit;
    inspection.problems = reading.drawing.problems;
    inspection.problems.insert(inspection.problems.end(), reading.sketch.problems.begin(), reading.sketch.problems.end());
    inspection.loose = loose_curves(reading);
    inspection.notes = notes_of(reading);
    inspection.imports = reading.scene.imports;
    inspection.regions = reading.sketch.regions;
    inspection.scene = std::move(reading.scene);
    return inspection;
}

Json point_json(const Vec2& p) {
    return Json::array({p.x(), p.y()});
}

Json edge_json(const geometry::Edge& edge) {
    return {{"name", edge.name},
            {"kind", kind_name(edge.curve)},
            {"length", length(edge.curve)},
            {"from", point_json(point(edge.curve, 0))},
            {"to", point_json(point(edge.curve, 1))}};
}

Json part_json(const ScenePart& scene_part) {
    const geometry::Part& part = scene_part.part;
    Json edges = Json::array();
    for (const geometry::Edge& edge : part.edges) edges.push_back(edge_json(edge));
    Json json{{"name", scene_part.name},      {"area", area(part)},
              {"perimeter", perimeter(part)}, {"centroid", point_json(centroid(part))},
              {"holes", count_holes(part)},   {"edges", edges}};
    if (!scene_part.level.empty()) json["level"] = scene_part.level;
    return json;
}

Json entities_json(const Inspection& inspection) {
    std::map<std::string, geometry::EntityCount> sums;
    for (const ImportRecord& record : inspection.imports)
        for (const auto& [type, count] : record.counts) {
            sums[type].read += count.read;
            sums[type].used += count.used;
            sums[type].ignored += count.ignored;
        }
    Json json = Json::object();
    for (const auto& [type, count] : sums)
        json[type] = {{"read", count.read}, {"used", count.used}, {"ignored", count.ignored}};
    return json;
}

Json size_json(const Inspection& inspection) {
    geometry::Box2 box;
    for (const ScenePart& part : inspection.scene.parts) box.extend(bounding_box(part.part));
    return box.empty() ? Json::array({0, 0}) : point_json(box.size());
}

}  // namespace

Inspection inspect_file(const std::string& path, const ImportOptions& options) {
    return extension_of(path) == ".json" ? inspect_scene(path) : inspect_drawing(path, options);
}

std::vector<geometry::Repair> geometry_repairs(const Scene& scene) {
    std::vector<geometry::Repair> repairs;
    for (const ScenePart& part : scene.parts)
        for (const geometry::Repair& r : part.repairs) repairs.push_back({"part " + part.name + ": " + r.what, r.at, r.size});
    return repairs;
}

std::vector<geometry::Repair> all_repairs(const Inspection& inspection) {
    std::vector<geometry::Repair> repairs;
    for (const ImportRecord& record : inspection.imports)
        repairs.insert(repairs.end(), record.repairs.begin(), record.repairs.end());
    for (geometry::Repair& r : geometry_repairs(inspection.scene)) repairs.push_back(std::move(r));
    return repairs;
}

std::string inspection_json(const Inspection& inspection) {
    Json json{{"abut", 1},
              {"file", inspection.file},
              {"format", inspection.format},
              {"unit", inspection.unit},
              {"size", size_json(inspection)},
              {"entities", entities_json(inspection)},
              {"parts", Json::array()},
              {"repairs", Json::array()},
              {"ignored", Json::array()},
              {"regions", Json::array()},
              {"warnings", inspection.scene.warnings},
              {"problems", Json::array()}};
    for (const ScenePart& part : inspection.scene.parts) json["parts"].push_back(part_json(part));
    for (const geometry::Repair& r : all_repairs(inspection))
        json["repairs"].push_back({{"what", r.what}, {"at", point_json(r.at)}, {"size", r.size}});
    for (const ImportRecord& record : inspection.imports)
        for (const geometry::Ignored& i : record.ignored)
            json["ignored"].push_back({{"what", i.what}, {"count", i.count}, {"why", i.why}});
    for (const geometry::SketchRegion& r : inspection.regions)
        json["regions"].push_back({{"name", r.name}, {"at", point_json(r.at)}, {"part", r.part}, {"doubtful", r.is_doubtful}});
    for (const geometry::SketchProblem& p : inspection.problems)
        json["problems"].push_back(
            {{"what", p.what}, {"at", point_json(p.at)}, {"entity", p.entity}, {"line", p.line}, {"hint", p.hint}});
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace abut
