// SPDX-License-Identifier: GPL-3.0-or-later
// What is in a file: parts, edges with their names, entities read and ignored, repairs, problems.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "src/scene.hpp"

namespace abut {

struct Inspection {
    std::string file, format, unit;
    Scene scene;  ///< with the parts that could be read
    std::vector<ImportRecord> imports;
    std::vector<geometry::SketchProblem> problems;
    std::vector<geometry::Curve> loose;  ///< lines and arcs of a drawing that belong to no part, for the picture
};

/// Of a scene (.json) or a drawing (.dxf). tolerance 0: the default; units: overrides or supplies a drawing's unit, may be
/// empty. What is wrong with single outlines of a drawing becomes `problems`; throws InputError where nothing can be read at
/// all.
Inspection inspect_file(const std::string& path, double tolerance, const std::string& units);
/// As SCENE.md states for `inspect --json`.
std::string inspection_json(const Inspection& inspection);
std::string inspection_table(const Inspection& inspection);
/// All parts with the names of their edges, a scale, and numbered marks at repairs and problems.
std::string inspection_svg(const Inspection& inspection);

}  // namespace abut
