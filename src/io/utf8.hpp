// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string>

namespace abut {

/// The length of the UTF-8 character that begins at text[at], 0 if there is none (RFC 3629, section 4). Throws nothing.
std::size_t utf8_length(const std::string& text, std::size_t at);

/// The number of characters of UTF-8 text as they are seen; of other bytes some number, without a throw.
std::size_t text_width(const std::string& text);

}  // namespace abut
