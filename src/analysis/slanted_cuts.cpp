// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/slanted_cuts.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/brep/part.hpp"
#include "geometry/curves/curve.hpp"
#include "src/io/number_text.hpp"
#include "src/results/findings.hpp"
#include "src/scene/accuracy_goal.hpp"

namespace abut {

namespace {

/// The angle between the normal of a cut and the mean direction of the part's sides there, radians; 0: it meets none.
double slant_of(const geometry::Part& part, const std::array<Vec2, 2>& across) {
    const Vec2 along = (across[1] - across[0]).normalized();
    const auto turned = [&](const Vec2& x) { return Vec2(along.dot(x), geometry::cross(along, x)); };
    const double from = turned(across[0]).x(), to = turned(across[1]).x(), height = turned(across[0]).y();
    Vec2 sides(0, 0);
    for (const geometry::Edge& edge : geometry::transformed(part, along.x(), -along.y(), {0, 0}).edges)
        for (const double t : geometry::crossings(edge.curve, 1, height)) {
            const double x = point(edge.curve, t).x();
            if (x < from || x > to) continue;
            const Vec2 side = geometry::unit_tangent(edge.curve, t);
            sides += side.y() < 0 ? Vec2(-side) : side;
        }
    return sides.isZero(0) ? 0 : std::atan2(std::abs(sides.x()), sides.y());
}

}  // namespace

void warn_of_slanted_cuts(const Scene& scene, Result& result) {
    std::vector<Finding> findings;
    for (const Load& load : scene.loads) {
        if (load.kind != Load::Kind::preload) continue;
        for (const ScenePart& part : scene.parts) {
            const double slant = part.name == load.part ? slant_of(part.part, load.across) : 0, more = 1 / std::cos(slant) - 1;
            if (!(more > target_of(scene.accuracy))) continue;
            findings.push_back({more, part.name,
                                "the line that part " + part.name + " is tightened across is " +
                                    number_text(slant * 180 / std::numbers::pi, 2) +
                                    " degrees off square to its sides: the force is that along the line's normal, and the part "
                                    "presses with " +
                                    percent_text(more) + " more along itself; draw the line right across it"});
        }
    }
    remark(std::move(findings), result);
}

}  // namespace abut
