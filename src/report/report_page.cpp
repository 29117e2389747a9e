// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/report_page.hpp"

#include "src/report/page_texts.hpp"

namespace abut::report {

namespace {

constexpr const char *title_begin = "<title>", *title_end = "</title>", *heading_end = "</h1>\n", *footer_begin = "<footer>",
                     *footer_end = "</footer>", *data_begin = "<script type=\"application/json\" id=\"abut-data\">",
                     *data_end = "</script>";

/// The text between two others, the second after the first; empty where they are not there.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t at = text.find(begin);
    if (at == std::string::npos) return "";
    const std::size_t from = at + begin.size(), to = text.find(end, from);
    return to == std::string::npos ? "" : text.substr(from, to - from);
}

}  // namespace

std::string html_page(const std::string& title, const std::string& body, const std::string& footer, const std::string& end,
                      const std::string& style) {
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n" +
           std::string(title_begin) + title + title_end + "\n<style>" + page_style_text() + style +
           "</style>\n</head>\n<body>\n<main>\n<h1>" + title + heading_end + body + footer_begin + footer + footer_end +
           "\n</main>\n" + end + "</body>\n</html>\n";
}

std::string instrument(const std::string& data) {
    return "<style>" + std::string(instrument_style_text()) + "</style>\n" + data_begin + data + data_end +
           "\n<script>//<![CDATA[\n" + instrument_script_text() + "//]]></script>\n";
}

PagePieces pieces_of(const std::string& page) {
    return {between(page, title_begin, title_end), between(page, heading_end, footer_begin),
            between(page, footer_begin, footer_end), between(page, data_begin, data_end)};
}

}  // namespace abut::report
