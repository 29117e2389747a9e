// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that the benchmarks run on.
#pragma once
#include <string>

#include "src/discretization/discretize.hpp"
#include "src/scene/scene.hpp"

namespace abut::benchmarks {

/// A file below the source folder.
Scene scene_file(const std::string& path);

/// A scene given as JSON text.
Scene scene_text(const std::string& json);

/// A square plate with a hole, on a uniform grid of n x n cells whose lines meet none of its edges: every edge cuts cells.
Scene plate_with_hole();
PartOnGrid plate_on_grid(const Scene& plate, int n, int degree);
geometry::Grid plate_grid(int n);

}  // namespace abut::benchmarks
