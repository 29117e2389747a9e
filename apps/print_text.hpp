// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace abut {

/// Prints a text to standard output, with a newline at the end if it has none.
void print_text(const std::string& text);

/// The text with its line breaks turned into spaces, and none at its end: for messages that must stay on one line.
std::string one_line_text(const std::string& text);

}  // namespace abut
