// SPDX-License-Identifier: GPL-3.0-or-later
// Boundaries of HATCH records.
#pragma once
#include "geometry/dxf/dxf_ignored.hpp"
#include "geometry/dxf/dxf_placement.hpp"
#include "geometry/dxf/dxf_prepass.hpp"

namespace abut::geometry::dxf {

/// The closed loops that a HATCH fills, and how it looks. Splines are polylines through their control points. Without loops
/// where the record cannot be read: it only says where there is material.
Hatch read_hatch(const Record& record, const Look& look);

/// Moves a hatch: its loops, and the lines of its pattern with them.
void place_hatch(Hatch& hatch, const Placement& placement);

}  // namespace abut::geometry::dxf
