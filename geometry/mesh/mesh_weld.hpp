// SPDX-License-Identifier: GPL-3.0-or-later
// Coincident vertices of a mesh joined, and the triangles removed that this leaves without meaning.
#pragma once
#include "geometry/mesh/mesh.hpp"

namespace abut::geometry {

/// Vertices closer than this fraction of the object's diagonal are one: formats of triangles repeat every vertex, and most hold
/// single precision.
inline constexpr double weld_fraction = 1e-6;
/// Relative rounding of coordinates in single precision, which far from the origin is more than weld_fraction.
inline constexpr double single_rounding = 1.2e-7;

/// The distance below which two vertices of the object are one.
double weld_length(const std::vector<Vec3>& vertices);

/// What joining vertices did to a mesh, with the place of the first of each kind.
struct Weld {
    int n_joined = 0;  ///< vertices that moved by more than rounding
    int n_degenerate = 0, n_doubled = 0;
    double moved = 0;  ///< largest
    Vec3 at{0, 0, 0}, degenerate_at{0, 0, 0}, doubled_at{0, 0, 0};
};

/// Joins each vertex to the first within weld_length(). Removed: triangles of which two corners are one then, and triangles
/// with the same corners in the same sense as another. A triangle without area but with three corners stays: taking it out
/// would tear the shell. So do two triangles back to back: they are the common face of two bodies. Unused vertices go. All
/// indices must be valid. Cost O(n log n).
Weld weld(Mesh& mesh);

}  // namespace abut::geometry
