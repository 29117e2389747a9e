// SPDX-License-Identifier: GPL-3.0-or-later
// The materials that come with the program: data/materials/materials.json, compiled in.
#pragma once
#include <string>
#include <vector>

#include "src/io/json_document.hpp"

namespace abut {

/// The material of this name or of this other name ("aliases"): its keys are those of a scene's materials, with units, and
/// "about" and "sources" besides. nullptr where there is none.
const JsonValue* library_material(const std::string& name);

/// All names, the general ones (steel, brass) first.
std::vector<std::string> library_material_names();

/// The text of the file.
const char* material_library_text();

}  // namespace abut
