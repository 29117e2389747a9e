// SPDX-License-Identifier: GPL-3.0-or-later
// The tree of a part's geometry as the scene gives it, and its evaluation to a boundary (boolean.cpp, through CGAL).
#pragma once
#include <string>
#include <variant>
#include <vector>

#include "geometry/part.hpp"

namespace abut::geometry {

struct CsgNode;

struct Rectangle {
    Vec2 min, max;
};  ///< edges left right bottom top
struct Circle {
    Vec2 center;
    double radius;
};  ///< edge circle, from angle 0 counter-clockwise
struct Polygon {
    std::vector<Vec2> points;
};  ///< edges e0 e1 ..., in either orientation
struct HalfPlane {
    Vec2 point, normal;
};  ///< edge line; keeps the side that the normal points away from
struct Union {
    std::vector<CsgNode> of;
};
struct Intersection {
    std::vector<CsgNode> of;
};
struct Difference {
    std::vector<CsgNode> of;
};  ///< the first less all others
/// Applied in the order rotate (degrees, about `about`), translate. (scale and mirror: a later version)
struct Placed {
    std::vector<CsgNode> of;
    double rotate = 0;
    Vec2 translate{0, 0};
    Vec2 about{0, 0};
};  ///< one child

/// One edge of `loops`, in the file's own direction.
struct LoopEdge {
    Curve curve;
    std::string name;   ///< "e0", ... or the name given
    std::string where;  ///< JSON pointer
};
struct Loops {
    std::vector<std::vector<LoopEdge>> loops;
};
/// A boundary that is already known (an import): taken as it is.
struct Imported {
    Part part;
};

struct CsgNode {
    std::variant<Rectangle, Circle, Polygon, HalfPlane, Union, Intersection, Difference, Placed, Loops, Imported> shape;
    std::string name;   ///< prefix of the edges' names, may be empty
    std::string where;  ///< JSON pointer of the node, for errors
};

/// What is wrong with a model, and where in the plane.
struct GeometryProblem {
    std::string where;  ///< JSON pointer or edge names
    std::string what;
    std::string hint;
    Vec2 at{0, 0};
};

struct CsgResult {
    Part part;                              ///< one part; several disjoint regions are allowed (name left empty)
    std::vector<GeometryProblem> problems;  ///< not empty: the part must not be used
};

/// Evaluates the tree exactly. Every edge of the result knows the primitive's edge it came from; adjacent pieces of one
/// source edge are merged; names are made as the scene format says: `name/left`, `left`, `<k>/left` where not unique
/// (k = the primitive's place in the tree, counted from 0 in reading order), pieces `#0`, `#1`, ... in the source's own
/// direction. Problems found: primitives without area or with non-positive radius, open, self-crossing or crossing loops,
/// an empty result, an unbounded result (an uncut half plane).
CsgResult evaluate(const CsgNode& tree);

}  // namespace abut::geometry
