// SPDX-License-Identifier: GPL-3.0-or-later
// Hoellig's blended distance functions [Grishin10, eqs 3.18-3.19; Hoellig03]: a second way to a field that vanishes on a
// boundary, local and flat away from it.
//
//     w(x) = sum_k N_k(x) w_k(x),   w_k = (delta / gamma) (1 - max(0, 1 - d_k / delta)^gamma)
//
// N_k: tensor B-splines on a uniform grid of cells h', a partition of unity; d_k: distance to the edges that come within delta
// of the support of N_k; w_k is the constant delta / gamma where there are none, and beyond delta.
// Differences to the source, which leaves the w_k open:
// - of several edges d_k is their joined distance (sum d_l^-m)^(-1/m) instead of the minimum, which has a kink on the bisector
//   of every corner; it is at most n^(1/m) times smaller, and keeps the unit normal derivative;
// - which edges come near a support is told by their bounding boxes: some may be taken that lie a little farther away;
// - the factor delta / gamma makes the derivative along the inward normal 1 (the source asks for proportionality only);
// - w is continued by its negative outside of the part.
#pragma once
#include "geometry/implicit/implicit.hpp"

namespace abut::geometry {

/// The choices of a blended distance function.
struct BlendedDistance {
    double delta = 0;  ///< width of the strip, length; 0: strip_width(part)
    int gamma = 3;     ///< >= 1; the field is gamma - 1 times continuously differentiable where it becomes flat
    double cell = 0;   ///< h', length; 0: twice delta, at least 1/finest_default_grid of the diagonal
    int degree = 3;    ///< of the splines, 1 to 8; Hessians are continuous from 3 on
    int m = 2;         ///< order of the joins
};

/// Makes the field w of a part. Throws std::logic_error for options outside their ranges. Memory: one list of edges for each of
/// (diagonal / h')^2 splines. Cost of a point: point-in-part, and the edges within delta of the (degree + 1)^2 supports around
/// it, whatever the part's size. Not smooth on medial axes closer to the boundary than delta, nor (Hessian only) where an end
/// of an edge becomes its closest point.
ImplicitField blended_distance(const Part& part, const BlendedDistance& options = {});

/// Makes the blended distance of some edges of a part: zero on them, positive elsewhere, on both sides of the boundary; flat
/// away from them. Throws std::logic_error where blended_distance does, and if `edges` is empty or names none.
ImplicitField blended_edge_distance(const Part& part, const std::vector<int>& edges, const BlendedDistance& options = {});

/// Half the smallest radius of curvature, at most widest_strip_fraction of the part's diagonal: within this strip the distance
/// to each edge is smooth. Curvatures are taken at n_curvature_samples points between smoothness_breaks and axis_extrema.
double strip_width(const Part& part);
inline constexpr double widest_strip_fraction = 0.1;
inline constexpr int finest_default_grid = 64;
inline constexpr int n_curvature_samples = 8;

}  // namespace abut::geometry
