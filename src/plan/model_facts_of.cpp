// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plan/model_facts_of.hpp"

#include <algorithm>
#include <filesystem>

#include "src/base/index.hpp"
#include "src/io/json_document.hpp"
#include "src/io/whole_file.hpp"
#include "src/plan/boundary_conditions.hpp"
#include "src/plan/loads.hpp"
#include "src/results/result_units.hpp"

namespace abut {

namespace {

std::string analysis_key(Analysis analysis) {
    switch (analysis) {
        case Analysis::plane_strain:
            return "plane_strain";
        case Analysis::axisymmetric:
            return "axisymmetric";
        default:
            return "plane_stress";
    }
}

std::vector<std::string> edges_of(const Scene& scene, const std::vector<EdgePortion>& portions) {
    std::vector<std::string> names;
    for (const EdgePortion& p : portions) {
        const geometry::Part& part = part_of(scene, p.part);
        const std::string name = part.name + "/" + part.edges[at(p.edge)].name;
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return names;
}

std::vector<Vec2> middles_of(const Scene& scene, const std::vector<EdgePortion>& portions) {
    std::vector<Vec2> points;
    for (const EdgePortion& p : portions)
        points.push_back(point(part_of(scene, p.part).edges[at(p.edge)].curve, 0.5 * (p.t0 + p.t1)));
    return points;
}

void add_centroid(const Scene& scene, const std::string& part, std::vector<Vec2>& points) {
    for (const ScenePart& p : scene.parts)
        if (p.name == part) points.push_back(centroid(p.part));
}

/// The scene's word for a kind of load, how many numbers it has, and their unit.
struct LoadWords {
    std::string kind;
    int numbers;
    std::string unit;
};
LoadWords words_of(Load::Kind kind, const ResultUnits& units) {
    switch (kind) {
        case Load::Kind::pressure:
            return {"pressure", 1, units.stress};
        case Load::Kind::traction:
            return {"traction", 2, units.stress};
        case Load::Kind::edge_moment:
        case Load::Kind::part_moment:
            return {"moment", 1, units.moment};
        case Load::Kind::bearing:
            return {"bearing", 2, units.force};
        case Load::Kind::body_force:
            return {"body_force", 2, ""};
        case Load::Kind::gravity:
            return {"gravity", 2, ""};
        case Load::Kind::spin:
            return {"spin", 1, ""};
        case Load::Kind::temperature:
            return {"temperature", 1, ""};
        case Load::Kind::preload:
            return {"preload", 1, units.force};
        case Load::Kind::edge_force:
        case Load::Kind::part_force:
            break;
    }
    return {"force", 2, units.force};
}

LoadFacts load_facts(const Scene& scene, const Load& load, const std::vector<EdgePortion>& portions, const ResultUnits& units) {
    const LoadWords words = words_of(load.kind, units);
    LoadFacts facts{load.name, words.kind, {}, words.unit, edges_of(scene, portions)};
    facts.at = load.at ? std::vector<Vec2>{*load.at} : middles_of(scene, portions);
    if (facts.on.empty() && !load.part.empty() && load.part != "*") {
        facts.on.push_back(load.part);
        add_centroid(scene, load.part, facts.at);
    }
    if (load.kind == Load::Kind::spin) {
        facts.value = {load.omega};
        return facts;
    }
    for (int i = 0; i < words.numbers; ++i) {
        if (!load.value[at(i)].is_constant()) {
            facts.value.clear();
            return facts;
        }
        facts.value.push_back(load.value[at(i)].constant());
    }
    return facts;
}

}  // namespace

ModelSources model_sources(const Scene& scene) {
    ModelSources sources;
    const std::optional<std::string> text = whole_file(scene.file);
    if (text) sources.files.push_back({scene.file, content_hash(*text)});
    for (const ImportRecord& record : scene.imports)
        if (record.file != scene.file)
            sources.files.push_back({std::filesystem::path(record.file).lexically_normal().string(),
                                     content_hash(whole_file(record.file).value_or(""))});
    JsonDocument document;
    if (text && ending_of(scene.file) == ".json") document = parse_json(*text, scene.file);
    const auto gives = [](const JsonValue* value) { return value && find_member(*value, "thickness"); };
    for (const ScenePart& part : scene.parts)
        sources.default_thickness.push_back(scene.analysis != Analysis::axisymmetric && part.thickness == 1 &&
                                            !gives(&document.root) && !gives(find_pointer(document.root, part.where)));
    return sources;
}

ModelFacts model_facts(const Scene& scene, const ModelSources& sources) {
    const ResolvedConditions conditions = resolve_conditions(scene);
    Result labels;
    labels.length_unit = scene.length_unit;
    labels.force_unit = scene.force_unit;
    const ResultUnits units = result_units(labels);
    ModelFacts facts;
    facts.files = sources.files;
    facts.length_unit = scene.length_unit;
    facts.force_unit = scene.force_unit;
    facts.analysis = analysis_key(scene.analysis);
    for (const Material& m : scene.materials)
        facts.materials.push_back(
            {m.name, m.E, m.nu, m.has_density ? std::optional(m.density) : std::nullopt, m.expansion, m.yield, m.rigid});
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        const ScenePart& p = scene.parts[i];
        facts.parts.push_back({p.name, scene.materials[at(p.material)].name, p.thickness, sources.default_thickness[i]});
    }
    for (std::size_t i = 0; i < scene.loads.size(); ++i)
        facts.loads.push_back(load_facts(scene, scene.loads[i], conditions.loads[i], units));
    for (std::size_t i = 0; i < scene.supports.size(); ++i) {
        const Support& s = scene.supports[i];
        SupportFacts support{support_label(scene, static_cast<int>(i)), edges_of(scene, conditions.supports[i])};
        if (support.on.empty() && !s.part.empty()) support.on.push_back(s.part);
        support.at = middles_of(scene, conditions.supports[i]);
        support.at.insert(support.at.end(), s.at.begin(), s.at.end());
        if (s.kind == Support::Kind::rigid) add_centroid(scene, s.part, support.at);
        facts.supports.push_back(std::move(support));
    }
    return facts;
}

}  // namespace abut
