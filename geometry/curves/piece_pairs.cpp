// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/piece_pairs.hpp"

#include <cmath>

namespace abut::geometry {

namespace {

int build(PieceTree& tree, int first, int last) {
    const int id = static_cast<int>(tree.nodes.size());
    tree.nodes.push_back({{}, first, last, -1, -1});
    Box2 box;
    for (int i = first; i < last; ++i) box.extend(bounding_box(tree.pieces[static_cast<std::size_t>(i)].curve));
    tree.nodes.back().box = box;
    if (last - first == 1) return id;
    const int middle = first + (last - first) / 2;
    const int left = build(tree, first, middle), right = build(tree, middle, last);
    tree.nodes[static_cast<std::size_t>(id)].left = left;
    tree.nodes[static_cast<std::size_t>(id)].right = right;
    return id;
}

}  // namespace

std::vector<ArcPiece> calm_arc_spline(const Curve& curve, double tolerance) {
    std::vector<ArcPiece> pieces = arc_spline(curve, tolerance);
    if (std::holds_alternative<Arc>(curve)) return pieces;  // the curve itself
    for (ArcPiece& piece : pieces) {
        const auto* arc = std::get_if<Arc>(&piece.curve);
        if (arc && arc->radius * (1 - std::cos(0.5 * arc->sweep)) <= flat_fraction * tolerance)
            piece.curve = Segment{point(curve, piece.t0), point(curve, piece.t1)};
    }
    return pieces;
}

PieceTree piece_tree(const Curve& curve, double tolerance) {
    PieceTree tree;
    tree.pieces = calm_arc_spline(curve, tolerance);
    tree.tolerance = (1 + flat_fraction) * tolerance;
    build(tree, 0, static_cast<int>(tree.pieces.size()));
    return tree;
}

double curve_parameter(const ArcPiece& piece, const Vec2& p) {
    return piece.t0 + closest_parameter(piece.curve, p) * (piece.t1 - piece.t0);
}

}  // namespace abut::geometry
