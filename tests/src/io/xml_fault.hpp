// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace abut_tests {

/// Empty, or what is wrong with XML of tags, attributes and text: tags that do not match, stray characters.
std::string fault_of_xml(const std::string& text);

}  // namespace abut_tests
