// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/tipping.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/proximity/facing.hpp"
#include "src/answers/motion_text.hpp"
#include "src/base/index.hpp"

namespace abut {

namespace {

constexpr double nearest = 1e-3;     // of a zone's length: nearer to its end nobody asks
constexpr double of_distance = 0.5;  // the next cells: the last spline's middle is within them

/// The centre of the motion of a contact's second part against its first; nothing where it only slides.
std::optional<Vec2> relative_pivot(const std::vector<PartTwist>& twists, const Candidate& c) {
    Eigen::Vector3d motion(0, 0, 0);
    for (const PartTwist& t : twists) {
        if (t.part == c.first) motion -= Eigen::Vector3d(t.twist[0], t.twist[1], t.twist[2]);
        if (t.part == c.second) motion += Eigen::Vector3d(t.twist[0], t.twist[1], t.twist[2]);
    }
    if (!(std::abs(motion[2]) > 0)) return std::nullopt;
    return Vec2(-motion[1] / motion[2], motion[0] / motion[2]);
}

}  // namespace

bool add_tipping_ends(const Scene& scene, const std::vector<Candidate>& candidates, const SolvedAssembly& now,
                      WantedSizes& wanted) {
    const std::vector<PartTwist> twists = twists_of(now, now.solution.mechanism);
    bool any = false;
    for (std::size_t k = 0; k < candidates.size() && k < now.contacts.size(); ++k) {
        const Candidate& c = candidates[k];
        const std::vector<double>& knots = now.contacts[k].face.pressure.breakpoints;
        const std::optional<Vec2> pivot = relative_pivot(twists, c);
        if (!pivot || knots.size() < 2) continue;
        const auto look_at = [&](double s1, double s2, double cell) {
            const geometry::FacingPair end =
                pair_from_first(scene.parts[at(c.first)].part, scene.parts[at(c.second)].part, c.zone, s1, s2);
            // along the contact: the resultant is straight against it, wherever on its line the part turns
            const double distance = std::abs(geometry::cross(end.on1.x - *pivot, end.normal));
            if (!end.found || distance > cell || distance <= nearest * (knots.back() - knots.front())) return;
            for (const int part : {c.first, c.second})
                wanted[at(part)].push_back({{end.on1.x}, of_distance * distance, size_growth});
            any = true;
        };
        look_at(c.zone.begin1, c.zone.begin2, knots[1] - knots[0]);
        look_at(c.zone.end1, c.zone.end2, knots.back() - knots[knots.size() - 2]);
    }
    return any;
}

}  // namespace abut
