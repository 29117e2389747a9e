// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/curves/vec2.hpp"

namespace abut {

using geometry::Vec2;

/// The frame of a part's grid: local = turned by -angle, then moved by -shift. Parts are computed near the origin of their own
/// frame, so that an answer does not depend on where in the assembly they are drawn.
struct Frame {
    double c = 1, s = 0;  ///< cosine and sine of the grid's angle
    Vec2 shift{0, 0};     ///< in the turned coordinates

    Vec2 turned(const Vec2& p) const { return {c * p.x() + s * p.y(), -s * p.x() + c * p.y()}; }
    Vec2 vector_to_local(const Vec2& v) const { return turned(v); }
    Vec2 vector_to_global(const Vec2& v) const { return {c * v.x() - s * v.y(), s * v.x() + c * v.y()}; }
    Vec2 to_local(const Vec2& p) const { return turned(p) - shift; }
    Vec2 to_global(const Vec2& p) const { return vector_to_global(p + shift); }
};

}  // namespace abut
