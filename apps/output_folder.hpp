// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace abut {

/// Makes sure, before any long computation, that files can be written to the folder; creates it. Throws InputError if not.
void prepare_output_folder(const std::string& folder);

/// A file's path for messages, "DIR/name", without a doubled slash.
std::string path_in(const std::string& folder, const std::string& name);

}  // namespace abut
