// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/contact/drawn_overlap.hpp"

#include <algorithm>

#include "src/io/number_text.hpp"
#include "src/results/result_units.hpp"

namespace abut {

namespace {

/// Rounding of areas.
constexpr double whole_fraction = 1e-6;

std::string edge_text(const ScenePart& part, int edge) {
    return part.name + "/" + part.part.edges[static_cast<std::size_t>(edge)].name;
}

/// Is one of the parts all within the other's material?
bool same_place(const Scene& scene, const Encounter& m) {
    const double smaller = std::min(area(scene_part(scene, m.first).part), area(scene_part(scene, m.second).part));
    return m.overlap->area >= (1 - whole_fraction) * smaller;
}

}  // namespace

std::string overlap_text(const Scene& scene, const Encounter& m) {
    const ScenePart &a = scene_part(scene, m.first), &b = scene_part(scene, m.second);
    const geometry::Overlap& o = *m.overlap;
    return std::string(same_place(scene, m) ? "lie in the same place" : "overlap") + " by up to " +
           with_unit(o.depth, 4, scene.length_unit) + " at " + edge_text(a, o.edge1) + " and " + edge_text(b, o.edge2) +
           " near " + pair_text(o.at, 4) + ", area " + number_text(o.area, 4);
}

std::string overlap_hint(const Scene& scene, const Encounter& m) {
    if (!m.too_deep) return "move them apart, or set contacts.overlap to \"press_fit\" or \"ignore\"";
    return "move them apart, cut the one out of the other, give each its own \"level\" where they lie above each other, or "
           "leave "
           "them to overlap by contacts.pairs {\"between\": [\"" +
           scene_part(scene, m.first).name + "/*\", \"" + scene_part(scene, m.second).name + "/*\"], \"kind\": \"ignore\"}";
}

void check_overlaps(const Scene& scene, const std::vector<Encounter>& encounters, std::vector<Problem>& problems) {
    const bool any = scene.contacts.overlap == "report";
    for (const Encounter& m : encounters) {
        if (!m.is_refused) continue;
        const ScenePart &a = scene_part(scene, m.first), &b = scene_part(scene, m.second);
        const std::string why_not = any                                     ? ""
                                    : scene.contacts.overlap == "press_fit" ? ": no press fit, which small strains could close"
                                                                            : ": too deep to count as touching";
        problems.push_back(
            {a.where, "parts " + a.name + " and " + b.name + " " + overlap_text(scene, m) + why_not, overlap_hint(scene, m)});
    }
}

}  // namespace abut
