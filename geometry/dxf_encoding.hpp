// SPDX-License-Identifier: GPL-3.0-or-later
// Text of drawings in the encodings that CAD systems write.
#pragma once
#include <string>
#include <string_view>

namespace abut::geometry::dxf {

bool is_utf8(std::string_view bytes);
std::string latin1_to_utf8(std::string_view bytes);
/// code < 0x10000
void append_utf8(std::string& text, unsigned code);

}  // namespace abut::geometry::dxf
