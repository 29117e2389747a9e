// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/print_text.hpp"

#include <algorithm>
#include <iostream>

namespace abut {

void print_text(const std::string& text) {
    std::cout << text;
    if (text.empty() || text.back() != '\n') std::cout << '\n';
}

std::string one_line_text(const std::string& text) {
    std::string line = text.substr(0, text.find_last_not_of("\r\n") + 1);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return line;
}

}  // namespace abut
