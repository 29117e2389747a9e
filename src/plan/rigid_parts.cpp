// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plan/rigid_parts.hpp"

#include <algorithm>
#include <cmath>

#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/contact/search_distances.hpp"
#include "src/io/number_text.hpp"
#include "src/plan/loads.hpp"
#include "src/scene/selection.hpp"

namespace abut {

namespace {

const Material& material_of(const Scene& scene, int part) {
    return scene.materials[at(scene.parts[at(part)].material)];
}

bool can_touch(const SearchDistances& distances, int i, int j) {
    return distances.within(i, j, distances.searched(i, j, 1));
}

bool is_on(const Scene& scene, const Selection& selection, int part) {
    const std::vector<EdgePortion> portions = select(scene, selection);
    return std::any_of(portions.begin(), portions.end(), [&](const EdgePortion& p) { return p.part == part; });
}

/// Would a part's own deformation show, however stiff it is? It does where it grows by temperature, rests on springs or has
/// displacements given, and where its own loads bend it between its supports.
bool deforms_by_itself(const Scene& scene, int part) {
    bool held = false, loaded = false;
    for (const Support& s : scene.supports) {
        if (s.part != scene.parts[at(part)].name && !is_on(scene, s.on, part)) continue;
        if (s.kind == Support::Kind::spring || s.kind == Support::Kind::displacement) return true;
        held = held || s.kind == Support::Kind::fix || s.kind == Support::Kind::points;  // the others are guides
    }
    for (const Load& load : scene.loads_of_all_cases.empty() ? scene.loads : scene.loads_of_all_cases) {
        if (is_edge_load(load) ? !is_on(scene, load.on, part) : !acts_on_volume_of(scene, load, part)) continue;
        if (load.kind == Load::Kind::temperature) return true;
        loaded = true;
    }
    return held && loaded;
}

}  // namespace

std::string why_rigid(const Scene& scene, int part) {
    ENSURE(part >= 0 && at(part) < scene.parts.size(), "the part is one of the scene");
    const Material& own = material_of(scene, part);
    if (own.rigid) return "its material is \"rigid\"";
    const auto is_softer = [&](const Material& m) { return own.E > rigid_stiffness_ratio * m.E; };
    if (std::none_of(scene.materials.begin(), scene.materials.end(), is_softer)) return "";
    const SearchDistances distances(scene);
    bool has_neighbour = false;
    for (int j = 0; j < static_cast<int>(scene.parts.size()); ++j) {
        if (j == part) continue;
        const bool softer = is_softer(material_of(scene, j));
        if (!softer && !can_touch(distances, part, j)) continue;
        if (!softer) return "";
        has_neighbour = has_neighbour || can_touch(distances, part, j);
    }
    if (!has_neighbour || deforms_by_itself(scene, part)) return "";
    return "it is stiffer than all that it can touch by more than " + number_text(rigid_stiffness_ratio, 2);
}

}  // namespace abut
