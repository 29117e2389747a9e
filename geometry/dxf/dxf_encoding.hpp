// SPDX-License-Identifier: GPL-3.0-or-later
// Text of drawings in the encodings that CAD systems write.
#pragma once
#include <string>
#include <string_view>

namespace abut::geometry::dxf {

/// The bytes as UTF-8 text: they are UTF-8 already, or in the code page that the drawing's header names ("ANSI_1252",
/// "ANSI_936", "DOS850"); where that is none known, or the bytes are not of it, Latin-1, in which everything is a text.
std::string to_utf8(std::string bytes, std::string_view code_page);
/// The value of $DWGCODEPAGE in the header of an ASCII file, empty if it states none.
std::string_view stated_code_page(std::string_view bytes);

}  // namespace abut::geometry::dxf
