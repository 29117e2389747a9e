// SPDX-License-Identifier: GPL-3.0-or-later
// STL, OBJ, PLY, glTF and COLLADA through assimp.
#pragma once
#include <string>

#include "geometry/mesh/mesh_records.hpp"

namespace abut::geometry {

/// Writes the objects of a file of that format (as in MeshFile). Throws InputError where assimp cannot read it.
void read_scene_file(const std::string& path, const std::string& format, MeshRecords& records);

}  // namespace abut::geometry
