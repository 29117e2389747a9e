// SPDX-License-Identifier: GPL-3.0-or-later
// 3MF files through lib3mf: what is to be built, with names, components, transforms and the unit.
#pragma once
#include <string>

#include "geometry/mesh/mesh_bodies.hpp"

namespace abut::geometry {

/// Components within components deeper than this are damage.
inline constexpr int deepest_components = 64;

/// Adds every item of the build list to `bodies`; components become bodies of their own, named after their objects. Objects
/// that only support the print are ignored. Throws InputError (file) where lib3mf cannot read the file or nothing is to be
/// built.
void read_3mf(const std::string& path, MeshBodies& bodies);

}  // namespace abut::geometry
