// SPDX-License-Identifier: GPL-3.0-or-later
// 3MF files through lib3mf: what is to be built, with names, components, transforms and the unit.
#pragma once
#include <string>

#include "geometry/mesh/mesh_records.hpp"

namespace abut::geometry {

/// Writes every item of the build list; components become objects of their own, named after theirs. Objects that only support
/// the print are ignored. Throws InputError (file) where lib3mf cannot read the file or nothing is to be built.
void read_3mf(const std::string& path, MeshRecords& records);

}  // namespace abut::geometry
