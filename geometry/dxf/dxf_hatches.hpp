// SPDX-License-Identifier: GPL-3.0-or-later
// Boundaries of HATCH records.
#pragma once
#include "geometry/dxf/dxf_prepass.hpp"

namespace abut::geometry::dxf {

/// The closed loops that a HATCH fills, in the coordinates of its plane, with its pattern, layer left empty. Splines are
/// polylines through their control points. Without loops where the record cannot be read: it only says where there is material.
Hatch read_hatch(const Record& record);

}  // namespace abut::geometry::dxf
