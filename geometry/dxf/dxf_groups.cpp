// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/dxf/dxf_groups.hpp"

#include <utf8.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>

#include "geometry/brep/input_error.hpp"
#include "geometry/dxf/dxf_binary.hpp"
#include "geometry/dxf/dxf_encoding.hpp"

namespace abut::geometry::dxf {

namespace {

constexpr const char* save_as_dxf = "save it as DXF";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
/// Lines and bytes are counted in an int.
constexpr std::size_t largest_file = std::numeric_limits<int>::max();

void refuse_other_formats(const std::string& file, std::string_view bytes) {
    if (bytes.empty()) throw InputError(file, "the file is empty", "export the drawing again");
    if (bytes.size() > largest_file) throw InputError(file, "the file is larger than 2 GB", "divide the drawing");
    if (is_binary_dxf(bytes)) return;
    if (bytes.starts_with("AutoCAD Binary DXF"))
        throw InputError(file, "the beginning of this binary DXF file is damaged", "copy it again, as a binary file");
    if (bytes.starts_with("AC10")) throw InputError(file, "this is a DWG drawing, not a DXF file", save_as_dxf);
    if (bytes.find('\0') != std::string_view::npos)
        throw InputError(file, "this is a binary file, not a DXF file", save_as_dxf);
}

std::string_view trimmed(std::string_view text) {
    const char* blanks = " \t";
    const auto begin = text.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/// Hands out the lines one by one.
class Lines {
public:
    explicit Lines(std::string_view text) : text_(text) {}

    bool at_end() const { return at_ >= text_.size(); }
    int n_read() const { return n_read_; }

    std::string_view next() {
        const char* begin = text_.data() + at_;
        const char* last = text_.data() + text_.size();
        const char* end = begin;
        while (end != last && *end != '\n' && *end != '\r') ++end;
        const bool is_crlf = last - end > 1 && end[0] == '\r' && end[1] == '\n';
        at_ = static_cast<std::size_t>(end - text_.data()) + (is_crlf ? 2 : 1);
        ++n_read_;
        return trimmed({begin, static_cast<std::size_t>(end - begin)});
    }

private:
    std::string_view text_;
    std::size_t at_ = 0;
    int n_read_ = 0;
};

[[noreturn]] void throw_no_code(const Groups& groups, int line, std::string_view found) {
    if (line == 1)
        throw InputError(groups.where(line), "the first line is no group code: this is no DXF file", "save it as ASCII DXF");
    throw InputError(groups.where(line), "a group code is expected here, not '" + std::string(found.substr(0, 40)) + "'",
                     "the file is damaged; export it again");
}

/// A last code without a value is left out: the file is truncated then.
void split_lines(Groups& groups) {
    Lines lines(*groups.text);
    bool is_end = false;
    while (!is_end && !lines.at_end()) {
        const std::string_view first = lines.next();
        if (lines.at_end()) break;
        const std::optional<int> code = parse_integer(first);
        if (!code) throw_no_code(groups, lines.n_read(), first);
        const std::string_view value = lines.next();
        if (*code != 999) groups.groups.push_back({*code, lines.n_read(), value});
        is_end = *code == 0 && value == "EOF";
    }
    groups.last_line = lines.n_read();
}

}  // namespace

std::string Groups::where(int place) const {
    return file + (is_binary ? ", byte " : ":") + std::to_string(place);
}

Groups split_groups(const std::string& file, std::string bytes) {
    refuse_other_formats(file, bytes);
    if (is_binary_dxf(bytes)) return split_binary_groups(file, bytes);
    if (bytes.starts_with(byte_order_mark)) bytes.erase(0, byte_order_mark.size());
    Groups groups;
    groups.file = file;
    const std::string code_page(stated_code_page(bytes));
    groups.text = std::make_shared<const std::string>(to_utf8(std::move(bytes), code_page));
    split_lines(groups);
    return groups;
}

bool parse_number(std::string_view value, double& number) {
    if (value.find(',') != std::string_view::npos) {
        std::string text(value);
        std::replace(text.begin(), text.end(), ',', '.');
        return parse_number(text, number);
    }
    if (value.starts_with('+')) value.remove_prefix(1);
    const char* end = value.data() + value.size();
    const auto [ptr, error] = std::from_chars(value.data(), end, number);
    return !value.empty() && error == std::errc() && ptr == end && std::isfinite(number);
}

std::optional<int> parse_integer(std::string_view value) {
    int number = 0;
    const char* end = value.data() + value.size();
    const auto [ptr, error] = std::from_chars(value.data(), end, number);
    if (value.empty() || error != std::errc() || ptr != end) return std::nullopt;
    return number;
}

std::string unescaped(std::string_view value) {
    std::string text;
    for (std::size_t i = 0; i < value.size();) {
        unsigned code = 0;
        const std::string_view digits = value.substr(std::min(i + 3, value.size()), 4);
        const bool is_escape = value.compare(i, 3, "\\U+") == 0 && digits.size() == 4 &&
                               std::from_chars(digits.data(), digits.data() + 4, code, 16).ptr == digits.data() + 4;
        if (is_escape && code != 0 && (code < 0xD800 || code > 0xDFFF)) {
            utf8::append(code, std::back_inserter(text));
            i += 7;
        } else {
            text += value[i++];
        }
    }
    return text;
}

std::string upper_case(std::string_view text) {
    std::string upper(text);
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return upper;
}

}  // namespace abut::geometry::dxf
