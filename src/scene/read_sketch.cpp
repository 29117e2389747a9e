// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/read_sketch.hpp"

#include <utility>

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
    geometry::SketchOptions sketch_options;
    sketch_options.tolerance = options.tolerance;
    sketch_options.parts_by = options.parts_by;
    sketch_options.recognise_arcs = options.recognise_arcs && !is_solid_file(path);  // the section has done that
    reading.sketch = geometry::parts_of(reading.drawing, sketch_options);
    check_any_parts(reading);
    reading.scene.file = path;
    reading.scene.length_unit = reading.drawing.unit;
    for (const geometry::Part& part : reading.sketch.parts) reading.scene.parts.push_back({part.name, part, -1, 1, ""});
    reading.scene.imports.push_back(import_record(reading.drawing, 1, reading.sketch.repairs));
    return reading;
}

}  // namespace abut
