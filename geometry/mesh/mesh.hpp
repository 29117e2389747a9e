// SPDX-License-Identifier: GPL-3.0-or-later
// Triangle meshes of plate-like parts, as 3D exports hold them.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "geometry/brep/repair.hpp"
#include "geometry/mesh/section_plane.hpp"
#include "geometry/sketch/sketch.hpp"

namespace abut::geometry {

/// One body in the file's coordinates: instances are expanded, transforms applied, coincident vertices joined. Cavities belong
/// to the body around them.
struct Mesh {
    /// The body's name, unique in the file: that of the node or object; further instances of a name are `name#1`, `name#2`,
    /// ...; the shells of a named object that has several are `name#0`, `name#1`, ...; bodies of unnamed objects are `shell1`,
    /// `shell2`, ...
    std::string name;
    std::vector<Vec3> vertices;
    std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from outside
};

/// The bodies of a mesh file, and what was mended, ignored and wrong in it.
struct MeshFile {
    std::string file, format;  ///< format: "STL", "OBJ", "PLY", "glTF", "COLLADA", "3MF"
    std::string unit;          ///< 3MF states one; COLLADA and glTF are brought to "m"; empty otherwise
    std::vector<Mesh> bodies;
    std::map<std::string, EntityCount> counts;  ///< "triangle", "object", "body"
    std::vector<Ignored> ignored;
    /// What of the mesh was mended: vertices joined, triangles without area or doubled removed, faces turned. The place is the
    /// (x, y) of the first of them.
    std::vector<Repair> repairs;
    /// What is wrong with single bodies, named by `entity`: holes, edges at which bodies cannot be told apart. One problem for
    /// each kind and body; the place is the (x, y) of the first edge. They matter only where they meet the section: see
    /// section().
    std::vector<SketchProblem> problems;
};

/// The limits against damaged or runaway files.
inline constexpr std::size_t most_triangles = 1'000'000;
inline constexpr std::size_t most_bodies = 10'000;
inline constexpr double largest_mesh_coordinate = 1e12;

/// Can a file of this name be a mesh (by its ending)?
bool is_mesh_file(const std::string& path);
/// Reads a mesh file, through assimp; 3MF through lib3mf (names, units, instances); either in a process of its own (foreign/).
/// Every closed shell becomes a body; what of an object does not close is one body. Throws InputError where nothing can be
/// read: missing, empty or damaged files, coordinates that are no numbers, no triangles, more of them than the limits, and
/// where the library breaks down at the file. Coordinates are those of the file rounded to single precision.
MeshFile read_mesh_file(const std::string& path);

}  // namespace abut::geometry
