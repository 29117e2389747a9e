// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/dxf_prepass.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "geometry/input_error.hpp"

namespace abut::geometry::dxf {

namespace {

constexpr const char* save_as_ascii = "save it as ASCII DXF";

std::string place(const std::string& path, int line) {
    return path + ":" + std::to_string(line);
}

bool starts_with(const std::string& text, const char* beginning) {
    return text.rfind(beginning, 0) == 0;
}

std::string load(const std::string& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) throw InputError(path, "is a folder, not a file", "name a DXF file");
    std::ifstream file(path, std::ios::binary);
    if (!file) throw InputError(path, "cannot be opened", "check the name and the folder");
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (bytes.empty()) throw InputError(path, "the file is empty", "export the drawing again");
    return bytes;
}

void refuse_binary(const std::string& path, const std::string& bytes) {
    if (starts_with(bytes, "AutoCAD Binary DXF")) throw InputError(path, "binary DXF is not read yet", save_as_ascii);
    if (starts_with(bytes, "AC10")) throw InputError(path, "this is a DWG drawing, not a DXF file", save_as_ascii);
    if (bytes.find('\0') != std::string::npos) throw InputError(path, "this is a binary file, not a DXF file", save_as_ascii);
}

bool is_continuation(unsigned char byte) {
    return (byte & 0xC0) == 0x80;
}

/// Bytes that the UTF-8 lead byte asks for, 0 where it is no lead byte.
std::size_t sequence_length(unsigned char lead) {
    if (lead < 0x80) return 1;
    if (lead >= 0xC2 && lead < 0xE0) return 2;
    if (lead >= 0xE0 && lead < 0xF0) return 3;
    if (lead >= 0xF0 && lead < 0xF5) return 4;
    return 0;
}

/// Overlong three- and four-byte forms, surrogates and values beyond U+10FFFF, all seen in the second byte.
bool is_forbidden_pair(unsigned char lead, unsigned char second) {
    return (lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F) || (lead == 0xF0 && second < 0x90) ||
           (lead == 0xF4 && second > 0x8F);
}

bool is_utf8(const std::string& bytes) {
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    for (std::size_t i = 0; i < bytes.size();) {
        const std::size_t n = sequence_length(at(i));
        if (n == 0 || i + n > bytes.size()) return false;
        if (n > 1 && is_forbidden_pair(at(i), at(i + 1))) return false;
        for (std::size_t k = 1; k < n; ++k)
            if (!is_continuation(at(i + k))) return false;
        i += n;
    }
    return true;
}

void append_utf8(std::string& text, unsigned code) {
    const auto add = [&](unsigned byte) { text += static_cast<char>(byte); };
    if (code < 0x80) {
        add(code);
    } else if (code < 0x800) {
        add(0xC0 | (code >> 6));
        add(0x80 | (code & 0x3F));
    } else {
        add(0xE0 | (code >> 12));
        add(0x80 | ((code >> 6) & 0x3F));
        add(0x80 | (code & 0x3F));
    }
}

std::string latin1_to_utf8(const std::string& bytes) {
    std::string text;
    for (char c : bytes) append_utf8(text, static_cast<unsigned char>(c));
    return text;
}

std::string trimmed(const std::string& text) {
    const char* blanks = " \t";
    const auto begin = text.find_first_not_of(blanks);
    if (begin == std::string::npos) return {};
    return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/// Files before R2007 write characters beyond their code page as \U+00E4.
std::string unescaped(const std::string& value) {
    std::string text;
    for (std::size_t i = 0; i < value.size();) {
        unsigned code = 0;
        const char* digits = value.data() + i + 3;
        if (value.compare(i, 3, "\\U+") == 0 && i + 7 <= value.size() &&
            std::from_chars(digits, digits + 4, code, 16).ptr == digits + 4 && code != 0 && (code < 0xD800 || code > 0xDFFF)) {
            append_utf8(text, code);
            i += 7;
        } else {
            text += value[i++];
        }
    }
    return text;
}

std::vector<std::string> split_lines(const std::string& text) {
    std::vector<std::string> lines;
    std::size_t begin = 0;
    while (begin < text.size()) {
        const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
        lines.push_back(trimmed(text.substr(begin, end - begin)));
        const bool is_crlf = end + 1 < text.size() && text[end] == '\r' && text[end + 1] == '\n';
        begin = end + (is_crlf ? 2 : 1);
    }
    return lines;
}

std::optional<int> parse_integer(const std::string& text) {
    int value = 0;
    const char* end = text.data() + text.size();
    const auto [ptr, error] = std::from_chars(text.data(), end, value);
    if (text.empty() || error != std::errc() || ptr != end) return std::nullopt;
    return value;
}

/// Hands out the groups one by one and knows where it is; comments (code 999) are passed over.
class GroupReader {
public:
    GroupReader(std::string path, const std::string& text) : path_(std::move(path)), lines_(split_lines(text)) {}

    Group next() {
        Group group = take();
        while (group.code == 999) group = take();
        return group;
    }

    std::string where(int line) const { return place(path_, line); }

    /// The section that is being read, for the message about a file that ends too early.
    void enter(const Group& name) {
        section_ = " within section " + name.value + " (begun at line " + std::to_string(name.line) + ")";
    }
    void leave() { section_.clear(); }

private:
    Group take() {
        if (next_ + 1 >= lines_.size()) throw_truncated();
        const int line = static_cast<int>(next_) + 1;
        const auto code = parse_integer(lines_[next_]);
        if (!code) throw_no_code(line);
        Group group{*code, unescaped(lines_[next_ + 1]), line + 1};
        next_ += 2;
        return group;
    }

    [[noreturn]] void throw_truncated() const {
        throw InputError(where(static_cast<int>(lines_.size())),
                         "the file ends" + section_ + " without its closing EOF: it is truncated", "export or copy it again");
    }

    [[noreturn]] void throw_no_code(int line) const {
        if (line == 1) throw InputError(where(line), "the first line is no group code: this is no DXF file", save_as_ascii);
        throw InputError(where(line), "a group code is expected here, not '" + lines_[next_].substr(0, 40) + "'",
                         "the file is damaged; export it again");
    }

    std::string path_;
    std::vector<std::string> lines_;
    std::size_t next_ = 0;
    std::string section_;
};

struct Section {
    std::string name;
    std::vector<Record> records;  ///< the first one holds what stands before the first code 0 and has no type
};

/// Reads up to ENDSEC; the reader stands behind the group "0 SECTION" at the given line.
Section read_section(GroupReader& reader, int line) {
    const Group name = reader.next();
    if (name.code != 2)
        throw InputError(reader.where(name.line), "the name of the section is missing", "export the file again");
    reader.enter(name);
    Section section{upper_case(name.value), {Record{}}};
    for (Group group = reader.next(); !(group.code == 0 && group.value == "ENDSEC"); group = reader.next()) {
        const bool is_outside = group.code == 0 && (group.value == "SECTION" || group.value == "EOF");
        if (is_outside)
            throw InputError(reader.where(group.line),
                             "section " + section.name + ", which begins at line " + std::to_string(line) + ", has no ENDSEC",
                             "the file is damaged; export it again");
        if (group.code == 0)
            section.records.push_back({upper_case(group.value), group.line, {}});
        else
            section.records.back().groups.push_back(std::move(group));
    }
    reader.leave();
    return section;
}

std::map<std::string, std::string> header_of(const Section& section) {
    std::map<std::string, std::string> header;
    std::string variable;
    for (const Group& group : section.records.front().groups) {
        if (group.code == 9)
            variable = group.value;
        else
            header.emplace(variable, group.value);
    }
    return header;
}

std::map<std::string, Layer> layers_of(const Section& section) {
    std::map<std::string, Layer> layers;
    for (const Record& record : section.records) {
        if (record.type != "LAYER") continue;
        Layer layer;
        layer.off = record.integer(62, 7) < 0;
        layer.frozen = (record.integer(70, 0) & 1) != 0;
        layer.linetype = record.text(6);
        layers[upper_case(record.text(2))] = layer;
    }
    return layers;
}

void take_section(Structure& structure, Section section) {
    if (section.name == "HEADER") structure.header = header_of(section);
    if (section.name == "TABLES") structure.layers = layers_of(section);
    if (section.name == "ENTITIES")
        structure.entities.insert(structure.entities.end(), std::make_move_iterator(section.records.begin() + 1),
                                  std::make_move_iterator(section.records.end()));
}

Structure read_groups(const std::string& path, const std::string& text) {
    GroupReader reader(path, text);
    Structure structure;
    bool has_section = false;
    for (Group group = reader.next(); !(group.code == 0 && group.value == "EOF"); group = reader.next()) {
        if (group.code != 0 || group.value != "SECTION")
            throw InputError(reader.where(group.line),
                             has_section ? "'" + group.value.substr(0, 40) + "' stands outside of any section"
                                         : "the file does not begin with a section: it is no DXF file or only a piece of one",
                             "export the drawing again");
        take_section(structure, read_section(reader, group.line));
        has_section = true;
    }
    if (!has_section) throw InputError(path, "the file holds no section", "export the drawing again");
    return structure;
}

}  // namespace

const Group* Record::find(int code) const {
    const auto found = std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.code == code; });
    return found == groups.end() ? nullptr : &*found;
}

std::string Record::text(int code, const std::string& missing) const {
    const Group* group = find(code);
    return group ? group->value : missing;
}

int Record::integer(int code, int missing) const {
    const Group* group = find(code);
    return group ? parse_integer(group->value).value_or(missing) : missing;
}

bool parse_number(const std::string& value, double& number) {
    std::string text = value;
    std::replace(text.begin(), text.end(), ',', '.');
    if (starts_with(text, "+")) text.erase(0, 1);
    const char* end = text.data() + text.size();
    const auto [ptr, error] = std::from_chars(text.data(), end, number);
    return !text.empty() && error == std::errc() && ptr == end && std::isfinite(number);
}

std::string upper_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return text;
}

Structure read_structure(const std::string& path) {
    std::string bytes = load(path);
    refuse_binary(path, bytes);
    if (starts_with(bytes, "\xEF\xBB\xBF")) bytes.erase(0, 3);
    return read_groups(path, is_utf8(bytes) ? bytes : latin1_to_utf8(bytes));
}

}  // namespace abut::geometry::dxf
