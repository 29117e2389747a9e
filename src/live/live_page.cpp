// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/live/live_page.hpp"

#include "src/report/page_texts.hpp"

namespace abut {

std::string live_html() {
    return "<!DOCTYPE html>\n<html lang=\"en\" class=\"js\">\n<head>\n<meta charset=\"utf-8\"/>\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>abut live</title>\n"
           "<link rel=\"icon\" href=\"data:,\"/>\n<style>" +
           std::string(report::page_style_text()) + report::live_style_text() +
           "</style>\n</head>\n<body>\n<main>\n<div id=\"live\"></div>\n<noscript><p class=\"verdict failed\">This page needs "
           "JavaScript.</p></noscript>\n</main>\n<script>" +
           report::live_script_text() + "</script>\n</body>\n</html>\n";
}

}  // namespace abut
