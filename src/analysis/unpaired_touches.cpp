// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/unpaired_touches.hpp"

#include "geometry/interfaces/interface_kind.hpp"
#include "src/contact/candidates.hpp"
#include "src/results/result_units.hpp"

namespace abut {

void warn_of_unpaired_touches(const Scene& scene, Result& result) {
    std::vector<std::string> places;
    for (const Meeting& m : find_meetings(scene, 1)) {
        const ScenePart &a = scene.parts[static_cast<std::size_t>(m.first)],
                        &b = scene.parts[static_cast<std::size_t>(m.second)];
        if (!m.unpaired || m.overlap || m.closest->distance > touching_length(a.part, b.part)) continue;
        const geometry::ClosestPoints& c = *m.closest;
        if (is_convex_corner(a.part, c.edge1, c.t1) && is_convex_corner(b.part, c.edge2, c.t2)) continue;
        places.push_back(a.name + " and " + b.name + " at " + pair_text(c.x1, 4));
    }
    if (places.empty()) return;
    result.warnings.push_back(
        "parts touch where no faces oppose each other, and nothing keeps them from pressing into each "
        "other there: " +
        joined(places, "; ") + "; round the corner, or support the part");
}

}  // namespace abut
