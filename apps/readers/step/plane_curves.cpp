// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/readers/step/plane_curves.hpp"

#include <GeomAdaptor_Curve.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>
#include <numbers>

namespace abut::geometry {

namespace {

/// Rounding must not make more than a whole turn.
double sweep_between(double from, double to) {
    return std::min(to - from, 2 * std::numbers::pi);
}

bool is_level(const gp_Ax1& axis, int plane_axis) {
    gp_XYZ normal(0, 0, 0);
    normal.SetCoord(plane_axis + 1, 1);
    return axis.Direction().IsParallel(gp_Dir(normal), level_angle);
}

Arc arc_of(const gp_Circ& circle, double from, double to, const PlaneMap& map) {
    const Vec2 x = map(circle.XAxis().Direction().XYZ()), y = map(circle.YAxis().Direction().XYZ());
    const double turns = x.x() * y.y() - x.y() * y.x() > 0 ? 1 : -1, at_zero = std::atan2(x.y(), x.x());
    return {map(circle.Location().XYZ()), map.scale * circle.Radius(), at_zero + turns * from, turns * sweep_between(from, to)};
}

EllipticArc arc_of(const gp_Elips& ellipse, double from, double to, const PlaneMap& map) {
    return {map(ellipse.Location().XYZ()), ellipse.MajorRadius() * map(ellipse.XAxis().Direction().XYZ()),
            ellipse.MinorRadius() * map(ellipse.YAxis().Direction().XYZ()), from, sweep_between(from, to)};
}

Nurbs nurbs_of(const Geom_BSplineCurve& spline, const PlaneMap& map) {
    Nurbs nurbs;
    nurbs.degree = spline.Degree();
    for (int k = 1; k <= spline.NbKnots(); ++k)
        nurbs.knots.insert(nurbs.knots.end(), static_cast<std::size_t>(spline.Multiplicity(k)), spline.Knot(k));
    for (int k = 1; k <= spline.NbPoles(); ++k) {
        nurbs.points.push_back(map(spline.Pole(k).XYZ()));
        if (spline.IsRational()) nurbs.weights.push_back(spline.Weight(k));
    }
    return nurbs;
}

/// The whole of a spline is left as it is.
Handle(Geom_BSplineCurve) portion(const Handle(Geom_BSplineCurve) & spline, double from, double to) {
    const Handle(Geom_BSplineCurve) part = Handle(Geom_BSplineCurve)::DownCast(spline->Copy());
    const double rounding = Precision::PConfusion();
    if (from > part->FirstParameter() + rounding || to < part->LastParameter() - rounding) {
        part->Segment(from, to);
    } else if (part->IsPeriodic()) {
        part->SetNotPeriodic();
    }
    return part;
}

}  // namespace

SectionCurve plane_curve(const Handle(Geom_Curve) & curve, double from, double to, const PlaneMap& map, double& tolerance) {
    tolerance = 0;
    const GeomAdaptor_Curve known(curve, from, to);
    if (known.GetType() == GeomAbs_Line) return Segment{map(known.Value(from).XYZ()), map(known.Value(to).XYZ())};
    if (known.GetType() == GeomAbs_Circle && is_level(known.Circle().Axis(), map.axis))
        return arc_of(known.Circle(), from, to, map);
    if (known.GetType() == GeomAbs_Ellipse && is_level(known.Ellipse().Axis(), map.axis))
        return arc_of(known.Ellipse(), from, to, map);
    if (known.GetType() == GeomAbs_BSplineCurve) return nurbs_of(*portion(known.BSpline(), from, to), map);
    if (known.GetType() == GeomAbs_OffsetCurve || known.GetType() == GeomAbs_OtherCurve)
        tolerance = map.scale * Precision::Approximation();
    return nurbs_of(*GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(curve, from, to)), map);
}

}  // namespace abut::geometry
