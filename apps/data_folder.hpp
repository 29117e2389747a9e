// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "apps/arguments.hpp"

namespace abut {

/// The folder data/ that came with the program: --data where given; else share/abut of the place where the program is
/// installed; else that of the sources it was built from. Throws InputError where there is none.
std::string data_folder(const Arguments& arguments);

/// The folder schema/ of it; without options.
std::string schema_folder();

}  // namespace abut
