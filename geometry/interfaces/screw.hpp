// SPDX-License-Identifier: GPL-3.0-or-later
// Screws in the plane: what a body can do, and what holds it [Grishin10, section 2.2].
//
// A twist (vx, vy, w) is a small motion: v is the velocity of the body point at the origin, w the rotation. A wrench
// (fx, fy, m) is a force with its moment about the origin. They are reciprocal where fx vx + fy vy + m w = 0: the wrench does
// no work in the twist. (The dissertation's rows of six, T = {w, v} and W = {f, m}, need one of their halves swapped for this
// product; in the plane T = (0, 0, w, vx, vy, 0) and W = (fx, fy, 0, 0, 0, m).)
#pragma once
#include <vector>

#include "geometry/curves/vec2.hpp"

namespace abut::geometry {

/// Three coordinates of a twist (vx, vy, w) or of a wrench (fx, fy, m).
using Screw = Eigen::Vector3d;

/// A force of unit size along `direction` through a point.
inline Screw force_through(const Vec2& point, const Vec2& direction) {
    return {direction.x(), direction.y(), cross(point, direction)};
}

/// Where the arm of moments is measured: about which point, and in which unit of length.
struct ScrewScale {
    Vec2 center{0, 0};
    double size = 1;
};

/// Screws that are dependent to this fraction of the largest count as dependent, with moments measured about the scale's centre
/// in its size: above the six digits of drawings, below any arm that holds something.
inline constexpr double screw_rank_fraction = 1e-5;

/// The space that the wrenches span, by at most three of them in a readable form: unit forces with their moments, and a pure
/// moment where two of them are parallel: {}, {f}, {m}, {f, m}, {fx, fy} or {fx, fy, m}.
std::vector<Screw> wrench_space(const std::vector<Screw>& wrenches, const ScrewScale& scale);

/// The motions that these wrenches leave free: {}, a translation, a rotation, a rotation and a translation across the line from
/// the origin to its pole, two translations, or all three.
std::vector<Screw> twist_space(const std::vector<Screw>& wrenches, const ScrewScale& scale);

/// The space of motions that some twists span, in the readable form of twist_space.
std::vector<Screw> span_of_twists(const std::vector<Screw>& twists, const ScrewScale& scale);

/// A wrench on one body, and its opposite on another or on the ground (other = -1).
struct Connection {
    int body = 0, other = -1;
    Screw wrench{0, 0, 0};
};

/// What connections leave bodies to do.
struct Mobility {
    int degrees_of_freedom = 0;  ///< 3 bodies - rank of the connections
    int gruebler = 0;            ///< 3 bodies - connections: the count on one's fingers, negative where over-constrained
    int redundant = 0;           ///< connections - rank
    std::vector<std::vector<Screw>> free;  ///< by body: the twists it has in all motions that the connections leave
};

/// The motions that bodies have under their connections, which count as two-sided. Cost: of order (3 bodies)^3.
Mobility mobility(int n_bodies, const std::vector<Connection>& connections, const ScrewScale& scale);

}  // namespace abut::geometry
