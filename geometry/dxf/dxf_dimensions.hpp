// SPDX-License-Identifier: GPL-3.0-or-later
// What a drawing's dimensions say beside what is drawn: a drawing to a scale has other sizes than its lines.
#pragma once
#include "geometry/dxf/dxf_prepass.hpp"

namespace abut::geometry::dxf {

/// Warns where linear, aligned, diametric and radial dimensions of model space say something else than the distance of their
/// points: all of them by the same factor where most do, else one by one, the first few. What they say is their text, or that
/// distance times the factor of their style (DIMLFAC) where it stands for the measurement; texts that are no plain number say
/// nothing, nor do diameters over a distance, which half sections show half. Rounding to the last digit of a text is none of
/// it.
void tell_other_dimensions(const Structure& structure, Drawing& drawing);

}  // namespace abut::geometry::dxf
