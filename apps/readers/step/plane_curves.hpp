// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of OpenCASCADE as our own.
#pragma once
#include <BRepAdaptor_Curve.hxx>
#include <Geom_Curve.hxx>
#include <gp_Pnt.hxx>

#include "geometry/mesh/section_plane.hpp"
#include "geometry/step/step_records.hpp"

namespace abut::geometry {

/// Directions closer than this (radians) are one: over a whole part that makes no more difference than rounding.
inline constexpr double level_angle = 1e-9;

/// From OpenCASCADE's space to the plane of a section.
struct PlaneMap {
    int axis = 2;
    double scale = 1;  ///< of lengths

    Vec2 operator()(const gp_XYZ& p) const { return scale * in_plane({p.X(), p.Y(), p.Z()}, axis); }
};

/// A curve between two of its parameters, seen along the plane's normal. It must lie in a plane parallel to it. Lines, circles,
/// ellipses and splines stay what they are, conics become rational splines. `tolerance`: 0, or within what it is approximated.
SectionCurve plane_curve(const Handle(Geom_Curve) & curve, double from, double to, const PlaneMap& map, double& tolerance);

}  // namespace abut::geometry
