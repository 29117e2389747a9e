// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/scene/read_drawing.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// A scene's equivalent of a bare drawing or mesh: its parts, no loads (for `contacts`, `inspect` and `init`).
struct SketchReading {
    Scene scene;
    geometry::Drawing drawing;
    geometry::SketchParts sketch;
};
SketchReading read_sketch(const std::string& path, const ImportOptions& options);

}  // namespace abut
