// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of CSV files.
#pragma once
#include <string>

namespace abut {

/// Shortest text that reads back as the same number; an unknown value is an empty field.
std::string csv_field(double value);

/// In quotes where it holds a separator, quotes or a line break.
std::string csv_field(const std::string& text);

}  // namespace abut
