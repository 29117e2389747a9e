// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>

#include "geometry/curves/curve.hpp"

namespace abut::geometry {

/// Two parameters of one curve, t0 < t1, whose points are one within the tolerance.
struct SelfMeeting {
    double t0 = 0, t1 = 0;
    Vec2 at{0, 0};
    bool crosses = false;  ///< the curve goes through itself; otherwise it touches itself or runs back over itself
};

/// The first place along the curve where it meets itself, if there is one; where a closed curve begins and ends is none. Only
/// splines can: lines and less than a full turn of circles and ellipses do not. Cost O(n log n) for n monotone pieces that
/// are spread out.
std::optional<SelfMeeting> self_meeting(const Curve& curve, double tolerance);

}  // namespace abut::geometry
