// SPDX-License-Identifier: GPL-3.0-or-later
// Edges of `loops` that are neither lines nor circular arcs.
#pragma once
#include <optional>
#include <vector>

#include "geometry/curves/curve.hpp"
#include "src/scene/scene_fields.hpp"

namespace abut {

/// Each of these reads the value of the key it is named for: one curve, or the smooth pieces of one in their order. Empty where
/// the value is wrong (reported).
std::vector<geometry::Curve> read_elliptic_arc(SceneReading& reading, const JsonValue& value);
std::vector<geometry::Curve> read_bezier(SceneReading& reading, const JsonValue& value);
std::vector<geometry::Curve> read_nurbs(SceneReading& reading, const JsonValue& value);

/// Reads two half axes, both positive.
std::optional<Vec2> read_radii(SceneReading& reading, const JsonValue& value);

}  // namespace abut
