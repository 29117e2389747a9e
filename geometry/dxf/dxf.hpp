// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "geometry/sketch/sketch.hpp"

namespace abut::geometry {

/// Which layers are read, as patterns with * and ?.
struct LayerFilter {
    std::vector<std::string> only;    ///< empty: all but those that hold no outlines by their names (data/drafting_layers.csv)
    std::vector<std::string> ignore;  ///< counts first
};

/// Reads a DXF file, ASCII or binary, with its blocks inserted. Throws InputError (file, line) if it is missing, empty,
/// truncated or no DXF.
Drawing read_dxf(const std::string& path, const LayerFilter& layers = {});
/// Reads a DXF file from its bytes, for readers that hold no file; `file` is its name in messages. Throws InputError where they
/// are empty, truncated or no DXF.
Drawing read_dxf_bytes(const std::string& file, std::string bytes, const LayerFilter& layers = {});

}  // namespace abut::geometry
