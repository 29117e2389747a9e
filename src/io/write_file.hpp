// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace abut {

/// Writes text to DIR/name by way of a temporary name; creates DIR. Throws InputError naming the file where it cannot.
void write_file(const std::string& directory, const std::string& name, const std::string& text);

}  // namespace abut
