// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/read_sketch.hpp"

#include <utility>

#include "geometry/sketch/sketch_views.hpp"
#include "src/scene/import_drawing.hpp"
#include "src/scene/scene.hpp"

namespace abut {

namespace {

/// Nothing to work with is a fault, too, where no other one explains it.
void check_any_parts(SketchReading& reading) {
    if (!reading.sketch.parts.empty() || !reading.sketch.problems.empty() || !reading.drawing.problems.empty()) return;
    const bool is_empty = reading.drawing.entities.empty();
    reading.sketch.problems.push_back(
        {is_empty ? "the file holds no line, arc or other curve that bounds a part" : "the file bounds no part",
         {0, 0},
         "",
         0,
         is_empty ? "abut inspect shows what was left out, and why" : "lines and arcs must form closed outlines"});
}

}  // namespace

SketchReading read_sketch(const std::string& path, const ImportOptions& options) {
    SketchReading reading;
    reading.drawing = read_drawing(path, options);
    reading.sketch = geometry::parts_of(reading.drawing, sketch_options(reading.drawing, options));
    check_any_parts(reading);
    if (!is_solid_file(path) && reading.sketch.problems.empty())
        for (geometry::SketchProblem& warning : geometry::views_of_one_part(reading.sketch.parts))
            reading.sketch.warnings.push_back(std::move(warning));
    if (reading.drawing.unit.empty())
        reading.drawing.warnings.insert(
            reading.drawing.warnings.begin(),
            {"the file states no unit of length", {0, 0}, {}, 0, "--units mm, or another one, says what its numbers mean"});
    reading.scene.file = path;
    reading.scene.length_unit = reading.drawing.unit;
    for (const geometry::Part& part : reading.sketch.parts) reading.scene.parts.push_back({part.name, part, -1, 1, ""});
    reading.scene.imports.push_back(import_record(reading.drawing, 1, reading.sketch.repairs, reading.sketch.warnings));
    for (const geometry::SketchProblem& warning : reading.scene.imports.back().warnings)
        reading.scene.warnings.push_back(warning_text(path, warning));
    return reading;
}

}  // namespace abut
