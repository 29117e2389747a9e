// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

namespace abut {

/// 16 hexadecimal digits (XXH3, 64 bits). Tells changes of files apart, not forgeries.
std::string content_hash(std::string_view bytes);

/// A file that was read, and the hash of its contents.
struct HashedFile {
    std::string file, hash;
};

}  // namespace abut
