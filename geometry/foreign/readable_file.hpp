// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <string>

namespace abut::geometry {

/// The size of a file in bytes. Throws InputError where it is missing, cannot be opened, is empty or larger than `most`
/// (hint: what to do then).
std::uintmax_t checked_size(const std::string& path, std::uintmax_t most, const std::string& hint);

}  // namespace abut::geometry
