// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary as pieces that are monotone in x and in y: on each, y is a function of x and x one of y (the piecewise boundary
// segments of [Grishin10, eqs 4.25-4.33]).
#pragma once
#include <vector>

#include "geometry/part.hpp"

namespace abut::geometry {

/// Consecutive pieces share their end coordinates bit for bit: whatever is decided about a vertex is decided once.
struct MonotonePiece {
    int edge;
    double t0, t1;  ///< parameters of the edge's curve, t0 < t1
    Vec2 from, to;
    bool is_arc = false;
    Vec2 center{0, 0};
    double radius = 0;
    int x_side = 0, y_side = 0;  ///< of an arc: the quadrant about its centre (+1 or -1)
};

/// Loop by loop, head to tail. A part without loops counts as one loop of all its edges in order.
std::vector<MonotonePiece> monotone_pieces(const Part& part);

/// The one-variable forms; clamped to the piece's end coordinates.
double y_at(const MonotonePiece& piece, double x);
double x_at(const MonotonePiece& piece, double y);
/// Parameter of the edge's curve at a point of the piece.
double parameter_at(const MonotonePiece& piece, const Vec2& p, const Curve& curve);

/// Is p inside the region that the pieces bound? For many points of one part; see contains(part, p).
bool contains(const std::vector<MonotonePiece>& pieces, const Vec2& p);

}  // namespace abut::geometry
