// SPDX-License-Identifier: GPL-3.0-or-later
// STEP files (AP203, AP214, AP242): assemblies of solids, cut by a plane into a drawing.
#pragma once
#include <cstdint>
#include <string>

#include "geometry/mesh/section_plane.hpp"
#include "geometry/sketch/sketch.hpp"

namespace abut::geometry {

/// The largest size of a STEP file, bytes.
inline constexpr std::uintmax_t most_step_bytes = 256u << 20;

/// Can a file of this name be a STEP file (by its ending, .step or .stp)?
bool is_step_file(const std::string& path);

/// Reads a STEP file through OpenCASCADE, and cuts its solids: one layer per solid, named after its product (`name`; further
/// ones of the name are `name#1`, ...; the solids of a product of several `name#0`, `name#1`, ...; `solid1`, ... without
/// one), where the assembly places it. Lines, circles, ellipses and splines are those of the file; what the library had to
/// approximate is a repair, with its tolerance. A solid whose walls all run along the plane's normal gives the outline of its
/// end. The drawing's numbers, and choice.at, are in the file's unit. That the plane was moved, a closed shell taken
/// for a solid, or a solid is open are repairs; solids that the plane does not meet, and what is no solid, are ignored with
/// the reason. Throws InputError where nothing can be read: missing, empty, too large or damaged files, no solids, and no
/// program that reads STEP.
Drawing read_step_file(const std::string& path, const SectionChoice& choice);

}  // namespace abut::geometry
