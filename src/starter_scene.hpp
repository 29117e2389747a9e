// SPDX-License-Identifier: GPL-3.0-or-later
// A scene to begin with, for a drawing or mesh: `abut init`.
#pragma once
#include <string>

#include "src/detect.hpp"
#include "src/scene.hpp"

namespace abut {

/// The text of a scene that imports the file, with its parts and, in comments, their edges and the contacts found between them;
/// supports and loads stand there as commented examples on the model's own edges. It is valid as it is, and runs once a support
/// and a load are filled in. The material is steel in the consistent stress unit of the file's length unit.
std::string starter_scene(const SketchReading& reading, const Detection& contacts);

}  // namespace abut
