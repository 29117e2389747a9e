// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/dxf_encoding.hpp"

namespace abut::geometry::dxf {

namespace {

bool is_continuation(unsigned char byte) {
    return (byte & 0xC0) == 0x80;
}

/// Bytes that the UTF-8 lead byte asks for, 0 where it is no lead byte.
std::size_t sequence_length(unsigned char lead) {
    if (lead < 0x80) return 1;
    if (lead >= 0xC2 && lead < 0xE0) return 2;
    if (lead >= 0xE0 && lead < 0xF0) return 3;
    if (lead >= 0xF0 && lead < 0xF5) return 4;
    return 0;
}

/// Overlong three- and four-byte forms, surrogates and values beyond U+10FFFF, all seen in the second byte.
bool is_forbidden_pair(unsigned char lead, unsigned char second) {
    return (lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F) || (lead == 0xF0 && second < 0x90) ||
           (lead == 0xF4 && second > 0x8F);
}

}  // namespace

bool is_utf8(std::string_view bytes) {
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    for (std::size_t i = 0; i < bytes.size();) {
        const std::size_t n = sequence_length(at(i));
        if (n == 0 || i + n > bytes.size()) return false;
        if (n > 1 && is_forbidden_pair(at(i), at(i + 1))) return false;
        for (std::size_t k = 1; k < n; ++k)
            if (!is_continuation(at(i + k))) return false;
        i += n;
    }
    return true;
}

void append_utf8(std::string& text, unsigned code) {
    const auto add = [&](unsigned byte) { text += static_cast<char>(byte); };
    if (code < 0x80) {
        add(code);
    } else if (code < 0x800) {
        add(0xC0 | (code >> 6));
        add(0x80 | (code & 0x3F));
    } else {
        add(0xE0 | (code >> 12));
        add(0x80 | ((code >> 6) & 0x3F));
        add(0x80 | (code & 0x3F));
    }
}

std::string latin1_to_utf8(std::string_view bytes) {
    std::string text;
    for (char c : bytes) append_utf8(text, static_cast<unsigned char>(c));
    return text;
}

}  // namespace abut::geometry::dxf
