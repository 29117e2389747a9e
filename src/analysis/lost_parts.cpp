// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/lost_parts.hpp"

#include <cmath>

#include "src/analysis/follow_ends.hpp"
#include "src/analysis/placement.hpp"
#include "src/base/index.hpp"
#include "src/io/number_text.hpp"

namespace abut {

void tell_lost(const Scene& scene, SolvedAssembly& solved) {
    if (!is_solved(solved)) return;
    for (std::size_t k = 0; k < solved.grids.size(); ++k) {
        const solver::RigidMotion motion = rigid_motion_of(solved, k);
        const double farthest = motion.translation.norm(), turn = std::abs(motion.rotation);
        if (farthest <= solved.grids[k].size && turn <= 1) continue;
        const std::string& name = scene.parts[at(solved.grids[k].part)].name;
        solved.is_lost = std::isfinite(farthest + turn);
        solved.failure =
            solved.is_lost
                ? "part " + name +
                      (turn > 1 ? " turns by more than a radian"
                                : " moves by " + number_text(farthest, 3) + ", more than its own size,") +
                      " before anything holds it: it slides or tips. Add a support, or draw it where it comes to rest"
                : "the solution of part " + name +
                      " is no number: a place in it asks for cells that coordinates hardly tell apart. Ask for less "
                      "accuracy, or round the corner where contact ends";
        return;
    }
}

}  // namespace abut
