// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plan/inclined_cuts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/base/index.hpp"
#include "src/io/number_text.hpp"

namespace abut {

namespace {

constexpr double noted_angle = 3, parallel_angle = 1;  // degrees

/// The angles (degrees, -90 to 90) from square of the edges that a cut goes through.
std::vector<double> angles_at(const geometry::Part& part, const std::array<Vec2, 2>& across) {
    const Vec2 d = across[1] - across[0], along = d.normalized();
    const double c = along.x(), s = -along.y();  // of the turn that lays the cut along the x axis, from the origin on
    const Vec2 start(c * across[0].x() - s * across[0].y(), s * across[0].x() + c * across[0].y());
    const geometry::Part turned = geometry::transformed(part, c, s, -start);
    std::vector<double> angles;
    for (const geometry::Edge& edge : turned.edges)
        for (const double t : geometry::crossings(edge.curve, 1, 0)) {
            const double x = point(edge.curve, t).x();
            if (x < 0 || x > d.norm()) continue;
            const Vec2 direction = derivative(edge.curve, t);
            angles.push_back(std::atan(direction.x() / direction.y()) * 180 / std::numbers::pi);
        }
    return angles;
}

}  // namespace

std::vector<std::string> inclined_cuts(const Scene& scene) {
    std::vector<std::string> told;
    for (const Load& load : scene.loads) {
        if (load.kind != Load::Kind::preload) continue;
        const auto own =
            std::find_if(scene.parts.begin(), scene.parts.end(), [&](const ScenePart& p) { return p.name == load.part; });
        if (own == scene.parts.end()) continue;
        const std::vector<double> angles = angles_at(own->part, load.across);
        if (angles.size() < 2) continue;
        const auto [least, most] = std::minmax_element(angles.begin(), angles.end());
        const double angle = std::min(std::abs(*least), std::abs(*most));
        if (*most - *least > parallel_angle || angle < noted_angle) continue;
        told.push_back(load.where + ": the cut through " + load.part + " is " + number_text(angle, 2) +
                       " degrees off square to its edges: the force is that across the cut, and along " + load.part +
                       " it is " + number_text(1 / std::cos(angle * std::numbers::pi / 180), 3) +
                       " times as large; draw the cut square to it, if it is to be the force along it");
    }
    return told;
}

}  // namespace abut
