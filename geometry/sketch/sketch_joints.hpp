// SPDX-License-Identifier: GPL-3.0-or-later
// Which ends of a drawing's entities belong together, and the entities' curves moved so that they meet there.
#pragma once
#include <vector>

#include "geometry/sketch/sketch_piece.hpp"

namespace abut::geometry {

/// One end of an entity: point(curve, 0) or point(curve, 1).
struct EntityEnd {
    int entity;
    bool is_begin;
};

/// A joint: ends of entities that lie together.
struct Joint {
    std::vector<EntityEnd> ends;  ///< in the entities' order
    Vec2 at{0, 0};                ///< where they are to meet
    double gap = 0;               ///< how far apart they are drawn
};

/// All joints of a drawing, and which of them each entity ends at.
struct Joints {
    std::vector<Joint> joints;
    std::vector<int> at_begin, at_end;  ///< joint by entity; -1 for full circles and ellipses, which have no ends
};

/// Is the curve a circle or an ellipse all around?
bool is_full_turn(const Curve& curve);
/// The point that an entity's end is drawn at.
Vec2 position(const std::vector<SketchPiece>& entities, const EntityEnd& end);

/// The unit vector along which an entity leaves its end, away from it into the entity.
Vec2 leaving_direction(const SketchPiece& entity, bool is_begin);
/// Ends that leave in the same direction but for the angle of this cosine lie side by side, on both sides of a clearance.
inline constexpr double side_by_side_cosine = 0.99;

/// Ends within the tolerance of each other become one joint, the nearest first, and so that outlines stay apart:
///   1. What lies within `rounding` is one.
///   2. Ends without a partner find the nearest of their kind that is not side by side with them.
///   3. Joints of two ends or more are joined within `coincidence` only: beyond it is no careless joint but the clearance
///   between
///      two outlines.
///   4. Ends that are left without a partner join the nearest joint, one to each: two would be an outline with a gap on either
///      side of another's corner.
/// Cost O(n log n) for ends that are spread out.
Joints join_ends(const std::vector<SketchPiece>& entities, double tolerance, double coincidence, double rounding);

/// Moves that are rounding errors are no repairs: this fraction of the largest coordinate.
inline constexpr double rounding_fraction = 1e-12;

/// Moves the curves' ends to their joints. An end of a segment is put there. An arc whose ends move by rounding errors only
/// keeps its centre and radius; otherwise it keeps its radius or, where that would be ill-conditioned, its angle (bulge).
/// Ellipses and splines are turned and scaled a little as a whole.
void close_joints(std::vector<SketchPiece>& entities, const Joints& joints, double rounding);

}  // namespace abut::geometry
