// SPDX-License-Identifier: GPL-3.0-or-later
// One closed polyline of a section, recovered as lines and arcs.
#pragma once
#include <vector>

#include "geometry/sketch/arc_fit_curves.hpp"

namespace abut::geometry {

/// A line or a curve that an outline was recovered as, with the facets that it stands for.
struct RecoveredPiece {
    enum class Kind {
        line,    ///< a line as the section has it; through several points within the tolerance
        arc,     ///< vertices on one circle
        circle,  ///< all vertices on one circle
        curve    ///< arcs through the vertices of a curve
    };
    Kind kind = Kind::line;
    std::vector<Curve> curves;  ///< one after the other
    int first = 0, n_facets = 0;
    double residual = 0;  ///< largest distance of its points from it
    double sagitta = 0;   ///< its largest distance from its facets; 0 of lines
};

/// A closed polyline and the pieces that it was recovered as.
struct RecoveredOutline {
    std::vector<Vec2> points;
    std::vector<RecoveredPiece> pieces;  ///< in order along the points
};

/// Recovers a closed polyline as lines and arcs; with `recognise_arcs` false as lines from point to point. Cost near linear.
RecoveredOutline outline_of(const std::vector<Vec2>& points, double tolerance, bool recognise_arcs);

/// Point k of the outline, counted on around it.
const Vec2& point_of(const RecoveredOutline& outline, int k);

/// The piece as lines from point to point.
std::vector<RecoveredPiece> facets_of(const RecoveredOutline& outline, const RecoveredPiece& piece);

}  // namespace abut::geometry
