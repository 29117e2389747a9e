// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/scene/scene.hpp"
#include "src/scene/scene_fields.hpp"

namespace abut {

/// Reads the value of "output".
Output read_output(SceneReading& reading, const JsonValue& output);

/// Reads "expect", the answers that are known.
std::vector<Expectation> read_expectations(SceneReading& reading, const JsonValue& expect);

}  // namespace abut
