// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh of joined vertices split into closed shells.
#pragma once
#include "geometry/mesh/mesh.hpp"

namespace abut::geometry {

/// Half-planes about an edge closer than this angle, radians, are one: the common face of two bodies.
inline constexpr double coincident_angle = 1e-3;

/// How many edges of a shell are wrong in one way, and where the first is.
struct EdgeFault {
    int n = 0;  ///< edges
    Vec3 at{0, 0, 0};
    double length = 0;  ///< longest
};

/// A connected surface of a mesh, and what keeps it from closing.
struct Shell {
    Mesh mesh;  ///< unnamed
    bool is_closed = true;
    EdgeFault open;       ///< edges with one triangle
    EdgeFault branching;  ///< edges where bodies meet that cannot be told apart, or faces whose sides contradict each other
};

/// The shells of a mesh, and what was turned or told apart to find them.
struct Shells {
    std::vector<Shell> shells;  ///< in order of their first triangle; whatever does not close is one shell, the last
    int n_turned = 0;           ///< triangles turned to agree with their neighbours
    int n_inverted = 0;         ///< shells turned inside out
    int n_told_apart = 0;       ///< edges where shells touch (4 triangles or more), assigned by the side of the material
    Vec3 turned_at{0, 0, 0}, inverted_at{0, 0, 0}, told_apart_at{0, 0, 0};
};

/// Splits a mesh into closed shells:
/// 1. Triangles are turned to agree across edges that two of them share; of each connected patch the minority is turned.
/// 2. If the whole then holds a negative volume, all is turned.
/// 3. At edges with more triangles these bound wedges of material, one after the other about the edge: the two sides of one
///    wedge belong together. So bodies that touch along an edge or a face are told apart, if the face is there twice.
/// 4. Shells are what hangs together. Where an edge is left with unequal numbers of triangles in both senses, they are not
///    closed.
/// 5. A closed shell of negative volume inside another (by its winding number) is a cavity of it; outside, it is turned.
/// All indices must be valid, vertices joined. Cost O(n log n), and O(n) for each shell of negative volume.
Shells split_shells(const Mesh& mesh);

/// Volume, positive where the triangles are counter-clockwise seen from outside.
double signed_volume(const Mesh& mesh);

}  // namespace abut::geometry
