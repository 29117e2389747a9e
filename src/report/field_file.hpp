// SPDX-License-Identifier: GPL-3.0-or-later
// Fields as files of VTK, which ParaView, VisIt and meshio read.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "src/results/result.hpp"

namespace abut {

/// fields.vtu: an unstructured grid of all parts that have fields, undeformed, in the scene's units. Points have `displacement`
/// (x, y, 0), `stress` (XX, YY, ZZ, XY, YZ, XZ) and `von Mises stress`; cells have the number of their part, `part`, from 1 in
/// the order of result.json. Numbers are as binary as the field has them, doubles in base64.
std::string fields_vtu(const Result& result);

/// fields.pvd: files of a series, in their order, as times 1, 2, ...; each with its name.
std::string fields_pvd(const std::vector<std::pair<std::string, std::string>>& names_and_files);

}  // namespace abut
