// SPDX-License-Identifier: GPL-3.0-or-later
// A function that vanishes on one edge and nowhere else: the field of its whole line, circle or ellipse, trimmed.
//
// Legend: f normalised field of the untrimmed curve, positive on the edge's left; g trimming function, positive along the edge
// and negative on the rest of the curve, 0 at the ends; a half the chord; w the result:
//     w = sqrt(f^2 + ((sqrt(g^2 + (f^2/a)^2) - g) / 2)^2)        [Biswas04; Shapiro99]
// Differences to the literature: f^4 is divided by a^2, so that the field does not depend on the unit of length; where g > 0
// the root's sign is f's, which makes w smooth across the edge. Trimmed is not with the disc about the chord, which fails for
// arcs of half a turn and more, but with the circle that meets the edge's own at right angles at both ends: the disc about the
// chord for lines, a half plane for half circles, the outside of a disc for more than that.
// Lines and circles: with z from the middle of the chord, h half the sweep, e the outward direction across the chord and
// p = (a^2 - z.z)/(2a):   f = sin h p - cos h z.e,   g = cos h p + sin h z.e.
// Ellipses take the same in coordinates in which they are the unit circle, then normalised; splines have no f of low degree:
// their w is the true distance (curve_distance.hpp).
#pragma once
#include "geometry/implicit/curve_distance.hpp"

namespace abut::geometry {

/// What evaluation needs of a segment, arc or elliptic arc. The plane is seen in a frame in which the curve is a segment or a
/// circular arc: z = frame_x, frame_y . (p - middle).
struct TrimmedConic {
    Vec2 middle{0, 0};
    Vec2 across{0, 0};  ///< e in the frame
    Vec2 frame_x{1, 0}, frame_y{0, 1};
    bool is_closed = false;       ///< then there is nothing to trim
    double half_chord = 0;        ///< a in the frame; 0 for closed curves
    double cosine = 1, sine = 0;  ///< of h
    double radius = 0;            ///< of circles in the frame (1 for ellipses); 0: a segment
    double side = 1;              ///< -1 where the material lies outside of the circle
    double unit = 1;              ///< length of a unit of the frame, for g and a
    bool is_ellipse = false;
    double a = 1, b = 1;  ///< semi-axes of ellipses, along the frame's x and y
};

TrimmedConic trimmed_conic(const Segment& segment);
TrimmedConic trimmed_conic(const Arc& arc);
TrimmedConic trimmed_conic(const EllipticArc& arc);

/// The field f of the untrimmed curve.
double whole_curve(const TrimmedConic& conic, const PointOf<double>& p);
Jet whole_curve(const TrimmedConic& conic, const PointOf<Jet>& p);

/// The trimmed field w.
NearCurve<double> trimmed(const TrimmedConic& conic, const PointOf<double>& p);
NearCurve<Jet> trimmed(const TrimmedConic& conic, const PointOf<Jet>& p);

/// What evaluation needs of any edge: a conic, or the curve of a spline.
struct TrimmedEdge {
    bool is_conic = true;
    TrimmedConic conic;
    Curve curve;  ///< of splines
};
TrimmedEdge trimmed_edge(const Curve& curve);
NearCurve<double> trimmed(const TrimmedEdge& edge, const PointOf<double>& p);
NearCurve<Jet> trimmed(const TrimmedEdge& edge, const PointOf<Jet>& p);

}  // namespace abut::geometry
