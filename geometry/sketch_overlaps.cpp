// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch_overlaps.hpp"

#include <algorithm>
#include <array>

#include "geometry/edge_tree.hpp"

namespace abut::geometry {

namespace {

EdgeTree tree_of(const std::vector<SketchEntity>& entities) {
    Part all;
    for (const SketchEntity& entity : entities) all.edges.push_back({entity.curve, {}, {}, true, 0.0});
    return EdgeTree(all);
}

/// Two lines or circles that agree at five points of a stretch, its ends among them, agree on all of it.
bool lies_on(const Curve& curve, const Curve& other, double tolerance) {
    constexpr std::array samples{0.5, 0.0, 1.0, 0.25, 0.75};  // the middle first: it rules out neighbours at once
    return std::all_of(samples.begin(), samples.end(), [&](double t) {
        const Vec2 p = point(curve, t);
        return (point(other, closest_parameter(other, p)) - p).norm() <= tolerance;
    });
}

Repair removal(const SketchEntity& gone, const SketchEntity& kept) {
    return {gone.kind + " " + gone.name + " removed: it lies on " + kept.name, point(gone.curve, 0.5), length(gone.curve)};
}

/// Removes each entity i for which some other j that is still there makes is_redundant(i, j) true.
template <class IsRedundant>
bool remove_redundant(std::vector<SketchEntity>& entities, double tolerance, std::vector<Repair>& repairs,
                      IsRedundant is_redundant) {
    const EdgeTree tree = tree_of(entities);
    std::vector<bool> is_gone(entities.size(), false);
    for (std::size_t i = 0; i < entities.size(); ++i) {
        Box2 middle;
        middle.extend(point(entities[i].curve, 0.5));
        for (int near : tree.near(middle, tolerance)) {
            const auto j = static_cast<std::size_t>(near);
            if (i == j || is_gone[j] || !is_redundant(i, j)) continue;
            is_gone[i] = true;
            repairs.push_back(removal(entities[i], entities[j]));
            break;
        }
    }
    std::size_t i = 0;
    return std::erase_if(entities, [&](const SketchEntity&) { return is_gone[i++]; }) > 0;
}

}  // namespace

void remove_duplicates(std::vector<SketchEntity>& entities, double tolerance, std::vector<Repair>& repairs) {
    remove_redundant(entities, tolerance, repairs, [&](std::size_t i, std::size_t j) {
        return j < i && lies_on(entities[i].curve, entities[j].curve, tolerance) &&
               lies_on(entities[j].curve, entities[i].curve, tolerance);
    });
}

bool remove_covered(std::vector<SketchEntity>& entities, const std::vector<bool>& is_loose, double tolerance,
                    std::vector<Repair>& repairs) {
    return remove_redundant(entities, tolerance, repairs, [&](std::size_t i, std::size_t j) {
        return is_loose[i] && lies_on(entities[i].curve, entities[j].curve, tolerance);
    });
}

}  // namespace abut::geometry
