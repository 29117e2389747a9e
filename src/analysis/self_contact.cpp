// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/self_contact.hpp"

#include <algorithm>

#include "geometry/proximity/facing.hpp"
#include "solver/terms/solution_structure.hpp"
#include "src/analysis/placement.hpp"
#include "src/base/index.hpp"
#include "src/contact/search_distances.hpp"

namespace abut {

namespace {

constexpr int gaps_of_zone = 64;

/// A part in a solution.
class DeformedPart {
public:
    DeformedPart(const Scene& scene, const SolvedAssembly& solved, std::size_t grid)
        : part_(part_of(scene, solved.grids[grid].part)),
          grid_(solved.grids[grid]),
          displacement_(solved.solution.displacement[grid]),
          reach_(solver::largest_displacement(grid_.input, elastic(solved, grid))) {}

    /// Two points of it come nearer to each other by no more than twice what it deforms by.
    bool closes() const {
        const double rounding = touching_length(part_, part_);
        for (const geometry::FacingZone& zone : find_own_facing_zones(part_, std::max(2 * reach_, rounding)))
            if (least_gap(zone) < -rounding) return true;
        return false;
    }

private:
    static Eigen::VectorXd elastic(const SolvedAssembly& solved, std::size_t grid) {
        const solver::PartSystem& system = solved.problem.parts[grid];
        const Eigen::VectorXd& u = solved.solution.displacement[grid];
        return u - system.modes * rigid_amplitudes_of(solved, grid);
    }

    double least_gap(const geometry::FacingZone& zone) const {
        double least = zone.gap_min, guess = zone.begin2;
        for (int k = 0; k <= gaps_of_zone; ++k) {
            const double s = zone.begin1 + (zone.end1 - zone.begin1) * k / gaps_of_zone;
            const geometry::FacingPair pair = pair_from_first(part_, part_, zone, s, guess);
            if (!pair.found) continue;
            guess = pair.s2;
            least = std::min(least, pair.gap + pair.normal.dot(moved(pair.on2) - moved(pair.on1)));
        }
        return least;
    }

    Vec2 moved(const geometry::ChainPoint& p) const {
        return grid_.frame.vector_to_global(
            solver::displacement_at(grid_.input, displacement_, element_of(grid_, p), grid_.frame.to_local(p.x)).value);
    }

    const geometry::Part& part_;
    const PartOnGrid& grid_;
    const Eigen::VectorXd& displacement_;
    double reach_;
};

}  // namespace

std::set<int> closed_on_themselves(const Scene& scene, const SolvedAssembly& solved) {
    std::set<int> closed;
    // a part may be lost for no other reason than that another goes through itself
    const bool has_moved = solved.failure.empty() || solved.is_lost;
    if (!scene.contacts.detect || !has_moved || !solved.solution.mechanism.empty() ||
        solved.solution.displacement.size() != solved.grids.size())
        return closed;
    const std::set<int> known = parts_with_themselves(scene.contacts);
    for (std::size_t k = 0; k < solved.grids.size(); ++k)
        if (const int part = solved.grids[k].part;
            !solved.grids[k].is_rigid && !known.contains(part) && DeformedPart(scene, solved, k).closes())
            closed.insert(part);
    return closed;
}

}  // namespace abut
