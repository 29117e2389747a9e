// SPDX-License-Identifier: GPL-3.0-or-later
// Binary DXF: the same groups as in ASCII files, without line ends.
#pragma once
#include <string_view>

#include "geometry/dxf/dxf_groups.hpp"

namespace abut::geometry::dxf {

/// Do the bytes begin with the sentinel of binary DXF?
bool is_binary_dxf(std::string_view bytes);

/// Splits the bytes of a binary DXF file into groups, as split_groups() does those of an ASCII file. Numbers become their
/// shortest decimal text, which reads back as the same number. Group codes take one byte up to R12 (255 and two more bytes for
/// larger ones) and two bytes later on: told apart by the first group. Throws InputError (file, byte) where a value runs over
/// the end or a code is of no known type.
Groups split_binary_groups(const std::string& file, std::string_view bytes);

}  // namespace abut::geometry::dxf
