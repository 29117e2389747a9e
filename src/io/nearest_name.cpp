// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/nearest_name.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace abut {

namespace {

constexpr std::size_t listed_names = 20;
constexpr std::size_t quoted_characters = 40;
constexpr std::size_t longest_compared = 100;  // the table of distances must stay small for absurd words
constexpr double least_resemblance = 0.7;      // edits per character, from which on two words have nothing in common

double replacement_cost(char a, char b) {
    if (a == b) return 0;
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    return lower(a) == lower(b) ? 0.5 : 1;
}

}  // namespace

double edit_distance(const std::string& a, const std::string& b) {
    // Three rows of the table of distances between the beginnings of a and b.
    std::vector<double> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<double>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before.swap(last);
        last.swap(row);
        row[0] = static_cast<double>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + replacement_cost(a[i - 1], b[j - 1])});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
        }
    }
    return row[b.size()];
}

std::string nearest_name(const std::string& word, const std::vector<std::string>& known) {
    const std::string beginning = word.substr(0, longest_compared);
    std::string nearest;
    double smallest = 0;
    for (const std::string& name : known) {
        const double distance = edit_distance(beginning, name);
        if (!nearest.empty() && distance >= smallest) continue;
        nearest = name;
        smallest = distance;
    }
    return nearest;
}

std::string nearest_name_hint(const std::string& word, const std::vector<std::string>& known) {
    if (known.empty()) return "";
    const std::string list = "known here: " + listed(known);
    const auto is_part_of_word = [](const std::string& name, std::size_t place) {
        return place < name.size() && std::isalnum(static_cast<unsigned char>(name[place])) != 0;
    };
    const auto has_word = [&](const std::string& name) {
        const std::size_t place = word.empty() ? std::string::npos : name.find(word);
        return place != std::string::npos && !is_part_of_word(name, place + word.size()) &&
               (place == 0 || !is_part_of_word(name, place - 1));
    };
    const auto longer = std::find_if(known.begin(), known.end(), has_word);
    if (longer != known.end() && std::none_of(longer + 1, known.end(), has_word))
        return "did you mean '" + *longer + "'? " + list;
    const std::string nearest = nearest_name(word, known);
    const double alike = edit_distance(word.substr(0, longest_compared), nearest);
    if (alike > least_resemblance * static_cast<double>(std::max(word.size(), nearest.size()))) return list;
    return "did you mean '" + nearest + "'? " + list;
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), listed_names); ++i) text += (i ? ", " : "") + names[i];
    if (names.size() > listed_names) text += " and " + std::to_string(names.size() - listed_names) + " more";
    return text;
}

std::string shortened(const std::string& text) {
    if (text.size() <= quoted_characters) return text;
    std::size_t end = quoted_characters;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
    return text.substr(0, end) + "...";
}

}  // namespace abut
