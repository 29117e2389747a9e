// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "geometry/sketch/sketch.hpp"

namespace abut::geometry {

/// Reads a DXF file, ASCII or binary, with its blocks inserted. Throws InputError (file, line) if it is missing, empty,
/// truncated or no DXF.
Drawing read_dxf(const std::string& path);
/// Reads a DXF file from its bytes, for readers that hold no file; `file` is its name in messages. Throws InputError where they
/// are empty, truncated or no DXF.
Drawing read_dxf_bytes(const std::string& file, std::string bytes);

}  // namespace abut::geometry
