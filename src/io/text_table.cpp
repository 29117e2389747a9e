// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/text_table.hpp"

#include <algorithm>

#include "src/io/utf8.hpp"

namespace abut {

std::string aligned(const std::vector<TextRow>& rows) {
    std::vector<std::size_t> width;
    for (const TextRow& row : rows) {
        width.resize(std::max(width.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], text_width(row[i]));
    }
    std::string text;
    for (const TextRow& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) line += row[i] + std::string(width[i] - text_width(row[i]) + 2, ' ');
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

}  // namespace abut
