// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/escape_xml.hpp"

namespace abut {

std::string escape_xml(const std::string& text) {
    std::string safe;
    for (char c : text) {
        if (c == '&')
            safe += "&amp;";
        else if (c == '<')
            safe += "&lt;";
        else if (c == '>')
            safe += "&gt;";
        else if (c == '"')
            safe += "&quot;";
        else if (c == '\'')
            safe += "&#39;";
        else if (static_cast<unsigned char>(c) >= 32 || c == '\n' || c == '\t')
            safe += c;  // other control characters are not XML
    }
    return safe;
}

}  // namespace abut
