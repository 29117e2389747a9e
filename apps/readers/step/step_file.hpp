// SPDX-License-Identifier: GPL-3.0-or-later
// The solids of a STEP file, through OpenCASCADE.
#pragma once
#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "geometry/step/step_records.hpp"

namespace abut::geometry {

/// A solid where the assembly places it, in millimetres.
struct StepSolid {
    std::string name;  ///< unique
    TopoDS_Shape shape;
};

/// What a file holds.
struct StepFile {
    std::vector<StepSolid> solids;
    std::string unit;      ///< the file's: "mm", "in", ...
    double unit_size = 1;  ///< millimetres
};

/// Reads a file; what is no solid, is damaged or was guessed goes to `records`. Throws InputError where there are no solids.
StepFile read_step(const std::string& path, StepRecords& records);

}  // namespace abut::geometry
