// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of arcs of two arc splines that come near each other, without trying all of them.
#pragma once
#include <vector>

#include "geometry/curves/arc_spline.hpp"

namespace abut::geometry {

/// A curve's arc spline with the boxes of its runs of arcs: neighbours on the curve are neighbours in the plane, so that
/// halving the sequence makes a good tree. Node 0 holds all arcs.
struct PieceTree {
    struct Node {
        Box2 box;
        int first = 0, last = 0;    ///< arcs [first, last)
        int left = -1, right = -1;  ///< nodes; -1: a single arc
    };
    std::vector<ArcPiece> pieces;
    std::vector<Node> nodes;
    double tolerance = 0;  ///< how far the arcs are from the curve
};

/// The arc spline with its flattest arcs as segments: what closed forms of circles lose in digits grows with the radius. Adds
/// flat_fraction of the tolerance to the arcs' error.
std::vector<ArcPiece> calm_arc_spline(const Curve& curve, double tolerance);
inline constexpr double flat_fraction = 0.1;

/// The tree of a curve's calm arc spline.
PieceTree piece_tree(const Curve& curve, double tolerance);

/// The parameter of the curve at a point of one of its arcs: near the true one, to start an iteration with.
double curve_parameter(const ArcPiece& piece, const Vec2& p);

/// Calls visit(piece of a, piece of b) for all pairs whose boxes come within limit(), which may shrink as pairs are visited.
template <class Limit, class Visit>
void visit_near(const PieceTree& a, const PieceTree& b, Limit limit, Visit visit, int node_a = 0, int node_b = 0) {
    const PieceTree::Node& na = a.nodes[static_cast<std::size_t>(node_a)];
    const PieceTree::Node& nb = b.nodes[static_cast<std::size_t>(node_b)];
    if (!na.box.overlaps(nb.box, limit())) return;
    if (na.left < 0 && nb.left < 0) {
        visit(a.pieces[static_cast<std::size_t>(na.first)], b.pieces[static_cast<std::size_t>(nb.first)]);
    } else if (nb.left < 0 || (na.left >= 0 && na.last - na.first >= nb.last - nb.first)) {
        visit_near(a, b, limit, visit, na.left, node_b);
        visit_near(a, b, limit, visit, na.right, node_b);
    } else {
        visit_near(a, b, limit, visit, node_a, nb.left);
        visit_near(a, b, limit, visit, node_a, nb.right);
    }
}

}  // namespace abut::geometry
