// SPDX-License-Identifier: GPL-3.0-or-later
// The scene's supports and loads: what they act on, and how they are named and drawn. support_sets.hpp and load_vector.hpp turn
// them into what the solver takes.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "src/results/result.hpp"
#include "src/scene/selection.hpp"

namespace abut {

/// Line that a scene is its own mirror image about.
struct MirrorLine {
    Vec2 point{0, 0}, along{0, 1};  ///< along: unit, one of the axes
    std::vector<int> image;         ///< by part: its mirror image, maybe itself

    int reversed() const { return along.x() == 0 ? 0 : 1; }  ///< the axis whose direction it reverses
    Vec2 turned(const Vec2& v) const { return 2 * v.dot(along) * along - v; }
    Vec2 image_of(const Vec2& p) const { return point + turned(p - point); }
};

/// The scene's selections turned into portions of edges, once for all grids.
struct ResolvedConditions {
    std::vector<std::vector<EdgePortion>> supports, loads;  ///< parallel to Scene::supports, Scene::loads
    std::optional<MirrorLine> mirror{};                     ///< that the solution is to make use of
};
ResolvedConditions resolve_conditions(const Scene& scene);

/// Does anything act on the part: a load, a prescribed displacement that is not zero?
bool is_driven(const Scene& scene, const ResolvedConditions& conditions, int part);

/// The label of a support for tables: "fix x, y on base/hA16".
std::string support_label(const Scene& scene, int support);

/// The marks of supports and loads for the pictures: points along the edges, directions (condition_marks.cpp).
std::vector<SupportMark> support_marks(const Scene& scene, const ResolvedConditions& conditions);
std::vector<LoadMark> load_marks(const Scene& scene, const ResolvedConditions& conditions);

}  // namespace abut
