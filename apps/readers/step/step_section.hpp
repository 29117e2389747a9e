// SPDX-License-Identifier: GPL-3.0-or-later
// The section of the solids of a STEP file.
#pragma once
#include "apps/readers/step/step_file.hpp"
#include "geometry/mesh/section_plane.hpp"

namespace abut::geometry {

/// Cuts all solids and writes their outlines. choice.at is in the file's unit.
void write_section(const StepFile& file, const SectionChoice& choice, StepRecords& records);

}  // namespace abut::geometry
