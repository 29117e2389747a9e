// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/src/io/xml_fault.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cctype>
#include <string_view>
#include <vector>

namespace abut_tests {

namespace {

std::string_view name_at(std::string_view text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '-' || text[end] == ':'))
        ++end;
    return text.substr(at, end - at);
}

bool is_entity(std::string_view text) {
    for (const char* name : {"amp", "lt", "gt", "quot", "apos"})
        if (text.rfind(std::string("&") + name + ";", 0) == 0) return true;
    const std::size_t end = text.find_first_not_of("0123456789", 2);
    return text.substr(0, 2) == "&#" && end != std::string_view::npos && end > 2 && text[end] == ';';
}

/// Are these attributes and nothing else: ` name="value"` any number of times?
bool are_attributes(std::string_view text) {
    while (!text.empty()) {
        if (text.front() != ' ') return false;
        const std::string_view name = name_at(text, 1);
        text.remove_prefix(1 + name.size());
        const std::size_t end = text.find('"', 2);
        if (name.empty() || text.substr(0, 2) != "=\"" || end == std::string_view::npos) return false;
        text.remove_prefix(end + 1);
    }
    return true;
}

}  // namespace

std::string fault_of_xml(const std::string& text) {
    std::vector<std::string> open;
    const std::string_view all = text;
    for (std::size_t at = all.find_first_of("<&"); at != std::string_view::npos; at = all.find_first_of("<&", at + 1)) {
        if (all[at] == '&') {
            if (!is_entity(all.substr(at))) return "stray & at " + text.substr(at, 8);
            continue;
        }
        const std::size_t end = all.find('>', at);
        if (end == std::string_view::npos) return "unclosed tag";
        std::string_view inner = all.substr(at + 1, end - at - 1);
        if (inner.find('<') != std::string_view::npos) return "stray < in a tag";
        const bool closes = !inner.empty() && inner.front() == '/', is_empty = !inner.empty() && inner.back() == '/';
        if (closes) inner.remove_prefix(1);
        if (is_empty && !inner.empty()) inner.remove_suffix(1);
        const std::string_view name = name_at(inner, 0);
        if (name.empty() || (closes && is_empty) || !are_attributes(inner.substr(name.size())))
            return "no tag: " + text.substr(at, end + 1 - at);
        if (closes) {
            if (open.empty() || open.back() != name) return "closes nothing: " + std::string(name);
            open.pop_back();
        } else if (!is_empty) {
            open.emplace_back(name);
        }
    }
    return open.empty() ? "" : "never closed: " + open.back();
}

TEST(XmlFault, FindsWhatDoesNotMatch) {
    EXPECT_EQ(fault_of_xml("<a b=\"1\"><c-d e:f=\"g h\"/>1 &amp; &#39;2</a>"), "");
    for (const char* text : {"<a>", "</a>", "<a></b>", "<a b></a>", "<a b=\"1></a>", "<a>&</a>", "<a>&#;</a>", "<a", "<a><</a>",
                             "<>", "<a b=\"1\"c=\"2\"/>"})
        EXPECT_NE(fault_of_xml(text), "") << text;
}

}  // namespace abut_tests
