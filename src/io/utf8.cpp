// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/utf8.hpp"

#include <utf8.h>

#include <algorithm>

namespace abut {

std::size_t utf8_length(const std::string& text, std::size_t at) {
    const auto begin = text.begin() + static_cast<std::ptrdiff_t>(at);
    auto end = begin;
    try {
        utf8::next(end, text.end());
    } catch (const utf8::exception&) { return 0; }
    return static_cast<std::size_t>(end - begin);
}

std::size_t text_width(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace abut
