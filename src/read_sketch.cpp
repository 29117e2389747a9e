// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "src/import_drawing.hpp"
#include "src/scene.hpp"

namespace abut {

SketchReading read_sketch(const std::string& path, const ImportOptions& options) {
    SketchReading reading;
    reading.drawing = read_drawing(path, options);
    geometry::SketchOptions sketch_options;
    sketch_options.tolerance = options.tolerance;
    sketch_options.parts_by = options.parts_by;
    sketch_options.recognise_arcs = !geometry::is_mesh_file(path);  // the section has done that
    reading.sketch = geometry::parts_of(reading.drawing, sketch_options);
    reading.scene.file = path;
    reading.scene.length_unit = reading.drawing.unit;
    for (const geometry::Part& part : reading.sketch.parts) reading.scene.parts.push_back({part.name, part, -1, 1, ""});
    reading.scene.imports.push_back(import_record(reading.drawing, 1, reading.sketch.repairs));
    return reading;
}

}  // namespace abut
