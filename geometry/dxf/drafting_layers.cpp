// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/dxf/drafting_layers.hpp"

#include <utf8.h>

#include <iterator>
#include <map>
#include <set>
#include <sstream>

namespace abut::geometry::dxf {

namespace {

/// Upper case of the alphabets of the table: Latin with its accents, Cyrillic.
char32_t upper(char32_t c) {
    if ((c >= U'a' && c <= U'z') || (c >= 0xE0 && c <= 0xFE && c != 0xF7) || (c >= 0x430 && c <= 0x44F)) return c - 32;
    if (c >= 0x450 && c <= 0x45F) return c - 80;
    const bool is_odd_capital = (c >= 0x139 && c <= 0x148) || (c >= 0x179 && c <= 0x17E);
    if (c >= 0x100 && c <= 0x17E && (c % 2 == 1) != is_odd_capital) return c - 1;
    return c;
}

bool is_between_words(char32_t c) {
    return c == ' ' || c == '_' || c == '-' || c == '.' || c == '(' || c == ')' || c == '/' || c == '\'' || c == 0x3000;
}

/// "Mittellinien (ISO)" as MITTELLINIEN, ISO.
std::vector<std::string> words_of(std::string_view name) {
    std::vector<std::string> words{""};
    std::string valid;
    utf8::replace_invalid(name.begin(), name.end(), std::back_inserter(valid));
    for (auto at = valid.begin(); at != valid.end();) {
        const char32_t c = utf8::next(at, valid.end());
        if (!is_between_words(c))
            utf8::append(upper(c), std::back_inserter(words.back()));
        else if (!words.back().empty())
            words.emplace_back();
    }
    if (words.back().empty()) words.pop_back();
    return words;
}

std::string joined(const std::vector<std::string>& words) {
    std::string all;
    for (const std::string& word : words) all += word;
    return all;
}

struct Table {
    std::map<std::string, DraftingLayer> kinds;
    std::set<std::string> affixes;
};

Table read_table() {
    Table table;
    std::istringstream rows(drafting_layers_text());
    std::string row;
    std::getline(rows, row);  // the heading
    while (std::getline(rows, row)) {
        std::istringstream cells(row);
        std::string kind, certainty, name;
        std::getline(cells, kind, ',');
        std::getline(cells, certainty, ',');
        std::getline(cells, name, ',');
        const std::string plain = joined(words_of(name));
        if (kind == "affix")
            table.affixes.insert(plain);
        else
            table.kinds.emplace(plain, DraftingLayer{kind, certainty == "sure"});
    }
    return table;
}

bool is_number(const std::string& word) {
    return word.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace

std::optional<DraftingLayer> drafting_layer(std::string_view name) {
    static const Table table = read_table();
    std::vector<std::string> words = words_of(name.substr(name.rfind('|') + 1));  // npos + 1 is 0
    auto found = table.kinds.find(joined(words));
    if (found != table.kinds.end()) return found->second;
    std::erase_if(words, [&](const std::string& word) { return is_number(word) || table.affixes.contains(word); });
    found = table.kinds.find(joined(words));
    return found == table.kinds.end() ? std::nullopt : std::optional(found->second);
}

bool says_holes(std::string_view name) {
    const std::optional<DraftingLayer> layer = drafting_layer(name);
    return layer && (layer->kind == "holes" || layer->kind == "thread lines");
}

}  // namespace abut::geometry::dxf
