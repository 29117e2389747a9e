// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of a solid as seen along the normal of a section.
#pragma once
#include <Geom_Curve.hxx>
#include <TopoDS_Face.hxx>
#include <optional>

namespace abut::geometry {

/// The height of a plane face that is parallel to the section; nothing of other faces.
std::optional<double> cap_height(const TopoDS_Face& face, int axis);

/// The curve that a face is an extrusion of, along the axis, with its parameter; null where it is none, or is one of a plane,
/// cylinder or other surface whose section is known in closed form.
Handle(Geom_Curve) profile_of(const TopoDS_Face& face, int axis, bool& is_along_u);

/// Does the face run along the axis all over?
bool is_wall(const TopoDS_Face& face, int axis);

}  // namespace abut::geometry
