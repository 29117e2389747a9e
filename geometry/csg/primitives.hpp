// SPDX-License-Identifier: GPL-3.0-or-later
// The primitives of a geometry tree in reading order, each with its edges, boundary and placement.
#pragma once
#include <string>
#include <vector>

#include "geometry/csg/csg.hpp"
#include "geometry/csg/loops.hpp"

namespace abut::geometry {

/// One `place`: x -> scale R M (x - about) + about + translate, with M the mirror and R the rotation by quarter_turns * 90
/// degrees and by the angle whose half has the tangent half_tangent. Both give exactly rational cosines and sines, so that
/// exact arithmetic (exact_regions.cpp) and doubles mean the same map.
struct Move {
    int quarter_turns = 0;
    double half_tangent = 0;
    Vec2 about{0, 0}, translate{0, 0};
    double scale = 1;
    Mirror mirror = Mirror::none;
};

/// An edge of a primitive, in the primitive's own direction.
struct SourceEdge {
    Curve curve;
    std::string name;  ///< "left", without the names of nodes
    double begin = 0;  ///< arc length where the curve begins on its source: not 0 for imported pieces only
};

/// A leaf of the tree, with its edges and where the tree moves it.
struct Primitive {
    std::string name;                 ///< names of the nodes on the way to it, "base/foot"; may be empty
    std::string where;                ///< JSON pointer
    std::vector<Move> moves;          ///< innermost first
    std::vector<SourceEdge> edges;    ///< in the primitive's own frame
    std::vector<BoundaryLoop> loops;  ///< empty for a half plane; material on the left where they are placed
    bool half_plane = false;          ///< its one edge is a segment of the line, from the given point on
    bool imported = false;
    std::vector<Repair> repairs;  ///< what its own loops were mended by, placed
};

/// All leaves of the tree in reading order. What is wrong with one of them, or with the nodes above, is added to `problems`.
std::vector<Primitive> primitives_of(const CsgNode& tree, std::vector<GeometryProblem>& problems);

/// A curve or a point after all moves, the innermost first.
Curve placed(Curve curve, const std::vector<Move>& moves);
Vec2 placed(Vec2 p, const std::vector<Move>& moves);
/// Do the moves exchange left with right?
bool is_mirrored(const std::vector<Move>& moves);
/// The factor by which the moves multiply lengths.
double scale_of(const std::vector<Move>& moves);

}  // namespace abut::geometry
