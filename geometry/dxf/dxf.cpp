// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing out of a DXF file, in steps: groups (dxf_groups, dxf_binary), sections and records (dxf_prepass), what is drawn and
// where (dxf_ignored, dxf_blocks, dxf_inserts, dxf_placement), curves (dxf_entities, dxf_splines); what dimensions say beside
// it (dxf_dimensions).
#include "geometry/dxf/dxf.hpp"

#include <set>

#include "geometry/dxf/drafting_layers.hpp"
#include "geometry/dxf/dxf_blocks.hpp"
#include "geometry/dxf/dxf_dimensions.hpp"
#include "geometry/dxf/dxf_prepass.hpp"

namespace abut::geometry {

namespace {

std::string header_value(const dxf::Structure& structure, const std::string& variable) {
    const auto found = structure.header.find(variable);
    return found == structure.header.end() ? std::string() : found->second;
}

/// $INSUNITS as it counts them; units of astronomy and Angstrom have no name here and count as unknown.
std::string unit_of(const dxf::Structure& structure) {
    static const std::map<std::string, std::string> by_insunits{
        {"1", "in"},  {"2", "ft"},     {"3", "mi"},     {"4", "mm"},     {"5", "cm"},    {"6", "m"},   {"7", "km"},
        {"8", "uin"}, {"9", "mil"},    {"10", "yd"},    {"12", "nm"},    {"13", "um"},   {"14", "dm"}, {"15", "dam"},
        {"16", "hm"}, {"21", "ft_us"}, {"22", "in_us"}, {"23", "yd_us"}, {"24", "mi_us"}};
    const std::string insunits = header_value(structure, "$INSUNITS"), measurement = header_value(structure, "$MEASUREMENT");
    if (const auto unit = by_insunits.find(insunits); unit != by_insunits.end()) return unit->second;
    if (!insunits.empty() && insunits != "0") return {};
    if (!insunits.empty()) return {};  // stated to be without unit: the system of measurement then only chooses patterns
    if (measurement == "0") return "in";
    if (measurement == "1") return "mm";
    return {};
}

Drawing drawing_of(const dxf::Structure& structure, const LayerFilter& layers) {
    Drawing drawing;
    drawing.file = structure.groups.file;
    const std::string version = header_value(structure, "$ACADVER");
    drawing.format = (structure.groups.is_binary ? "binary DXF" : "DXF") + (version.empty() ? "" : " " + version);
    drawing.unit = unit_of(structure);
    drawing.warnings = structure.warnings;
    dxf::add_model_space(structure, layers, drawing);
    dxf::tell_other_dimensions(structure, drawing);
    std::set<std::string> names;
    for (const SketchEntity& entity : drawing.entities) {
        names.insert(entity.layer);
        names.insert(entity.block);
    }
    for (const std::string& name : names)
        if (dxf::says_holes(name.substr(name.rfind('/') + 1))) drawing.hole_layers.insert(name);
    return drawing;
}

}  // namespace

Drawing read_dxf_bytes(const std::string& file, std::string bytes, const LayerFilter& layers) {
    return drawing_of(dxf::structure_of(file, std::move(bytes)), layers);
}

Drawing read_dxf(const std::string& path, const LayerFilter& layers) {
    return drawing_of(dxf::read_structure(path), layers);
}

}  // namespace abut::geometry
