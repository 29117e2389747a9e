// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that supports lead, on their way: how far they still have to go, and what they press on where something stops them.
#pragma once
#include <vector>

#include "src/motion/moving_parts.hpp"
#include "src/motion/placement.hpp"

namespace abut {

/// The leads of a scene's parts, and which of them something has stopped.
class LedParts {
public:
    /// Leads, centroids, sizes and bodies are listed by part, as drawn.
    LedParts(std::vector<Lead> leads, std::vector<Vec2> centers, std::vector<double> sizes, std::vector<int> bodies);

    /// Is any part led anywhere?
    bool any() const;
    /// Is a part led, or one that it is bonded to?
    bool is_led(std::size_t part) const;
    /// Is a part still on its way, from no place in particular?
    bool has_way(std::size_t part) const;

    /// What is still to come of the prescribed motions.
    std::vector<Lead> left(const std::vector<Placement>& placements) const;
    /// A share of the same, no farther than `reach` of the longest step: parts go side by side, and are there together.
    std::vector<Lead> of_step(const std::vector<Placement>& placements, double share, double reach) const;
    bool are_there(const std::vector<Placement>& placements) const;
    /// How far any part still has to go, turns measured at its half size.
    double farthest_left(const std::vector<Placement>& placements) const;
    /// Meets prescribed motions exactly; bonded parts go where one of them is led.
    void end(std::vector<Placement>& placements) const;

    /// Parts that do not get there by rigid motions, since something stops them, press on that: from here on they are pushed as
    /// loads would, and what is left of the way is for the bodies to give in. step: amplitudes; share: of what is asked, by
    /// which small parts cut the step short; it counts for parts that a push has taken to their end. least_way: of a part's
    /// size, from where on it counts. Is any of them new?
    bool push_where_blocked(const MovingParts& moving, const Eigen::VectorXd& step, const std::vector<Lead>& asked,
                            double share, double least_way = arrived_fraction);
    /// What gives way would let a step take a pushed part farther than it is led: it is led again from here. Does any push end?
    bool end_pushes(const MovingParts& moving, const Eigen::VectorXd& step, const std::vector<Placement>& placements);
    /// Adds the pushes to the loads.
    void act_on(MovingParts& moving) const;

private:
    Eigen::Vector3d gone(std::size_t part, const Placement& placement) const;
    double way_of(std::size_t part, const Lead& lead) const;
    double steps_to(std::size_t part, const Lead& lead) const;

    std::vector<Lead> leads_;
    std::vector<Vec2> centers_;
    std::vector<double> sizes_;
    std::vector<int> bodies_;
    std::vector<Eigen::Vector3d> pushes_;  // by part: forces and moments in place of leads that something stops
    std::vector<char> gets_there_;         // by part: a push has taken it to its end
};

}  // namespace abut
