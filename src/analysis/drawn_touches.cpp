// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/drawn_touches.hpp"

#include "geometry/interfaces/interface_kind.hpp"
#include "src/contact/candidates.hpp"
#include "src/contact/drawn_overlap.hpp"
#include "src/results/result_units.hpp"

namespace abut {

namespace {

std::string names_of(const Scene& scene, const Encounter& m) {
    return scene.parts[static_cast<std::size_t>(m.first)].name + " and " +
           scene.parts[static_cast<std::size_t>(m.second)].name + " ";
}

bool is_unpaired(const Scene& scene, const Encounter& m) {
    const geometry::Part &a = scene.parts[static_cast<std::size_t>(m.first)].part,
                         &b = scene.parts[static_cast<std::size_t>(m.second)].part;
    if (!m.unpaired || m.overlap || m.closest->distance > touching_length(a, b)) return false;
    const geometry::ClosestPoints& c = *m.closest;
    return !is_convex_corner(a, c.edge1, c.t1) || !is_convex_corner(b, c.edge2, c.t2);
}

std::string unpaired_of(const Scene& scene, const std::vector<Encounter>& encounters) {
    std::vector<std::string> unpaired;
    for (const Encounter& m : encounters)
        if (is_unpaired(scene, m)) unpaired.push_back(names_of(scene, m) + "at " + pair_text(m.closest->x1, 4));
    return abut::joined(unpaired, "; ");
}

}  // namespace

std::string unpaired_touches(const Scene& scene) {
    return unpaired_of(scene, find_encounters(scene, 1));
}

void warn_of_drawn_touches(const Scene& scene, Result& result) {
    const std::vector<Encounter> encounters = find_encounters(scene, 1);
    const std::string unpaired = unpaired_of(scene, encounters);
    std::vector<std::string> overlapping;
    for (const Encounter& m : encounters)
        if (m.overlap && m.counts_as_touching) overlapping.push_back(names_of(scene, m) + overlap_text(scene, m));
    if (!unpaired.empty())
        result.warnings.push_back(
            "parts touch where no faces oppose each other, and nothing keeps them from pressing into each "
            "other there: " +
            unpaired + "; round the corner, or support the part");
    if (!overlapping.empty())
        result.warnings.push_back("parts overlap by no more than a drawing is precise to, and are taken as touching there: " +
                                  joined(overlapping, "; ") +
                                  "; what parts that are held on both sides press by is uncertain by as much; contacts.overlap "
                                  "\"press_fit\" presses them apart instead");
}

}  // namespace abut
