// SPDX-License-Identifier: GPL-3.0-or-later
// SPLINE records: by control points, or by the points that they pass through.
#pragma once
#include "geometry/dxf/dxf_entities.hpp"

namespace abut::geometry::dxf {

/// Reads a SPLINE record as curves: by control points with knots (none: uniform, clamped at the ends), weights (none: all 1)
/// and degree, of which a closed one may leave out those that repeat; without control points as the cubic through the fit
/// points (spline_through.hpp). Cut into smooth pieces; pieces of degree 1 are lines.
Outline read_spline(const Record& record);

}  // namespace abut::geometry::dxf
