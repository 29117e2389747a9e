// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace abut {

/// Text safe inside XML.
std::string escape_xml(const std::string& text);

}  // namespace abut
