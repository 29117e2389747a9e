// SPDX-License-Identifier: GPL-3.0-or-later
// The field of a part in few bytes, for the page's script (src/report/web/data.js unpacks it).
#pragma once
#include <array>
#include <string>

#include "src/results/result.hpp"

namespace abut::report {

/// Components of a sample, in their order: u_x, u_y, xx, yy, xy, zz.
inline constexpr std::size_t n_components = 6;

/// The field of a part. Integers are written as differences, signed, in groups of seven bits, the lowest first, in base64: of a
/// sample its place (x and y in units of `step` from the origin) and its components (32767 is the component's scale, -32768
/// stands for what is not finite), each less that of the sample before.
struct PackedField {
    Vec2 origin{0, 0};
    double step = 1;
    std::array<double, n_components> scale{};
    std::string samples;
    std::size_t n_inside = 0;  ///< the first of them lie inside the part, the others beyond its boundary
    std::string patches;       ///< four samples each: the first less that of the patch before, the others less the first
    std::vector<std::size_t> loop_sizes;  ///< points of each loop of the boundary
    std::string loops;                    ///< samples, as above
};

/// Packs the field of a part; where there is none, the boundary alone. Errors of values: half a unit of 16 bits.
PackedField packed_field(const PartField& field, const geometry::Part& part);

}  // namespace abut::report
