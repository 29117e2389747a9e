// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary as pieces that are monotone in x and in y: on each, y is a function of x and x one of y. These are the piecewise
// boundary segments of [Grishin10, eqs 4.25-4.33] and their one-variable forms; closed forms for lines and circles, Newton on
// the true curve for ellipses and splines.
#pragma once
#include <vector>

#include "geometry/brep/part.hpp"

namespace abut::geometry {

/// A piece of a part's boundary that is monotone in x and in y. Consecutive pieces share their end coordinates bit for bit:
/// whatever is decided about a vertex is decided once. Pieces end where the curve's tangent is parallel to an axis and at a
/// spline's knots, so that the curve is smooth on each. Extreme points of circles are exact; those of other curves are the
/// computed point, and count as the piece's bounds even where the curve between them is beyond by a rounding.
struct MonotonePiece {
    int edge;
    double t0, t1;  ///< parameters of the edge's curve, t0 < t1
    Vec2 from, to;
    bool is_arc = false;
    Vec2 center{0, 0};
    double radius = 0;
    int x_side = 0, y_side = 0;             ///< quadrant of an arc about its centre (+1 or -1)
    bool is_general = false;                ///< the edge's curve is an ellipse or a spline
    Curve curve = Segment{{0, 0}, {0, 0}};  ///< the edge's curve, of general pieces only
};

/// The part's boundary as monotone pieces, loop by loop, head to tail. A part without loops counts as one loop of all its edges
/// in order.
std::vector<MonotonePiece> monotone_pieces(const Part& part);

/// The portion [t0, t1] of a curve, which must be monotone in x and in y, with its end points.
MonotonePiece monotone_piece(int edge, const Curve& curve, double t0, double t1, const Vec2& from, const Vec2& to);

/// The piece's ordinate at the abscissa x, and its abscissa at the ordinate y, clamped to the piece's end coordinates. On a
/// piece along the other axis (from.x = to.x for y_at) they are undefined.
double y_at(const MonotonePiece& piece, double x);
double x_at(const MonotonePiece& piece, double y);
/// The piece's derivatives dy/dx and dx/dy; infinite where the tangent is parallel to the other axis.
double dy_dx(const MonotonePiece& piece, double x);
double dx_dy(const MonotonePiece& piece, double y);
/// The parameter of the edge's curve at a point of the piece.
double parameter_at(const MonotonePiece& piece, const Vec2& p, const Curve& curve);

/// The place where a piece meets a grid line: the point, on the line exactly, and the parameter there.
struct LineMeeting {
    Vec2 at;
    double t;
};
/// The point where a piece meets the line on which coordinate `axis` (0: x, 1: y) is c, c between the ends' coordinates.
/// `curve`: the edge's.
LineMeeting line_meeting(const MonotonePiece& piece, int axis, double c, const Curve& curve);

/// Is p inside the region that the pieces bound? Cost O(pieces), for some points of one part; see contains(part, p) for one.
bool contains(const std::vector<MonotonePiece>& pieces, const Vec2& p);

/// The pieces by horizontal slabs of equal height, for very many points: a point looks at its slab's pieces only, about as many
/// as a horizontal line meets. Memory O(pieces).
struct SlabbedPieces {
    std::vector<MonotonePiece> pieces;
    double bottom = 0, height = 0;  ///< bottom of the lowest slab; height of each
    std::vector<int> first;         ///< n_slabs + 1 offsets into `piece`
    std::vector<int> piece;         ///< indices of pieces, ascending in each slab
};
/// Sorts pieces into slabs: two to the mean rise of a piece, at most twice as many as there are pieces.
SlabbedPieces slabbed(std::vector<MonotonePiece> pieces);
/// Is p inside the region that the pieces bound? The answer is that of the plain pieces, at the cost of one slab's.
bool contains(const SlabbedPieces& slabs, const Vec2& p);

}  // namespace abut::geometry
