// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/dxf_ignored.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace abut::geometry::dxf {

namespace {

using namespace std::string_view_literals;

constexpr std::array read_types{"LINE"sv, "ARC"sv, "CIRCLE"sv, "LWPOLYLINE"sv, "POLYLINE"sv};
constexpr std::array annotation_types{"TEXT"sv,   "MTEXT"sv,   "DIMENSION"sv,     "ARC_DIMENSION"sv, "LARGE_RADIAL_DIMENSION"sv,
                                      "LEADER"sv, "MLEADER"sv, "TOLERANCE"sv,     "MULTILEADER"sv,   "HATCH"sv,
                                      "POINT"sv,  "ATTDEF"sv,  "ARCALIGNEDTEXT"sv};
constexpr std::array endless_types{"XLINE"sv, "RAY"sv};
/// By drawing convention no outlines; a line type or a layer of such a name says so.
constexpr std::array construction_linetypes{"CENTER"sv, "CENTRE"sv,  "HIDDEN"sv, "PHANTOM"sv,
                                            "DASHED"sv, "DASHDOT"sv, "DOT"sv,    "DIVIDE"sv};
constexpr std::array construction_layers{"CENTER"sv,      "CENTRE"sv,      "CENTERLINE"sv,  "CENTRELINE"sv,
                                         "CENTERLINES"sv, "CENTRELINES"sv, "CENTER_LINE"sv, "CENTRE_LINE"sv,
                                         "HIDDEN"sv,      "PHANTOM"sv,     "DIM"sv,         "DIMS"sv,
                                         "DIMENSION"sv,   "DIMENSIONS"sv,  "DEFPOINTS"sv,   "CONSTRUCTION"sv};

template <std::size_t n>
bool is_one_of(const std::string& text, const std::array<std::string_view, n>& names) {
    return std::find(names.begin(), names.end(), text) != names.end();
}

/// CENTER2 and CENTERX2 are the half and double scale of CENTER.
std::string without_scale(std::string linetype) {
    if (linetype.ends_with("X2"))
        linetype.resize(linetype.size() - 2);
    else if (linetype.ends_with("2"))
        linetype.resize(linetype.size() - 1);
    return linetype;
}

Layer layer_of(const Record& entity, const Structure& structure) {
    const auto found = structure.layers.find(upper_case(entity.text(8, "0")));
    return found == structure.layers.end() ? Layer{} : found->second;
}

std::string linetype_of(const Record& entity, const Layer& layer) {
    const std::string own = upper_case(entity.text(6, "BYLAYER"));
    return own == "BYLAYER" ? upper_case(layer.linetype) : own;
}

/// Normal of the entity's plane other than +z or -z: seen in the drawing's plane it would be another curve.
bool is_tilted(const Record& entity) {
    constexpr double parallel = 1e-9;  // of the normal's components; exporters write 1e-15 or so
    const auto component = [&](int code, double missing) {
        double value = missing;
        return parse_number(entity.text(code), value) ? value : missing;
    };
    return has_own_plane(entity) && std::hypot(component(210, 0), component(220, 0)) > parallel * std::abs(component(230, 1));
}

std::string why_type_ignored(const Record& entity) {
    constexpr int mesh = 16, polyface = 64;
    if (is_one_of(entity.type, annotation_types)) return "annotation";
    if (is_one_of(entity.type, endless_types)) return "construction line";
    if (!is_one_of(entity.type, read_types)) return "not read by this version";
    if (entity.type == "POLYLINE" && (entity.integer(70, 0) & (mesh | polyface)) != 0) return "a mesh, not a curve";
    return {};
}

}  // namespace

bool is_in_paper_space(const Record& entity) {
    return entity.integer(67, 0) == 1;
}

bool has_own_plane(const Record& entity) {
    constexpr int polyline_3d = 8;
    return entity.type != "LINE" && !(entity.type == "POLYLINE" && (entity.integer(70, 0) & polyline_3d) != 0);
}

bool is_subentity(const Record& entity) {
    return entity.type == "VERTEX" || entity.type == "ATTRIB" || entity.type == "SEQEND";
}

std::string why_ignored(const Record& entity, const Structure& structure) {
    const Layer layer = layer_of(entity, structure);
    if (is_in_paper_space(entity)) return "in paper space";
    if (layer.frozen) return "layer is frozen";
    if (layer.off) return "layer is off";
    if (entity.integer(60, 0) == 1) return "invisible";
    if (const std::string why = why_type_ignored(entity); !why.empty()) return why;
    if (is_tilted(entity)) return "not in the drawing's plane";
    const std::string linetype = linetype_of(entity, layer);
    if (is_one_of(without_scale(linetype), construction_linetypes)) return "line type " + linetype;
    if (is_one_of(upper_case(entity.text(8, "0")), construction_layers)) return "layer of construction lines";
    return {};
}

}  // namespace abut::geometry::dxf
