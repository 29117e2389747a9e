// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/results/displacement_from_drawn.hpp"

#include <cmath>

#include "geometry/brep/part.hpp"

namespace abut {

ValueAt displacement_from_drawn(const Result& result, std::size_t i) {
    const PartResult& part = result.parts[i];
    if (!part.placement) return part.max_displacement;
    const Vec2 there = geometry::centroid(result.geometry[i]), &by = part.placement->translation;
    const double c = std::cos(part.placement->rotation), s = std::sin(part.placement->rotation);
    ValueAt largest;
    const auto look_at = [&](const Vec2& at, const Vec2& displacement) {
        const Vec2 arm = at - there, drawn_arm(c * arm.x() + s * arm.y(), c * arm.y() - s * arm.x());
        const double distance = (arm - drawn_arm + by + displacement).norm();
        if (distance > largest.value) largest = {distance, at};
    };
    if (i < result.fields.size() && !result.fields[i].boundary.empty()) {
        for (const std::vector<FieldSample>& loop : result.fields[i].boundary)
            for (const FieldSample& sample : loop) look_at(sample.at, sample.displacement);
    } else {  // moved, and nothing acts on it there
        for (const geometry::Edge& edge : result.geometry[i].edges)
            for (const double t : {0.0, 0.25, 0.5, 0.75}) look_at(point(edge.curve, t), {0, 0});
    }
    return largest;
}

}  // namespace abut
