// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/section_outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abut::geometry {

namespace {

int n_points(const RecoveredOutline& outline) {
    return static_cast<int>(outline.points.size());
}

RecoveredPiece line_between(const RecoveredOutline& outline, int k) {
    return {RecoveredPiece::Kind::line, {Segment{point_of(outline, k), point_of(outline, k + 1)}}, k, 1, 0, 0};
}

double largest_arc_sagitta(const RecoveredOutline& outline, const Arc& arc, int first, int n_facets) {
    double largest = 0;
    for (int k = first; k < first + n_facets; ++k)
        largest = std::max(largest, arc.radius - (0.5 * (point_of(outline, k) + point_of(outline, k + 1)) - arc.center).norm());
    return largest;
}

RecoveredPiece piece_of(const RecoveredOutline& outline, const FittedPiece& fitted) {
    const int n = n_points(outline), n_facets = (fitted.last - fitted.first + n - 1) % n + 1;
    RecoveredPiece piece{RecoveredPiece::Kind::line, {fitted.curve}, fitted.first, n_facets, fitted.residual, 0};
    if (Arc* arc = std::get_if<Arc>(&piece.curves.front())) {
        piece.kind = n_facets == n ? RecoveredPiece::Kind::circle : RecoveredPiece::Kind::arc;
        piece.sagitta = largest_arc_sagitta(outline, *arc, fitted.first, n_facets);
        if (n_facets == n) arc->start = 0, arc->sweep = 2 * std::numbers::pi;  // as drawings hold them
    }
    return piece;
}

RecoveredPiece piece_of(const FacetCurve& found) {
    return {RecoveredPiece::Kind::curve, found.arcs, found.first, found.n_facets, found.residual, found.sagitta};
}

/// Curves in place of the lines that they stand for.
void insert(const std::vector<FacetCurve>& found, RecoveredOutline& outline) {
    if (found.empty()) return;
    std::vector<bool> is_replaced(outline.points.size(), false);
    for (const FacetCurve& curve : found)
        for (int k = 0; k < curve.n_facets; ++k)
            is_replaced[static_cast<std::size_t>((curve.first + k) % n_points(outline))] = true;
    std::erase_if(outline.pieces,
                  [&](const RecoveredPiece& piece) { return is_replaced[static_cast<std::size_t>(piece.first)]; });
    for (const FacetCurve& curve : found) outline.pieces.push_back(piece_of(curve));
    std::sort(outline.pieces.begin(), outline.pieces.end(),
              [](const RecoveredPiece& a, const RecoveredPiece& b) { return a.first < b.first; });
}

}  // namespace

const Vec2& point_of(const RecoveredOutline& outline, int k) {
    return outline.points[static_cast<std::size_t>(k % n_points(outline))];
}

RecoveredOutline outline_of(const std::vector<Vec2>& points, double tolerance, bool recognise_arcs) {
    RecoveredOutline outline{points, {}};
    if (!recognise_arcs) {
        for (int k = 0; k < n_points(outline); ++k) outline.pieces.push_back(line_between(outline, k));
        return outline;
    }
    const std::vector<FittedPiece> fitted = fit_lines_and_arcs(points, true, tolerance);
    for (const FittedPiece& piece : fitted) outline.pieces.push_back(piece_of(outline, piece));
    insert(curves_through_facets(points, fitted, tolerance), outline);
    return outline;
}

std::vector<RecoveredPiece> facets_of(const RecoveredOutline& outline, const RecoveredPiece& piece) {
    std::vector<RecoveredPiece> facets;
    for (int k = 0; k < piece.n_facets; ++k) facets.push_back(line_between(outline, (piece.first + k) % n_points(outline)));
    return facets;
}

}  // namespace abut::geometry
