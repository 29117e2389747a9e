// SPDX-License-Identifier: GPL-3.0-or-later
// The frame of all pages that abut writes.
#pragma once
#include <string>

namespace abut::report {

/// A page with its style; title and footer: escaped text; end: what follows after it, empty, a script or instrument(); style:
/// what the page has beside the style of all.
std::string html_page(const std::string& title, const std::string& body, const std::string& footer, const std::string& end = "",
                      const std::string& style = "");

/// What the script needs, in a form that is XML as well as HTML: style, data and script. It fills the element `instrument` of
/// the body.
std::string instrument(const std::string& data);

/// A page taken apart again; empty texts where it has no such thing.
struct PagePieces {
    std::string title, body, footer, data;
};
PagePieces pieces_of(const std::string& page);

}  // namespace abut::report
