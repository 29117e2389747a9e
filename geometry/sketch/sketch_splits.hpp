// SPDX-License-Identifier: GPL-3.0-or-later
// Entities cut where ends of others lie on them.
#pragma once
#include <optional>
#include <vector>

#include "geometry/sketch/sketch_joints.hpp"

namespace abut::geometry {

/// Cuts each entity at the ends of others that lie inside it, if it or the other is among the `troubled`: what closes by itself
/// is not cut because something sound touches it. An end without partner may be off by the tolerance, a joint of several by
/// `coincidence` only: beyond that is a clearance. No cut is made at an entity's own joints. Each cut is a repair
/// (size: how far the end is off). Pieces stand where the entity stood, named `h2F#0`, `h2F#1`, ... along it. Returns whether
/// anything was cut.
bool split_at_ends(std::vector<SketchPiece>& entities, const Joints& joints, const std::vector<bool>& troubled,
                   double tolerance, double coincidence, std::vector<Repair>& repairs);

/// Which lines are cut where they cross.
enum class CrossingLines { none, upright, all };

/// Cuts entities among the given ones where they cross, touch or end on each other: upright segments only, as the lines of a
/// table do, or all (`which`). Returns whether any did.
bool split_at_crossings(std::vector<SketchPiece>& entities, const std::vector<int>& among, CrossingLines which,
                        double coincidence, std::vector<Repair>& repairs);

/// Two entities that cross, or of which one touches or ends on the other away from the other's ends.
struct CrossingPair {
    int entity, other;
    Vec2 at;
};
/// The first pair among the given entities.
std::optional<CrossingPair> first_crossing(const std::vector<SketchPiece>& entities, const std::vector<int>& among,
                                           double coincidence);

}  // namespace abut::geometry
