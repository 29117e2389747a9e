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

#include "geometry/sketch/arc_fit.hpp"

namespace abut::geometry {

/// The largest ratio of the lengths of neighbouring facets of a curve: exporters halve intervals where they need to.
inline constexpr double most_length_step = 3;
/// The largest ratio of the curvatures at neighbouring vertices. A line that meets a curve tangentially halves the curvature at
/// their joint, or more.
inline constexpr double most_curvature_step = 1.75;
/// A run's outer facets, which have only one vertex within the run, turn by at most so many times what the others do, and
/// stand off by at most so many times: exporters bound both. Others are lines beside a curve.
inline constexpr double most_turn_beyond_others = 1.25;
inline constexpr double most_sagitta_beyond_others = 2;

/// Where facets stand off by less than the tolerance, one or two arcs replace as many as leave each vertex within this part of
/// the smallest sagitta of theirs. Elsewhere arcs pass through every vertex: what touched there still does.
inline constexpr double vertex_share = 0.25;

/// Points first..last (indices, modulo their number) of a closed polyline.
struct FacetCurve {
    std::vector<Curve> arcs;  ///< tangential to each other within most_arc_kink; they begin and end at vertices, to rounding
    int first = 0, last = 0;  ///< equal: all the way around
    int n_facets = 0;
    double residual = 0;  ///< largest distance of its points from it
    double sagitta = 0;   ///< its largest distance from its facets
};

/// Curves through runs of facets of the closed polyline, in the order of its points. `pieces` are those of fit_lines_and_arcs
/// with this tolerance. A run takes facets that they leave as single lines, and pieces that are off their points by more than
/// rounding, wholly or not at all: lines as part of more; arcs as part of more, or where the points are farther from them than
/// the facets are. Where the polyline goes on as it would, a curve's ends are tangential to what is beside them. Arcs turn the
/// way their facets turn, and lie between these and the tangents at their ends. Deterministic; cost O(n).
std::vector<FacetCurve> curves_through_facets(const std::vector<Vec2>& points, const std::vector<FittedPiece>& pieces,
                                              double tolerance);

}  // namespace abut::geometry
