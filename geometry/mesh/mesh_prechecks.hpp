// SPDX-License-Identifier: GPL-3.0-or-later
// What is looked at in a mesh file before a library reads it: damage that libraries tell badly.
#pragma once
#include <cstdint>
#include <string>

namespace abut::geometry {

/// The largest size of a mesh file, bytes: no mesh within most_triangles needs more.
inline constexpr std::uintmax_t most_mesh_bytes = 512u << 20;

/// Checks a mesh file for damage; `format` as in MeshFile. Throws InputError where the file is missing, unreadable, empty or
/// too large; a binary STL that is shorter than it states; glTF and COLLADA that do not begin as such.
void check_mesh_file(const std::string& path, const std::string& format);

}  // namespace abut::geometry
