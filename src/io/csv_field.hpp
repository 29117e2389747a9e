// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of CSV files.
#pragma once
#include <string>

namespace abut {

/// The shortest text that reads back as the same number; an unknown value is an empty field.
std::string csv_field(double value);

/// A text as a field: in quotes where it holds a separator, quotes or a line break.
std::string csv_field(const std::string& text);

}  // namespace abut
