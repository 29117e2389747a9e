// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/inspection/starter_scene.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "src/io/number_text.hpp"
#include "src/results/result_units.hpp"
#include "src/scene/part_levels.hpp"
#include "src/scene/read_materials.hpp"
#include "src/scene/read_sketch.hpp"

namespace abut {

namespace {

/// Edges listed per part; `abut inspect` lists them all.
constexpr std::size_t most_edges = 60;

/// The force unit that goes with a length unit.
struct UsualForce {
    const char *length, *force;
};
constexpr UsualForce usual_forces[] = {{"mm", "N"}, {"m", "N"}, {"cm", "N"}, {"um", "uN"}, {"in", "lbf"}, {"ft", "lbf"}};

/// Of millimetres where the file states no unit.
SceneUnits units_for(const std::string& length_unit) {
    if (length_unit.empty()) return {usual_forces[0].length, usual_forces[0].force};
    for (const UsualForce& usual : usual_forces)
        if (length_unit == usual.length) return {usual.length, usual.force};
    return {length_unit, usual_forces[0].force};
}

std::string quoted(const std::string& text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Names come out of files: nothing in them may end a comment's line.
std::string for_comment(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < ' '; }, ' ');
    return text;
}

std::string number(double value) {
    return number_text(value, 6);
}

std::string edge_line(const ScenePart& part, const geometry::Edge& edge) {
    std::ostringstream line;
    line << part.name << "/" << edge.name << "  " << kind_name(edge.curve) << " " << pair_text(point(edge.curve, 0), 6)
         << " to " << pair_text(point(edge.curve, 1), 6) << ", length " << number(length(edge.curve));
    return for_comment(line.str());
}

std::string level_key(const ScenePart& part) {
    if (part.level.empty()) return "";
    const std::string levels = levels_text(part.level);
    return ", \"level\": " + (part.level.size() == 1 ? levels : "[" + levels + "]");
}

void write_parts(std::ostream& out, const Scene& scene, const std::string& material) {
    out << "    \"parts\": {\n";
    if (!levels_text(scene).empty())
        out << "      // check \"level\": guessed for parts that overlap; those without a common one do not meet\n";
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        const ScenePart& part = scene.parts[i];
        const auto box = bounding_box(part.part);
        out << "      " << quoted(part.name) << ": {\"material\": " << quoted(material) << level_key(part) << "}"
            << (i + 1 < scene.parts.size() ? "," : "") << "  // " << number(box.size().x()) << " x " << number(box.size().y())
            << ", area " << number(area(part.part)) << ", " << counted(part.part.edges.size(), "edge") << "\n";
    }
    out << "    }\n";
}

void write_edges(std::ostream& out, const Scene& scene) {
    out << "  // Edges, for \"on\" below; \"part/*\" takes all of a part, {\"part\": P, \"near\": [x, y]} the closest one.\n";
    for (const ScenePart& part : scene.parts) {
        const std::size_t n = part.part.edges.size();
        for (std::size_t e = 0; e < std::min(n, most_edges); ++e)
            out << "  //   " << edge_line(part, part.part.edges[e]) << "\n";
        if (n > most_edges)
            out << "  //   ... and " << n - most_edges << " more of " << for_comment(part.name)
                << " (abut inspect lists them)\n";
    }
}

void write_contacts(std::ostream& out, const Scene& scene, const Detection& contacts) {
    if (scene.parts.size() < 2) return;
    out << "  // Contacts are found by themselves:" << (contacts.pairs.empty() ? " none as drawn" : "") << "\n";
    for (const DetectedPair& pair : contacts.pairs)
        out << "  //   " << for_comment(pair.between[0] + " and " + pair.between[1]) << ": " << pair.interface << ", "
            << pair.status << ", gap " << number(pair.gap_min) << "\n";
}

/// The edge whose middle lies lowest, or highest: where assemblies often stand, or are pressed.
std::string extreme_edge(const Scene& scene, double sign) {
    std::string name;
    double best = 0;
    for (const ScenePart& part : scene.parts)
        for (const geometry::Edge& edge : part.part.edges) {
            const double height = sign * point(edge.curve, 0.5).y();
            if (!name.empty() && height <= best) continue;
            best = height;
            name = part.name + "/" + edge.name;
        }
    return name;
}

/// Lengths are converted where file and scene state different units, so none is stated where another one than the file's is
/// meant.
std::string units_line(const geometry::Drawing& drawing, const SceneUnits& units) {
    const std::string force = "\"force\": \"" + units.force + "\"";
    if (!drawing.replaced_unit.empty())
        return "{" + force + "},  // lengths in " + for_comment(drawing.unit) + ", though the file states " +
               drawing.replaced_unit + ": stated here they would be converted";
    const bool is_known = !drawing.unit.empty();
    return "{\"length\": " + quoted(is_known ? drawing.unit : units.length) + ", " + force + "}," +
           (is_known ? "" : "  // the file states no unit of length: millimetres are assumed, check the sizes below");
}

/// The library's material, in numbers where the scene's units are not stated, or none that are known.
void write_material(std::ostream& out, const geometry::Drawing& drawing, const SceneUnits& units, const std::string& name) {
    const Material material = material_from_library(name, units);
    if (drawing.replaced_unit.empty() && (drawing.unit.empty() || drawing.unit == units.length)) {
        out << "  // The library has steel, aluminium, cast iron, brass, POM and more (abut help scene.materials); "
               "\"materials\": {\"own\": {\"E\": \"70 GPa\", \"nu\": 0.33}} defines others.\n";
        return;
    }
    out << "  \"materials\": {" << quoted(name) << ": {\"E\": " << nlohmann::json(material.E).dump()
        << ", \"nu\": " << nlohmann::json(material.nu).dump() << ", \"density\": " << nlohmann::json(material.density).dump()
        << "}},  // for lengths in " << units.length << ", E in " << units.force << "/" << units.length << "^2\n";
}

/// What was assumed about layers and regions: the next run need not guess.
void write_assumptions(std::ostream& out, const SketchReading& reading, const ImportOptions& options) {
    if (!options.layers.only.empty()) out << "    \"only_layers\": " << nlohmann::json(options.layers.only).dump() << ",\n";
    std::vector<std::string> ignored = options.layers.ignore;
    ignored.insert(ignored.end(), reading.drawing.drafting_layers.begin(), reading.drawing.drafting_layers.end());
    if (!ignored.empty())
        out << "    \"ignore_layers\": " << nlohmann::json(ignored).dump()
            << (reading.drawing.drafting_layers.empty() ? ",\n" : ",  // for their names\n");
    if (options.leave_open) out << "    \"leave_open\": true,\n";
    if (options.keep_drafting) out << "    \"keep_drafting\": true,\n";
    if (!options.block_outline.empty())
        out << "    \"block_outline\": " << nlohmann::json(options.block_outline).dump() << ",\n";
    nlohmann::ordered_json regions = nlohmann::ordered_json::object();
    for (const auto& [name, what] : options.regions) regions[name] = what;
    std::map<std::string, std::string> first_of;  // region by part: others are one with it
    for (const geometry::SketchRegion& region : reading.sketch.regions) {
        const auto [first, is_new] = first_of.emplace(region.part, region.name);
        if (region.is_doubtful && !regions.contains(region.name))
            regions[region.name] = region.part.empty() ? "void" : is_new ? "part" : first->second;
    }
    if (!regions.empty())
        out << "    \"regions\": " << regions.dump()
            << ",  // check: void, part, the part's name, or the region it is one with (abut inspect -o DIR draws them)\n";
}

/// What the file was read with, so that the scene reads it the same way.
void write_import(std::ostream& out, const SketchReading& reading, const ImportOptions& options, const std::string& folder) {
    constexpr const char* axes[] = {"x", "y", "z"};
    const std::string file =
        folder.empty() ? reading.scene.file : std::filesystem::proximate(reading.scene.file, folder).string();
    out << "    \"file\": " << quoted(file) << ",  // relative to this scene's folder\n"
        << "    \"parts_by\": " << quoted(parts_by_name(reading.sketch.parts_by)) << ",\n";
    if (options.tolerance > 0) out << "    \"tolerance\": " << nlohmann::json(options.tolerance).dump() << ",\n";
    if (!options.recognise_arcs) out << "    \"recognise_arcs\": false,\n";
    write_assumptions(out, reading, options);
    nlohmann::ordered_json section;
    if (options.section.axis >= 0) section["axis"] = axes[options.section.axis];
    if (options.section.at) section["at"] = *options.section.at;
    if (!section.empty()) out << "    \"section\": " << section.dump() << ",\n";
}

/// A list of one entry that lacks its edge.
void write_to_fill_in(std::ostream& out, const std::string& key, const std::string& what, const std::string& rest,
                      const std::string& example) {
    out << "  \"" << key << "\": [\n    {\"on\": \"FILL IN an edge to " << what << "\", " << rest
        << "}  // for instance \"on\": " << for_comment(quoted(example)) << "\n  ]";
}

}  // namespace

std::string starter_scene(const SketchReading& reading, const ImportOptions& options, const Detection& contacts,
                          const StarterChoice& choice) {
    const Scene& scene = reading.scene;
    const SceneUnits units = units_for(scene.length_unit);
    std::ostringstream out;
    out << (choice.is_pointed_at
                ? "// Begun by abut live.\n{\n"
                : "// Begun by abut init. Fill in a support and a load, at the end, then run: abut analyze THIS_FILE\n{\n")
        << "  \"abut\": 1,\n  \"title\": " << quoted(std::filesystem::path(scene.file).stem().string()) << ",\n"
        << "  \"units\": " << units_line(reading.drawing, units) << "\n"
        << "  \"analysis\": \"plane_stress\",  // or \"plane_strain\"\n  \"thickness\": "
        << nlohmann::json(choice.thickness.value_or(1)).dump()
        << (choice.thickness ? ",\n" : ",  // check: forces are totals over it\n");
    write_material(out, reading.drawing, units, choice.material);
    out << "  \"assembly\": {\n";
    write_import(out, reading, options, choice.folder);
    write_parts(out, scene, choice.material);
    out << "  },\n";
    write_edges(out, scene);
    write_contacts(out, scene, contacts);
    if (choice.is_pointed_at) {
        out << "  \"supports\": [],\n  \"loads\": []\n}\n";
        return out.str();
    }
    write_to_fill_in(out, "supports", "hold", "\"fix\": [\"x\", \"y\"]", extreme_edge(scene, -1));
    out << ",\n";
    write_to_fill_in(out, "loads", "load", "\"force\": [0, -100]", extreme_edge(scene, 1));
    out << "\n}\n";
    return out.str();
}

}  // namespace abut
