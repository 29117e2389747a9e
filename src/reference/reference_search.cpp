// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/reference/reference_search.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "src/io/nearest_name.hpp"

namespace abut {

namespace {

using Path = std::vector<std::string>;

/// "contacts.json.pairs[].gap" as contacts, pairs, gap.
Path split_path(const std::string& text) {
    Path path;
    std::string segment;
    const auto end_segment = [&] {
        if (!segment.empty() && segment != "json" && segment != "csv") path.push_back(segment);
        segment.clear();
    };
    for (const char c : text) {
        if (c == '.') end_segment();
        if (c != '.' && c != '[' && c != ']') segment += c;
    }
    end_segment();
    if (path.empty() && !text.empty()) path = {text};
    return path;
}

/// "*" stands for any name.
bool is_path(const Path& words, const Path& path) {
    const auto are_same = [](const std::string& word, const std::string& segment) { return word == segment || segment == "*"; };
    return words.size() == path.size() && std::equal(words.begin(), words.end(), path.begin(), are_same);
}

bool is_end(const Path& words, const Path& path) {
    return words.size() <= path.size() && std::equal(words.rbegin(), words.rend(), path.rbegin());
}

bool is_within(const Path& words, const Path& path) {
    std::size_t found = 0;
    for (const std::string& segment : path)
        if (found < words.size() && words[found] == segment) ++found;
    return found == words.size() && words.back() == path.back();
}

Path without_free_names(Path path) {
    std::erase(path, "*");
    return path;
}

/// How well words mean an entry: 0 by its whole path, 1 by the end (a single word always), 2 by some words; nothing where they
/// do not.
std::optional<std::size_t> rank_of(const Path& words, const std::string& page, const ReferenceEntry& entry) {
    std::optional<std::size_t> best;
    const auto take = [&](std::size_t rank) { best = std::min(best.value_or(rank), rank); };
    const Path full = split_path(entry.path);
    const bool is_free = full.empty() || full.back() == "*";  // then only the whole path means it
    for (const Path& path : {full, is_free ? full : without_free_names(full)}) {
        Path whole = path;
        whole.insert(whole.begin(), page);
        if (is_path(words, path) || is_path(words, whole)) take(words.size() == 1 ? 1 : 0);
        if (!is_free && is_end(words, whole)) take(1);
        if (!is_free && is_within(words, whole)) take(2);
    }
    return best;
}

/// Words for a place whose keys are listed elsewhere, led there: "loads.on.near" to "supports.on.near".
std::vector<Path> led_elsewhere(const std::vector<ReferencePage>& pages, const Path& words) {
    std::vector<Path> others;
    for (const ReferencePage& page : pages)
        for (const ReferenceEntry& entry : page.entries) {
            if (entry.same_as.empty()) continue;
            const Path path = split_path(entry.path);
            const std::size_t skipped = !words.empty() && words[0] == page.name ? 1 : 0;
            if (words.size() - skipped <= path.size()) continue;
            const auto begin = words.begin() + static_cast<std::ptrdiff_t>(skipped);
            if (!std::equal(path.begin(), path.end(), begin)) continue;
            Path other = split_path(entry.same_as);
            other.insert(other.begin(), page.name);
            other.insert(other.end(), begin + static_cast<std::ptrdiff_t>(path.size()), words.end());
            others.push_back(std::move(other));
        }
    return others;
}

std::vector<FoundEntry> best_of(const std::vector<ReferencePage>& pages, const Path& words) {
    std::array<std::vector<FoundEntry>, 3> found;
    if (words.empty()) return {};
    for (const ReferencePage& page : pages)
        for (const ReferenceEntry& entry : page.entries)
            if (const auto rank = entry.is_key ? rank_of(words, page.name, entry) : std::nullopt)
                found[*rank].push_back({&page, &entry});
    for (std::vector<FoundEntry>& entries : found)
        if (!entries.empty()) return std::move(entries);
    return {};
}

}  // namespace

std::vector<FoundEntry> find_keys(const std::vector<ReferencePage>& pages, const std::string& words) {
    for (const ReferencePage& page : pages)
        if (page.title == words) return {{&page, &page.entries.front()}};
    const Path path = split_path(words);
    std::vector<FoundEntry> found = best_of(pages, path);
    constexpr int deepest = 4;  // of shapes in shapes, which could go on
    std::vector<Path> others{path};
    for (int depth = 0; found.empty() && depth < deepest && !others.empty(); ++depth) {
        others = led_elsewhere(pages, others.front());
        for (const Path& other : others)
            if (found.empty()) found = best_of(pages, other);
    }
    return found;
}

std::string plain_path(const std::string& path) {
    std::string plain;
    for (const std::string& segment : without_free_names(split_path(path))) plain += (plain.empty() ? "" : ".") + segment;
    return plain;
}

std::string nearest_key_hint(const std::vector<ReferencePage>& pages, const std::string& words,
                             const std::vector<std::string>& other_names) {
    std::vector<std::string> known = other_names;
    for (const ReferencePage& page : pages)
        for (const ReferenceEntry& entry : page.entries) {
            const std::string path = plain_path(entry.path);
            if (path.empty()) continue;
            known.push_back(path.substr(path.rfind('.') + 1));
            known.push_back(path);
        }
    return "did you mean '" + nearest_name(words, known) + "'? data/schema/README.md lists all keys";
}

}  // namespace abut
