// SPDX-License-Identifier: GPL-3.0-or-later
// Tables as plain text.
#pragma once
#include <string>
#include <vector>

namespace abut {

using TextRow = std::vector<std::string>;

/// A table as text: columns as wide as their widest entry, two blanks between them, no blanks at the ends of lines.
std::string aligned(const std::vector<TextRow>& rows);

}  // namespace abut
