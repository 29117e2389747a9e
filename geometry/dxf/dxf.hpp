// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "geometry/sketch/sketch.hpp"

namespace abut::geometry {

/// Reads a DXF file, ASCII or binary, with its blocks inserted. Throws InputError (file, line) if it is missing, empty,
/// truncated or no DXF.
Drawing read_dxf(const std::string& path);
/// The same out of the bytes of a DXF file, for readers that hold no file; `file` is its name in messages.
Drawing read_dxf_bytes(const std::string& file, std::string bytes);

}  // namespace abut::geometry
