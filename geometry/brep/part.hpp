// SPDX-License-Identifier: GPL-3.0-or-later
// A part: a region of the plane bounded by named edges. Immutable once built; edges are referred to by index.
#pragma once
#include <string>
#include <vector>

#include "geometry/curves/curve.hpp"

namespace abut::geometry {

/// One piece of a part's boundary, oriented with the material on its left (the outward normal on its right).
struct Edge {
    Curve curve;
    std::string name;          ///< within the part: "left", "base/left", "left#1", "h2F"
    std::string source;        ///< name of the primitive's or imported edge this is (a piece of): "left"
    bool along_source = true;  ///< does the curve run in the source's own direction?
    double source_begin = 0;   ///< arc length on the source edge at the piece's end that comes first on the source
};

/// A closed chain of edges, head to tail: outer boundaries run counter-clockwise, holes clockwise.
struct Loop {
    std::vector<int> edges;  ///< indices into Part::edges
};

/// A region of the plane: its edges, and the loops that they make.
struct Part {
    std::string name;
    std::vector<Edge> edges;
    std::vector<Loop> loops;
};

inline const Curve& curve_of(const Part& part, int edge) {
    return part.edges[static_cast<std::size_t>(edge)].curve;
}
/// The loop that the edge belongs to; nullptr if to none.
const Loop* loop_of(const Part& part, int edge);

/// The smallest axis-parallel box around a part's edges, exact but for rounding.
Box2 bounding_box(const Part& part);
/// Area (length^2) and centroid of a part by Green's theorem (curve_moments.hpp), to rounding. Holes count negative.
double area(const Part& part);
Vec2 centroid(const Part& part);
/// The integral of a a' over a part (length^4), where a goes from c to its points, likewise.
Eigen::Matrix2d second_moments(const Part& part, const Vec2& c);
/// The length of all edges, those of holes included.
double perimeter(const Part& part);
/// The number of holes: loops that run clockwise.
int count_holes(const Part& part);

/// Has the part edges that are ellipses or splines? Lines and circles have closed forms for everything.
bool has_general_curves(const Part& part);

/// Is p strictly inside? Winding number by crossings; points within rounding of the boundary may go either way.
bool contains(const Part& part, const Vec2& p);

/// The length below which two points of this part count as one: merge_fraction times the diagonal.
inline constexpr double merge_fraction = 1e-9;
double merge_length(const Part& part);

/// The part rotated about the origin by the angle of cosine c and sine s, then moved by d.
Part transformed(const Part& part, double c, double s, const Vec2& d);

/// Arc length along the named edge (the piece), counted in the source's own direction, of the point at parameter t of the
/// edge's curve.
double edge_arc_length(const Edge& edge, double t);

}  // namespace abut::geometry
