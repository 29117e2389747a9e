// SPDX-License-Identifier: GPL-3.0-or-later
// The tree of a part's geometry as the scene gives it, and its evaluation to a boundary (boolean.cpp, through exact_regions.cpp
// and CGAL).
#pragma once
#include <string>
#include <variant>
#include <vector>

#include "geometry/brep/part.hpp"
#include "geometry/brep/repair.hpp"

namespace abut::geometry {

struct CsgNode;

struct Rectangle {
    Vec2 min, max;
};  ///< edges left right bottom top
struct Circle {
    Vec2 center;
    double radius;
};  ///< edge circle, from angle 0 counter-clockwise
struct Ellipse {
    Vec2 center, radii;
    double angle = 0;
};  ///< edge ellipse, from the end of the first half axis counter-clockwise; angle of that axis in degrees
struct Slot {
    Vec2 from, to;
    double radius;
};  ///< edges side0 (right of from->to) end1 side1 end0, counter-clockwise
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
};                                 ///< the first less all others
enum class Mirror { none, x, y };  ///< x: negates x
/// A child that is scaled, mirrored, rotated (degrees) and translated, in this order; the first three about `about`.
struct Placed {
    std::vector<CsgNode> of;
    double rotate = 0;
    Vec2 translate{0, 0};
    Vec2 about{0, 0};
    double scale = 1;  ///< positive
    Mirror mirror = Mirror::none;
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
    double rounding = 0;  ///< how far the digits that it is written with may have moved it
};

/// A node of the tree: a shape or an operation, with its children in `of`.
struct CsgNode {
    std::variant<Rectangle, Circle, Ellipse, Slot, Polygon, HalfPlane, Union, Intersection, Difference, Placed, Loops, Imported>
        shape;
    std::string name;   ///< prefix of the edges' names, may be empty
    std::string where;  ///< JSON pointer of the node, for errors
};

/// The tree rotated about the origin by the angle of cosine c and sine s, then moved by d.
CsgNode transformed(CsgNode tree, double c, double s, const Vec2& d);

/// How far the digits that the shapes and moves of a tree are written with may have moved what it bounds (written_digits.hpp).
/// Angles, factors, and arcs among loops are taken as they are.
double written_rounding(const CsgNode& tree, double size);

/// What is wrong with a model, and where in the plane.
struct GeometryProblem {
    std::string where;  ///< JSON pointer or edge names
    std::string what;
    std::string hint;
    Vec2 at{0, 0};
};

/// A part, or what is wrong with the tree.
struct CsgResult {
    Part part;                              ///< one part; several disjoint regions are allowed (name left empty)
    std::vector<GeometryProblem> problems;  ///< not empty: the part must not be used
    std::vector<Repair> repairs;            ///< slivers and tiny edges left out; where loops touch each other (size 0)
};

/// Evaluates the tree exactly. Every edge of the result knows the primitive's edge it came from; adjacent pieces of one
/// source edge are merged; names are made as the scene format says: `name/left`, `left`, `<k>/left` where not unique
/// (k = the primitive's place in the tree, counted from 0 in reading order), pieces `#0`, `#1`, ... in the source's own
/// direction. Problems found: primitives without area or with non-positive radius, open, self-crossing or crossing loops,
/// an empty result, an unbounded result (an uncut half plane).
CsgResult evaluate(const CsgNode& tree);

}  // namespace abut::geometry
