// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/content_hash.hpp"

#include <xxhash.h>

#include <array>
#include <cinttypes>
#include <cstdio>

namespace abut {

std::string content_hash(std::string_view bytes) {
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016" PRIx64, XXH3_64bits(bytes.data(), bytes.size()));
    return text.data();
}

}  // namespace abut
