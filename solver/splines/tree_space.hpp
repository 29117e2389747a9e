// SPDX-License-Identifier: GPL-3.0-or-later
// Truncated hierarchical B-splines with extension on a quadtree of cells: another extraction of a SplineSpace, so that cells
// can be small where it matters and nowhere else.
//
// Of every level's B-splines those are functions of the space that live on cells of their level or smaller ones only, and on
// one of their own level at least; where smaller ones have taken over they are cut back (truncated), so that all add up to 1,
// are linearly independent, and a polynomial's coefficient is its blossom at the function's own knots [Giannelli12].
//
// 1. Pieces: the connected components of (node of the tree and part). Leaves' are the elements; those of a node with children
//    follow from its children's and from which of these hang together.
// 2. Level by level each B-spline is followed through the pieces of its support, on nodes of its own level that hang together
//    (arms beside a slot apart, as in branches.hpp). Where a coarser leaf takes part it is none of its level's functions there
//    ("coarse"); where all pieces have children it is the next level's business ("passed on"); else it is a function.
// 3. What the B-splines of a node are of functions: the parent's rows times knot insertion, but where a B-spline is a function
//    its row is that function alone, and where it is passed on its row is empty. This is all there is to truncation.
// 4. Inner functions are those that are not zero on some inner leaf of any level (asking for one of the function's own level
//    makes outer ones of healthy functions, whose extension then comes from far and fine leaves: condition numbers to 3e7).
//    Outer ones continue the polynomial of the nearest inner leaf, by distance in sizes of that leaf, reached through the part.
//
// [Giannelli12] C. Giannelli, B. Juettler, H. Speleers, THB-splines: the truncated basis for hierarchical splines, Computer
// Aided Geometric Design 29, 2012.
#pragma once
#include "solver/splines/spline_space.hpp"

namespace abut::solver {

/// make_space() of an input with a tree. Cost: nodes of the tree times B-splines of a cell. Knots at the ends of the base are
/// clamped.
SplineSpace make_tree_space(SpaceInput input);

}  // namespace abut::solver
