// SPDX-License-Identifier: GPL-3.0-or-later
// Where the tractions of friction act: midway between the bodies, so that those on both leave no couple.
#pragma once
#include "solver/contact/interface.hpp"

namespace abut::solver {

/// From a body's own point to there, in the body's frame: how it moves is that of the point and the body's mean rotation
/// (Turning). Zero of pressures and bonds. Of friction the points have the gap as drawn.
inline Vec2 traction_arm(const Interface& face, const InterfacePoint& p, std::size_t side) {
    if (!face.friction) return {0, 0};
    const Vec2& along = p.normal[side];  // the normal turned left
    return (side == 0 ? 0.5 : -0.5) * p.gap * Vec2(along.y(), -along.x());
}

}  // namespace abut::solver
