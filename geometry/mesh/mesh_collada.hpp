// SPDX-License-Identifier: GPL-3.0-or-later
// COLLADA files looked at before a library reads them.
#pragma once
#include <cstdint>
#include <string>

namespace abut::geometry {

/// Checks a COLLADA file for what assimp reads for ever at, or falls over: a list of numbers that holds anything else, an
/// attribute that is missing, an absurd number. Throws InputError for lists that are none or shorter than stated, and elements
/// of the geometry and of the nodes without the attributes they need. `size` of the file, bytes. Cost: a pass over the bytes.
void check_collada(const std::string& path, std::uintmax_t size);

}  // namespace abut::geometry
