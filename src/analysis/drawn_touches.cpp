// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/drawn_touches.hpp"

#include "geometry/interfaces/interface_kind.hpp"
#include "src/base/index.hpp"
#include "src/contact/candidates.hpp"
#include "src/contact/drawn_overlap.hpp"
#include "src/results/findings.hpp"
#include "src/results/result_units.hpp"

namespace abut {

namespace {

std::string names_of(const Scene& scene, const Encounter& m) {
    return scene.parts[at(m.first)].name + " and " + scene.parts[at(m.second)].name + " ";
}

bool is_unpaired(const Scene& scene, const Encounter& m) {
    const geometry::Part &a = scene.parts[at(m.first)].part, &b = scene.parts[at(m.second)].part;
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

/// The displacement of a place on a part's boundary.
Vec2 displacement_of(const SolvedAssembly& solved, int part, const Vec2& place) {
    const int k = solved.solver_part[at(part)];
    if (k < 0) return {0, 0};
    const PartOnGrid& g = solved.grids[at(k)];
    const Vec2 local = g.frame.to_local(place);
    const int element = element_at(g.local, g.cells, g.elements, local);
    return g.frame.vector_to_global(displacement_at(g.input, solved.solution.displacement[at(k)], element, local).value);
}

/// How deep two parts go into each other where an edge of one touches a face of the other, or less than nothing. Faces that
/// move along each other do so by rounding.
double depth_at(const Scene& scene, const SolvedAssembly& solved, const Encounter& m) {
    constexpr double rounding = 1e-6;  // of how far they move
    const geometry::ClosestPoints& c = *m.closest;
    const geometry::Part& first = scene.parts[at(m.first)].part;
    const bool has_first_face = !is_convex_corner(first, c.edge1, c.t1);
    const Vec2 normal = has_first_face ? outward_normal(first.edges[at(c.edge1)].curve, c.t1)
                                       : Vec2(-outward_normal(scene.parts[at(m.second)].part.edges[at(c.edge2)].curve, c.t2));
    const Vec2 u1 = displacement_of(solved, m.first, c.x1), u2 = displacement_of(solved, m.second, c.x2);
    return normal.dot(u1 - u2) - rounding * (u1.norm() + u2.norm());
}

}  // namespace

std::string unpaired_touches(const Scene& scene) {
    return unpaired_of(scene, find_encounters(scene, 1));
}

void warn_of_drawn_touches(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    const std::vector<Encounter> encounters = find_encounters(scene, 1);
    std::vector<Finding> pressed;
    for (const Encounter& m : encounters) {
        if (!is_unpaired(scene, m)) continue;
        const double depth = depth_at(scene, solved, m);
        if (depth <= 0) continue;
        const std::string who = names_of(scene, m) + "go into each other by " + with_unit(depth, 2, scene.length_unit) +
                                " at " + pair_text(m.closest->x1, 4);
        pressed.push_back(
            {depth, names_of(scene, m) + "at " + pair_text(m.closest->x1, 4),
             who + ", where a sharp edge, of whose faces none opposes the other's within 60 degrees, is no contact", who});
    }
    tell(std::move(pressed), "missed_contact", result);
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
