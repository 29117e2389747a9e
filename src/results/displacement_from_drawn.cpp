// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/results/displacement_from_drawn.hpp"

#include <cmath>

#include "geometry/brep/part.hpp"

namespace abut {

ValueAt displacement_from_drawn(const Result& result, std::size_t i) {
    const PartResult& part = result.parts[i];
    if (!part.placement || i >= result.fields.size() || result.fields[i].boundary.empty()) return part.max_displacement;
    const Vec2 there = geometry::centroid(result.geometry[i]), &by = part.placement->translation;
    const double c = std::cos(part.placement->rotation), s = std::sin(part.placement->rotation);
    ValueAt largest;
    for (const std::vector<FieldSample>& loop : result.fields[i].boundary)
        for (const FieldSample& sample : loop) {
            const Vec2 arm = sample.at - there, drawn_arm(c * arm.x() + s * arm.y(), c * arm.y() - s * arm.x());
            const double distance = (arm - drawn_arm + by + sample.displacement).norm();
            if (distance > largest.value) largest = {distance, sample.at};
        }
    return largest;
}

}  // namespace abut
