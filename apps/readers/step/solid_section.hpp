// SPDX-License-Identifier: GPL-3.0-or-later
// The section of one solid.
#pragma once
#include <string>

#include "apps/readers/step/plane_curves.hpp"
#include "apps/readers/step/step_file.hpp"

namespace abut::geometry {

/// A plane in OpenCASCADE's millimetres, and the way into it.
struct SolidCut {
    SectionPlane plane;
    PlaneMap map;
    double rounding = 0;  ///< heights closer than this are one
};

/// Writes the outline of one solid, which the plane must meet: of one whose walls all run along the normal that of its upper
/// end, else the section.
void write_outline(const StepSolid& solid, const SolidCut& cut, StepRecords& records);

}  // namespace abut::geometry
