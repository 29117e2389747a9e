// SPDX-License-Identifier: GPL-3.0-or-later
// A text as a scene: JSON, expressions, all sections, the geometry of its parts, selections. Files that it imports are not
// there.
#pragma once
#include <algorithm>
#include <set>
#include <string>

#include "src/io/json_document.hpp"
#include "src/scene/read_scene.hpp"
#include "src/scene/scene.hpp"
#include "tests/fuzz/part_faults.hpp"

namespace abut::fuzz {

/// Limits of what is evaluated exactly: with more edges one run takes as long as hundreds of small ones. A circle, an ellipse,
/// a point of a polygon or spline, ... count one each; a Boolean follows ellipses and splines with hundreds of arcs each.
inline constexpr int most_fuzzed_edges = 100;
inline constexpr int most_fuzzed_general_edges = 3;

struct GeometrySize {
    int edges = 0, general_edges = 0;
};

inline void add_size(const JsonValue& value, GeometrySize& size) {
    static const std::set<std::string> general{"ellipse", "elliptic_arc", "bezier", "nurbs"};
    size.edges += value.kind == JsonValue::Kind::object || value.kind == JsonValue::Kind::array;
    size.general_edges += general.contains(value.key);
    for (const JsonValue& item : value.items) add_size(item, size);
}

inline bool is_small(const JsonValue& root) {
    const JsonValue* parts = find_member(root, "parts");
    if (!parts) return true;
    GeometrySize size;
    add_size(*parts, size);
    return size.edges <= most_fuzzed_edges && size.general_edges <= most_fuzzed_general_edges;
}

/// Empty where all is well; a refusal is well.
inline std::string fault_of_scene(const std::string& text) {
    const std::string file = "/there is no such folder/fuzzed.json";
    try {
        if (!is_small(parse_json(text, file).root)) return "";
        const Scene scene = read_scene_text(text, file);
        if (scene.parts.empty()) return "a scene without parts";
        for (const ScenePart& part : scene.parts) {
            const std::string fault = fault_of_part(part.part);
            if (!fault.empty()) return fault;
            if (part.material < 0 || static_cast<std::size_t>(part.material) >= scene.materials.size())
                return "a part without material";
        }
        return "";
    } catch (const InputError& error) { return fault_of_refusal(error); }
}

}  // namespace abut::fuzz
