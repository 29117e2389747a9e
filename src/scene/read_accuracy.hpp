// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/scene/scene.hpp"
#include "src/scene/scene_fields.hpp"

namespace abut {

/// Reads the value of "accuracy".
Accuracy read_accuracy(SceneReading& reading, const JsonValue& accuracy);

/// Reads the value of "grids": the spline grids of parts, by part.
std::map<std::string, GridOptions> read_grids(SceneReading& reading, const JsonValue& grids);

/// The spline degrees that are possible.
inline constexpr int least_degree = 1, most_degree = 6;

}  // namespace abut
