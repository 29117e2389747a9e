// SPDX-License-Identifier: GPL-3.0-or-later
// PLY files looked at before a library reads them.
#pragma once
#include <cstdint>
#include <string>

namespace abut::geometry {

/// Checks a PLY file, since assimp reads for ever where the header does not end, as long as the header says, and beyond the end
/// of what a binary file holds. Throws InputError for a header that is none or does not end, for types there are not, for fewer
/// elements than stated, and for faces of vertices that are not there. `size` of the file, bytes. Cost: a pass over the bytes.
void check_ply(const std::string& path, std::uintmax_t size);

}  // namespace abut::geometry
