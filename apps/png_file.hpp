// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures as pixels, by rsvg-convert (Debian's librsvg2-bin), a program of its own: a library would cost every start.
#pragma once
#include <string>

namespace abut {

inline constexpr const char* png_program = "rsvg-convert";

/// Can pictures be turned into pixels here?
bool can_write_png();

/// Writes DIR/name.png, with two pixels for each of the picture DIR/svg. Throws InputError where that fails.
void write_png(const std::string& folder, const std::string& name, const std::string& svg);

}  // namespace abut
