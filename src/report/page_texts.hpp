// SPDX-License-Identifier: GPL-3.0-or-later
// Texts that are compiled in from files (src/CMakeLists.txt).
#pragma once

namespace abut::report {

/// The style sheet of all pages: src/report/web/page.css.
const char* page_style_text();
/// What the report's script needs besides, and the script: src/report/web/bundle/, made by src/report/web/build.mjs.
const char* instrument_style_text();
const char* instrument_script_text();
/// What the page of `abut live` needs besides, and its script: src/report/web/bundle/, too.
const char* live_style_text();
const char* live_script_text();

}  // namespace abut::report
