// SPDX-License-Identifier: GPL-3.0-or-later
// Which ends of a drawing's entities belong together, and the entities' curves moved so that they meet there.
#pragma once
#include <vector>

#include "geometry/sketch.hpp"

namespace abut::geometry {

/// One end of an entity: point(curve, 0) or point(curve, 1).
struct EntityEnd {
    int entity;
    bool is_begin;
};

/// Ends that lie together.
struct Joint {
    std::vector<EntityEnd> ends;  ///< in the entities' order
    Vec2 at{0, 0};                ///< where they are to meet
    double gap = 0;               ///< largest distance between two of them as drawn
};

struct Joints {
    std::vector<Joint> joints;
    std::vector<int> at_begin, at_end;  ///< joint by entity; -1 for full circles, which have no ends
};

bool is_full_circle(const Curve& curve);
Vec2 position(const std::vector<SketchEntity>& entities, const EntityEnd& end);

/// Ends within the tolerance of each other, directly or over others between them, become one joint; gaps up to `rounding` are
/// rounding errors. Cost O(n log n).
Joints join_ends(const std::vector<SketchEntity>& entities, double tolerance, double rounding);

/// Moves that are rounding errors are no repairs: this fraction of the largest coordinate.
inline constexpr double rounding_fraction = 1e-12;

/// Moves the curves' ends to their joints. An end of a segment is put there. An arc whose ends move by rounding errors only
/// keeps its centre and radius; otherwise it keeps its radius or, where that would be ill-conditioned, its angle (bulge).
void close_joints(std::vector<SketchEntity>& entities, const Joints& joints, double rounding);

}  // namespace abut::geometry
