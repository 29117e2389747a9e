// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "src/reference/reference.hpp"

namespace abut {

/// abut(1) in roff: the commands with their options, the exit status, and the keys of all files.
std::string man_page(const std::vector<ReferencePage>& pages);

}  // namespace abut
