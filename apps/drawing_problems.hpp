// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "apps/arguments.hpp"
#include "geometry/sketch/sketch.hpp"
#include "src/scene/read_sketch.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// Throws the problems as an InputError, each with file, line, entity and place; returns where there are none.
void throw_if_any(const std::string& file, const std::vector<geometry::SketchProblem>& problems);

/// Throws what was left out, merged, projected or guessed of drawings as an InputError where --strict is given.
void refuse_guesses(const Scene& scene, const Arguments& arguments);

/// Reads the drawing or mesh that the operand names. One with problems is refused: parts that could not be read would be
/// missing without notice.
SketchReading read_whole_sketch(const Arguments& arguments);
/// Reads any drawing or mesh; one with problems is refused.
SketchReading read_whole_sketch(const std::string& file, const ImportOptions& options);

}  // namespace abut
