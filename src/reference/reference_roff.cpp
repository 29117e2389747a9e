// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>

#include "src/reference/reference_text.hpp"

namespace abut {

namespace {

std::string capitals(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

std::string entry_roff(const ReferenceEntry& e) {
    std::string facts = e.type + (e.unit.empty() ? "" : "; unit: " + e.unit);
    if (e.required) facts += "; required";
    if (!e.standard.empty()) facts += "; default: " + e.standard;
    std::string text = ".TP\n.B " + roff_escaped(e.path) + "\n(" + roff_escaped(facts) + ")\n" + roff_escaped(e.meaning) + "\n";
    if (!e.same_as.empty()) text += "Its keys are those of " + roff_escaped(e.same_as) + ".\n";
    if (!e.example.empty()) text += ".IP\n.nf\n" + roff_escaped(e.example) + "\n.fi\n";
    return text;
}

}  // namespace

std::string roff_escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        const bool at_begin = result.empty() || result.back() == '\n';
        if (at_begin && (c == '.' || c == '\'')) result += "\\&";
        if (c == '\\')
            result += "\\e";
        else if (c == '-' || c == '^')
            result += c == '-' ? "\\-" : "\\(ha";
        else if (c == '\'')
            result += "\\(aq";
        else
            result += c;
    }
    return result;
}

std::string reference_roff(const std::vector<ReferencePage>& pages) {
    std::string text;
    for (const ReferencePage& page : pages) {
        text +=
            ".SH " + roff_escaped(capitals("keys of " + page.title)) + "\n" + roff_escaped(page.entries.front().meaning) + "\n";
        for (const ReferenceEntry& entry : page.entries)
            if (!entry.path.empty()) text += entry_roff(entry);
    }
    return text;
}

}  // namespace abut
