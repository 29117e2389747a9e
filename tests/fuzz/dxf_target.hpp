// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes as a DXF file: groups, sections, records, curves, blocks, and the parts that they bound.
#pragma once
#include <string>

#include "geometry/dxf/dxf.hpp"
#include "tests/fuzz/drawing_faults.hpp"

namespace abut::fuzz {

/// The way to tell parts apart is a matter of the number of bytes, so that all of them are tried and each input gives one.
inline geometry::PartsBy parts_by_of_size(std::size_t n) {
    using geometry::PartsBy;
    constexpr PartsBy ways[] = {PartsBy::automatic, PartsBy::layer, PartsBy::block, PartsBy::loop, PartsBy::color};
    return ways[n % std::size(ways)];
}

/// Empty where all is well; a refusal is well.
inline std::string fault_of_dxf(const std::string& bytes) {
    try {
        const geometry::Drawing drawing = geometry::read_dxf_bytes("fuzzed.dxf", bytes);
        const std::string fault = fault_of_drawing(drawing);
        if (!fault.empty() || !is_small(drawing)) return fault;
        geometry::SketchOptions options;
        options.parts_by = parts_by_of_size(bytes.size());
        constexpr std::size_t one_in = 3;  // has its blocks outlined
        if (bytes.size() % one_in == 0) options.block_outline = {"*"};
        return fault_of_parts(geometry::parts_of(drawing, options));
    } catch (const InputError& error) { return fault_of_refusal(error); }
}

}  // namespace abut::fuzz
