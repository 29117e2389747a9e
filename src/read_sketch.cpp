// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "src/import_drawing.hpp"
#include "src/scene.hpp"

namespace abut {

SketchReading read_sketch(const std::string& path, double tolerance, const std::string& units) {
    SketchReading reading;
    reading.drawing = geometry::read_dxf(path);
    if (!units.empty()) reading.drawing.unit = units;
    reading.sketch = geometry::parts_by_layer(reading.drawing, {tolerance});
    reading.scene.file = path;
    reading.scene.length_unit = reading.drawing.unit;
    for (const geometry::Part& part : reading.sketch.parts) reading.scene.parts.push_back({part.name, part, -1, 1, ""});
    reading.scene.imports.push_back(import_record(reading.drawing, 1, reading.sketch.repairs));
    return reading;
}

}  // namespace abut
