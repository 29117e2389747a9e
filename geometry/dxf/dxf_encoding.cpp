// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/dxf/dxf_encoding.hpp"

#include <iconv.h>
#include <utf8.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <optional>
#include <utility>

namespace abut::geometry::dxf {

namespace {

std::string latin1_to_utf8(std::string_view bytes) {
    std::string text;
    for (char c : bytes) utf8::append(static_cast<unsigned char>(c), std::back_inserter(text));
    return text;
}

bool is_number(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// The name that the C library knows the code page by; empty for those that it is not asked for.
std::string library_name(std::string_view code_page) {
    std::string upper(code_page);
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    const std::pair<std::string_view, std::string_view> kinds[] = {
        {"ANSI_", "CP"}, {"DOS", "CP"}, {"ISO8859-", "ISO-8859-"}, {"ISO_8859-", "ISO-8859-"}};
    for (const auto& [prefix, name] : kinds)
        if (upper.starts_with(prefix) && is_number(std::string_view(upper).substr(prefix.size())))
            return std::string(name) + upper.substr(prefix.size());
    return {};
}

std::optional<std::string> decoded(std::string bytes, std::string_view code_page) {
    const std::string name = library_name(code_page);
    if (name.empty()) return std::nullopt;
    const iconv_t converter = iconv_open("UTF-8", name.c_str());
    if (converter == reinterpret_cast<iconv_t>(-1)) return std::nullopt;
    constexpr std::size_t most_bytes_each = 4;  // of one character in UTF-8, and no code page has one in less than a byte
    std::string text(most_bytes_each * bytes.size(), '\0');
    char *from = bytes.data(), *to = text.data();
    std::size_t n_from = bytes.size(), n_to = text.size();
    const bool is_whole = iconv(converter, &from, &n_from, &to, &n_to) != static_cast<std::size_t>(-1) && n_from == 0;
    iconv_close(converter);
    if (!is_whole) return std::nullopt;
    text.resize(text.size() - n_to);
    return text;
}

}  // namespace

std::string to_utf8(std::string bytes, std::string_view code_page) {
    if (utf8::is_valid(bytes.begin(), bytes.end())) return bytes;
    if (std::optional<std::string> text = decoded(bytes, code_page)) return *std::move(text);
    return latin1_to_utf8(bytes);
}

std::string_view stated_code_page(std::string_view bytes) {
    const std::size_t header = bytes.find("$DWGCODEPAGE"), end = bytes.find("ENDSEC");
    if (header == std::string_view::npos || header > end) return {};
    const char* blanks = " \t\r\n";
    const auto next_word = [&](std::size_t from) {  // the words are lines of their own here
        const std::size_t begin = std::min(bytes.find_first_not_of(blanks, from), bytes.size());
        return bytes.substr(begin, std::min(bytes.find_first_of(blanks, begin), bytes.size()) - begin);
    };
    const std::string_view variable = next_word(header);
    const std::string_view code = next_word(header + variable.size());
    return next_word(static_cast<std::size_t>(code.data() - bytes.data()) + code.size());
}

}  // namespace abut::geometry::dxf
