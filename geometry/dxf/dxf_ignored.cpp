// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/dxf/dxf_ignored.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "geometry/dxf/drafting_layers.hpp"
#include "geometry/dxf/dxf_entities.hpp"
#include "geometry/sketch/sketch_names.hpp"

namespace abut::geometry::dxf {

namespace {

using namespace std::string_view_literals;

constexpr std::array read_types{"LINE"sv,       "ARC"sv,      "CIRCLE"sv, "ELLIPSE"sv,
                                "LWPOLYLINE"sv, "POLYLINE"sv, "SPLINE"sv, "INSERT"sv};

struct Reason {
    std::string_view why;
    std::vector<std::string_view> types;
};

const std::array reasons{
    Reason{"annotation",
           {"TEXT", "MTEXT", "RTEXT", "ARCALIGNEDTEXT", "DIMENSION", "ARC_DIMENSION", "LARGE_RADIAL_DIMENSION", "LEADER",
            "MLEADER", "MULTILEADER", "TOLERANCE", "POINT", "ATTDEF", "ATTRIB", "SHAPE", "ACAD_TABLE", "TABLE"}},
    Reason{"construction line", {"XLINE", "RAY"}},
    Reason{"a filling: its boundary is no outline of its own", {"HATCH", "MPOLYGON", "WIPEOUT"}},
    Reason{"a filled area, not a curve", {"SOLID", "TRACE"}},
    Reason{"a mesh, not a curve", {"3DFACE", "MESH", "POLYFACE"}},
    Reason{"a solid or surface in a closed format (ACIS)",
           {"3DSOLID", "REGION", "BODY", "SURFACE", "PLANESURFACE", "EXTRUDEDSURFACE", "REVOLVEDSURFACE", "LOFTEDSURFACE",
            "SWEPTSURFACE", "NURBSURFACE"}},
    Reason{"a multiline: explode it in CAD where it is an outline", {"MLINE"}},
    Reason{"a curve in space", {"HELIX"}},
    Reason{"a picture or foreign object",
           {"IMAGE", "OLEFRAME", "OLE2FRAME", "PDFUNDERLAY", "DWFUNDERLAY", "DGNUNDERLAY", "UNDERLAY", "POINTCLOUD"}},
    Reason{"an object of another program", {"ACAD_PROXY_ENTITY", "ACAD_PROXY_OBJECT"}},
    Reason{"part of a view, not of the drawing", {"VIEWPORT", "LIGHT", "SUN", "CAMERA", "SECTION", "SECTIONOBJECT"}},
};

/// By drawing convention no outlines. Names are compared without their blanks and hyphens.
constexpr std::array construction_linetypes{"CENTER"sv,      "CENTRE"sv,  "HIDDEN"sv,   "PHANTOM"sv,     "DASHED"sv,
                                            "DASH"sv,        "DASHDOT"sv, "DOT"sv,      "DIVIDE"sv,      "CHAIN"sv,
                                            "DASHEDSPACE"sv, "MITTE"sv,   "VERDECKT"sv, "STRICHLINIE"sv, "STRICHPUNKT"sv,
                                            "AXES"sv,        "CACHE"sv,   "TIRETPT"sv,  "FANTOME"sv};
template <std::size_t n>
bool is_one_of(std::string_view text, const std::array<std::string_view, n>& names) {
    return std::find(names.begin(), names.end(), text) != names.end();
}

/// Upper case, without what an external reference puts before it ("file|CENTER"), blanks, hyphens and underscores.
std::string plain_name(std::string_view name) {
    std::string plain = upper_case(name.substr(name.rfind('|') + 1));  // npos + 1 is 0
    std::erase_if(plain, [](char c) { return c == ' ' || c == '_' || c == '-'; });
    return plain;
}

/// CENTER2 and CENTERX2 are the half and double scale of CENTER.
std::string without_scale(std::string linetype) {
    if (linetype.ends_with("X2"))
        linetype.resize(linetype.size() - 2);
    else if (linetype.ends_with("2"))
        linetype.resize(linetype.size() - 1);
    return linetype;
}

/// ISO line types of AutoCAD are all interrupted; SolidWorks puts "SLD-" before the usual names.
bool is_construction_linetype(const std::string& linetype) {
    std::string plain = without_scale(plain_name(linetype));
    if (plain.starts_with("SLD")) plain.erase(0, 3);
    return plain.starts_with("ACADISO") || is_one_of(plain, construction_linetypes);
}

std::string why_type_ignored(const Record& entity) {
    constexpr int mesh = 16, polyface = 64;
    if (!is_one_of(entity.type, read_types)) {
        for (const Reason& reason : reasons)
            if (std::find(reason.types.begin(), reason.types.end(), entity.type) != reason.types.end())
                return std::string(reason.why);
        return "not read by this version";
    }
    if (entity.type == "POLYLINE" && (entity.integer(70, 0) & (mesh | polyface)) != 0) return "a mesh, not a curve";
    return {};
}

}  // namespace

double tilt(const Record& entity) {
    constexpr double parallel = 1e-9;  // of the normal's components; exporters write 1e-15 or so
    if (!has_own_plane(entity) || !entity.find(230)) return 0;
    const double across = std::hypot(entity.number(210, 0), entity.number(220, 0)), along = std::abs(entity.number(230, 1));
    return across <= parallel * along ? 0 : std::atan2(across, along) * 180 / std::numbers::pi;
}

Look look_of(const Record& entity, const Look& block, const Structure& structure) {
    Look look;
    look.layer = entity.text(8, "0");
    if (look.layer.empty() || look.layer == "0") look.layer = block.layer;
    const auto found = structure.layers.find(upper_case(look.layer));
    const Layer layer = found == structure.layers.end() ? Layer{} : found->second;
    look.frozen = layer.frozen;
    look.off = layer.off;

    const std::string linetype = upper_case(entity.text(6, "BYLAYER"));
    look.linetype = linetype == "BYLAYER" ? upper_case(layer.linetype) : linetype == "BYBLOCK" ? block.linetype : linetype;
    look.is_interrupted = linetype == "BYBLOCK" ? block.is_interrupted : structure.interrupted.contains(look.linetype);
    constexpr int by_block = 0, by_layer = 256;
    const int color = entity.integer(62, by_layer);
    look.color = color == by_block ? block.color : color > by_block && color < by_layer ? color : layer.color;
    return look;
}

bool is_in_paper_space(const Record& entity) {
    return entity.integer(67, 0) == 1;
}

bool is_subentity(const Record& entity) {
    return entity.type == "VERTEX" || entity.type == "ATTRIB" || entity.type == "SEQEND";
}

std::string why_ignored(const Record& entity, const Look& look, const LayerFilter& layers) {
    const auto matches = [&](const std::string& pattern) { return matches_glob(look.layer, pattern); };
    const bool is_asked = std::any_of(layers.only.begin(), layers.only.end(), matches);
    if (look.frozen) return "layer is frozen";
    if (look.off) return "layer is off";
    if (entity.type != "INSERT" && std::any_of(layers.ignore.begin(), layers.ignore.end(), matches))
        return "layer is to be ignored";
    if (entity.type != "INSERT" && !layers.only.empty() && !is_asked) return "layer is not asked for";
    if (entity.integer(60, 0) == 1) return "invisible";
    if (const std::string why = why_type_ignored(entity); !why.empty()) return why;
    if (tilt(entity) > most_tilt) return "not in the drawing's plane";
    if (entity.type == "INSERT") return {};
    if (is_asked) return {};
    if (look.is_interrupted || is_construction_linetype(look.linetype)) return "line type " + look.linetype;
    const auto layer = drafting_layer(look.layer);
    return layer && layer->is_sure ? "layer of " + layer->kind : std::string();
}

bool is_curve(const Record& entity) {
    static const std::array others{"MLINE"sv,    "3DSOLID"sv, "REGION"sv,           "BODY"sv, "SURFACE"sv, "HELIX"sv,
                                   "MPOLYGON"sv, "3DFACE"sv,  "ACAD_PROXY_ENTITY"sv};
    return is_one_of(entity.type, read_types) || is_one_of(entity.type, others);
}

}  // namespace abut::geometry::dxf
