// SPDX-License-Identifier: GPL-3.0-or-later
// Facets of curves that are no circles: arcs through their vertices, tangential to each other.
//
// The vertices of an exported curve lie on it, its facets beside it by their sagitta, L * turn / 8. A run of facets is taken
// for a curve where
//   - all turn the same way, each by at most largest_facet_turn, and there are at least least_facets of them;
//   - from one to the next the length changes by a factor of most_length_step at most, the curvature (turn by length) by
//     most_curvature_step. So corners, lines that the curve is tangent to, and polygons of unlike sides end a run or are none.
// What no rule can tell from a curve is a polygon of sides and turns nearly alike, of 24 sides and more if it were regular:
// those who mean one switch the recognition off (SectionOptions::recognise_arcs).
#pragma once
#include <vector>

#include "geometry/arc_fit.hpp"

namespace abut::geometry {

/// Of neighbouring facets: exporters halve intervals where they need to.
inline constexpr double most_length_step = 3;
/// Of neighbouring vertices. A line that meets a curve tangentially halves the curvature at their joint, or more.
inline constexpr double most_curvature_step = 1.75;
/// A run's outer facets, which have only one vertex within the run, turn by at most so many times what the others do, and
/// stand off by at most so many times: exporters bound both. Others are lines beside a curve.
inline constexpr double most_turn_beyond_others = 1.25;
inline constexpr double most_sagitta_beyond_others = 2;
/// Two arcs replace several facets where they pass the vertices within this part of the smallest sagitta of these facets.
inline constexpr double vertex_share = 0.05;

/// Points first..last (indices, modulo their number) of a closed polyline.
struct FacetCurve {
    std::vector<Curve> arcs;  ///< tangential to each other; they begin and end at the first and last point, to rounding
    int first = 0, last = 0;  ///< equal: all the way around
    int n_facets = 0;
    double residual = 0;  ///< largest distance of its points from it: vertex_share of the sagitta at most
    double sagitta = 0;   ///< its largest distance from its facets
};

/// Curves through those facets of the closed polyline that `pieces` (of fit_lines_and_arcs) left as single lines, in the order
/// of the points. Where the polyline goes on as it would, a curve's ends are tangential to what is beside them. Arcs turn the
/// way their facets turn, and lie between these and the tangents at their ends. Deterministic; cost O(n).
std::vector<FacetCurve> curves_through_facets(const std::vector<Vec2>& points, const std::vector<FittedPiece>& pieces);

}  // namespace abut::geometry
