// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace abut {

/// Bytes as base64 with padding (RFC 4648, section 4).
std::string base64(const std::vector<std::uint8_t>& bytes);

}  // namespace abut
