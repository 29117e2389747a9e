// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of a mesh with the triangles at them.
#pragma once
#include "geometry/mesh/mesh.hpp"

namespace abut::geometry {

/// A triangle at an edge.
struct EdgeSide {
    int triangle;
    int apex;         ///< its third vertex
    bool is_forward;  ///< does the triangle run along the edge in its direction?
};

/// An edge of a mesh with all triangles at it.
struct MeshEdge {
    int from, to;  ///< vertices, from < to
    std::vector<EdgeSide> sides;
};

/// All edges of a mesh, ordered by vertices, the sides of each by triangle. Cost O(n log n).
std::vector<MeshEdge> edges_of(const Mesh& mesh);

}  // namespace abut::geometry
