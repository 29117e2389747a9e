// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/mesh_collada.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "geometry/brep/input_error.hpp"

namespace abut::geometry {

namespace {

using std::string_view;

/// What assimp looks for without looking whether it is there.
const std::map<string_view, std::vector<string_view>> required = {{"geometry", {"id"}},
                                                                  {"source", {"id"}},
                                                                  {"float_array", {"id", "count"}},
                                                                  {"accessor", {"source", "count"}},
                                                                  {"vertices", {"id"}},
                                                                  {"input", {"semantic", "source"}},
                                                                  {"triangles", {"count"}},
                                                                  {"polylist", {"count"}},
                                                                  {"polygons", {"count"}},
                                                                  {"tristrips", {"count"}},
                                                                  {"trifans", {"count"}},
                                                                  {"lines", {"count"}},
                                                                  {"linestrips", {"count"}},
                                                                  {"visual_scene", {"id"}},
                                                                  {"instance_geometry", {"url"}},
                                                                  {"instance_node", {"url"}},
                                                                  {"instance_visual_scene", {"url"}}};
const std::vector<string_view> whole_numbers = {"p", "vcount"};
/// With how many of them at least; 0: as many as the element's attribute "count" says.
const std::map<string_view, std::size_t> real_numbers = {{"float_array", 0}, {"matrix", 16}, {"lookat", 9},
                                                         {"translate", 3},   {"scale", 3},   {"rotate", 4}};
/// Attributes that are whole numbers, and set sizes.
const std::vector<string_view> counts = {"count", "stride", "offset", "set"};

struct Tag {
    string_view name;
    std::map<string_view, string_view> attributes;
    bool is_empty = false;  ///< <a/>
};

bool is_space(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

template <class List>
bool is_one_of(const List& list, string_view word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

template <class Number>
std::optional<Number> number_of(string_view text) {
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// The next word of the text, which is taken off.
string_view next_word(string_view& text) {
    const auto begin = std::find_if_not(text.begin(), text.end(), is_space);
    const auto end = std::find_if(begin, text.end(), is_space);
    const string_view word(begin, end);
    text.remove_prefix(static_cast<std::size_t>(end - text.begin()));
    return word;
}

/// Of what stands between < and >.
Tag tag_of(string_view text) {
    Tag tag;
    if (!text.empty() && text.back() == '/') {
        tag.is_empty = true;
        text.remove_suffix(1);
    }
    tag.name = next_word(text);
    for (std::size_t equals = text.find('='); equals != string_view::npos; equals = text.find('=')) {
        string_view before = text.substr(0, equals);
        const string_view name = next_word(before);
        const std::size_t open = text.find_first_of("\"'", equals);
        const std::size_t close = open == string_view::npos ? open : text.find(text[open], open + 1);
        if (close == string_view::npos) break;
        tag.attributes[name] = text.substr(open + 1, close - open - 1);
        text.remove_prefix(close + 1);
    }
    return tag;
}

class Check {
public:
    Check(const std::string& path, string_view text, std::uintmax_t size) : path_(path), text_(text), size_(size) {}

    void run() {
        for (std::size_t open = text_.find('<'); open != string_view::npos; open = text_.find('<', open + 1)) {
            if (text_.substr(open, 4) == "<!--") {
                open = std::min(text_.find("-->", open), text_.size() - 1);
                continue;
            }
            const std::size_t close = text_.find('>', open);
            if (close == string_view::npos) refuse("an element does not end");
            const Tag tag = tag_of(text_.substr(open + 1, close - open - 1));
            check(tag);
            if (!tag.is_empty) check_content(tag, text_.substr(close + 1, text_.find('<', close + 1) - close - 1));
            open = close;
        }
    }

private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw InputError(path_, "the COLLADA file is damaged: " + what, "export it again");
    }

    void check(const Tag& tag) const {
        const std::string name(tag.name);
        if (const auto needed = required.find(tag.name); needed != required.end())
            for (string_view attribute : needed->second)
                if (!tag.attributes.count(attribute))
                    refuse("an element '" + name + "' without '" + std::string(attribute) + "'");
        for (const auto& [attribute, value] : tag.attributes) {
            if (!is_one_of(counts, attribute)) continue;
            const auto n = number_of<std::uint64_t>(value);
            if (!n || *n > size_)
                refuse("'" + std::string(attribute) + "' of an element '" + name + "' is no number, or absurd");
        }
    }

    void check_content(const Tag& tag, string_view content) const {
        if (is_one_of(whole_numbers, tag.name)) return count<std::uint32_t>(tag, content, 0);
        const auto real = real_numbers.find(tag.name);
        if (real == real_numbers.end()) return;
        const auto stated = tag.attributes.find("count");
        const std::size_t least = real->second > 0 || stated == tag.attributes.end()
                                      ? real->second
                                      : static_cast<std::size_t>(number_of<std::uint64_t>(stated->second).value_or(0));
        count<double>(tag, content, least);
    }

    template <class Number>
    void count(const Tag& tag, string_view content, std::size_t least) const {
        std::size_t n = 0;
        for (string_view word = next_word(content); !word.empty(); word = next_word(content), ++n)
            if (!number_of<Number>(word)) refuse("the numbers of an element '" + std::string(tag.name) + "' are none");
        if (n < least) refuse("an element '" + std::string(tag.name) + "' holds fewer numbers than stated");
    }

    const std::string& path_;
    string_view text_;
    std::uintmax_t size_;
};

}  // namespace

void check_collada(const std::string& path, std::uintmax_t size) {
    std::ifstream in(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    Check(path, text, size).run();
}

}  // namespace abut::geometry
