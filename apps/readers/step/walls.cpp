// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/readers/step/walls.hpp"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <cmath>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>

#include "apps/readers/step/plane_curves.hpp"

namespace abut::geometry {

namespace {

gp_Dir direction_of(int axis) {
    return {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
}

bool is_along(const gp_XYZ& step, const gp_Dir& direction) {
    return step.Crossed(direction.XYZ()).Modulus() <= level_angle * step.Modulus();
}

/// Straight rulings along the axis from the first to the last row of poles (in v), with the same weights at both ends.
bool is_extruded_in_v(const Geom_BSplineSurface& surface, const gp_Dir& direction) {
    if (surface.VDegree() != 1 || surface.NbVPoles() != 2) return false;
    for (int k = 1; k <= surface.NbUPoles(); ++k) {
        if (!is_along(surface.Pole(k, 2).XYZ() - surface.Pole(k, 1).XYZ(), direction)) return false;
        if (std::abs(surface.Weight(k, 2) - surface.Weight(k, 1)) > level_angle * surface.Weight(k, 1)) return false;
    }
    return true;
}

Handle(Geom_Curve) profile_of(const Geom_BSplineSurface& given, const gp_Dir& direction, bool& is_along_u) {
    const Handle(Geom_BSplineSurface) surface = Handle(Geom_BSplineSurface)::DownCast(given.Copy());
    is_along_u = is_extruded_in_v(*surface, direction);
    if (is_along_u) return surface->VIso(surface->VKnot(1));
    surface->ExchangeUV();
    if (is_extruded_in_v(*surface, direction)) return surface->VIso(surface->VKnot(1));
    return {};
}

}  // namespace

std::optional<double> cap_height(const TopoDS_Face& face, int axis) {
    const BRepAdaptor_Surface surface(face, Standard_False);
    if (surface.GetType() != GeomAbs_Plane) return std::nullopt;
    const gp_Pln plane = surface.Plane();
    if (!plane.Axis().Direction().IsParallel(direction_of(axis), level_angle)) return std::nullopt;
    return plane.Location().Coord(axis + 1);
}

Handle(Geom_Curve) profile_of(const TopoDS_Face& face, int axis, bool& is_along_u) {
    const gp_Dir direction = direction_of(axis);
    Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    if (surface->IsKind(STANDARD_TYPE(Geom_RectangularTrimmedSurface)))
        surface = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface)->BasisSurface();
    is_along_u = true;
    if (const auto extrusion = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface); !extrusion.IsNull())
        return is_along(extrusion->Direction().XYZ(), direction) ? extrusion->BasisCurve() : Handle(Geom_Curve)();
    if (surface->IsKind(STANDARD_TYPE(Geom_BezierSurface))) surface = GeomConvert::SurfaceToBSplineSurface(surface);
    if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface); !spline.IsNull())
        return profile_of(*spline, direction, is_along_u);
    return {};
}

bool is_wall(const TopoDS_Face& face, int axis) {
    const gp_Dir direction = direction_of(axis);
    const BRepAdaptor_Surface surface(face, Standard_False);
    if (surface.GetType() == GeomAbs_Plane) return surface.Plane().Axis().Direction().IsNormal(direction, level_angle);
    if (surface.GetType() == GeomAbs_Cylinder) return surface.Cylinder().Axis().Direction().IsParallel(direction, level_angle);
    bool is_along_u = true;
    return !profile_of(face, axis, is_along_u).IsNull();
}

}  // namespace abut::geometry
