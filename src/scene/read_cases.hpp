// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/scene/scene.hpp"
#include "src/scene/scene_fields.hpp"

namespace abut {

/// Reads "cases" into scene.cases; the scene's loads must have been read. Entries that are wrong are reported and left out; a
/// load that acts in no case is a warning.
void read_cases(SceneReading& reading, const JsonValue& cases, Scene& scene);

/// Reports known answers that name no load case where there are some, or one that there is not.
void check_cases_of_expectations(SceneReading& reading, const Scene& scene);

}  // namespace abut
