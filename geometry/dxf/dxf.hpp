// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing out of the bytes of a DXF file, for readers that hold no file; read_dxf() (sketch.hpp) reads one.
#pragma once
#include <string>

#include "geometry/sketch/sketch.hpp"

namespace abut::geometry {

/// As read_dxf(); `file` is its name in messages.
Drawing read_dxf_bytes(const std::string& file, std::string bytes);

}  // namespace abut::geometry
