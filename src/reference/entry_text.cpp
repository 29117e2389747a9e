// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "src/io/text_table.hpp"
#include "src/reference/reference_text.hpp"

namespace abut {

namespace {

constexpr std::size_t line_width = 96;

/// Lines of words, none longer than the width but for words that are; each begins with the indent.
std::string wrapped(const std::string& text, const std::string& indent) {
    std::string lines, line;
    const auto take = [&](const std::string& word) {
        if (!line.empty() && indent.size() + line.size() + 1 + word.size() > line_width) {
            lines += indent + line + "\n";
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
    };
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        take(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return line.empty() ? lines : lines + indent + line + "\n";
}

std::string indented(const std::string& text) {
    std::string lines = "  ";
    for (const char c : text) lines += c == '\n' ? std::string("\n  ") : std::string(1, c);
    return lines + "\n";
}

/// What stands in a list or under free names, where that is an object of its own.
const ReferenceEntry* item_of(const ReferencePage& page, const ReferenceEntry& entry) {
    for (const ReferenceEntry& e : page.entries)
        if (!e.is_key && e.parent == entry.path) return &e;
    return nullptr;
}

std::string keys_text(const ReferencePage& page, const ReferenceEntry& entry) {
    std::vector<TextRow> rows;
    for (const ReferenceEntry* key : keys_of(page, entry))
        rows.push_back(
            {"  " + key->path.substr(key->parent.empty() ? 0 : key->parent.size() + 1), first_sentence(key->meaning)});
    return rows.empty() ? "" : "\nkeys\n" + aligned(rows);
}

}  // namespace

std::string first_sentence(const std::string& meaning) {
    const std::size_t end = meaning.find(". ");
    return end == std::string::npos ? meaning : meaning.substr(0, end + 1);
}

std::string entry_text(const ReferencePage& page, const ReferenceEntry& entry) {
    std::vector<TextRow> facts{{"  type", entry.type}};
    if (!entry.unit.empty()) facts.push_back({"  unit", entry.unit});
    if (entry.required) facts.push_back({"  required"});
    if (!entry.standard.empty()) facts.push_back({"  default", entry.standard});
    std::string text = full_name(page, entry) + (entry.title.empty() ? "" : "  (" + entry.title + ")") + "\n" + aligned(facts) +
                       "\n" + wrapped(entry.meaning, "");
    const ReferenceEntry* item = item_of(page, entry);
    if (item && item->meaning != entry.meaning) text += "\n" + item->path + "\n" + wrapped(item->meaning, "");
    const std::string& own = entry.example.empty() && item ? item->example : entry.example;
    const std::string& example = own.empty() ? entry.example_around : own;
    if (!example.empty()) text += "\nexample\n" + indented(example);
    if (!entry.same_as.empty()) text += "\nIts keys are those of " + page.name + "." + entry.same_as + ".\n";
    return text + keys_text(page, entry);
}

}  // namespace abut
