// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/mesh_ply.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

#include "geometry/brep/input_error.hpp"

namespace abut::geometry {

namespace {

/// `what` shows names out of the file: without their control characters.
[[noreturn]] void refuse(const std::string& path, std::string what) {
    std::erase_if(what, [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; });
    throw InputError(path, "the PLY file is " + what, "export it again");
}

// ---- header ----

struct Property {
    std::size_t size = 0;        ///< bytes of a value
    std::size_t count_size = 0;  ///< bytes of the number of values; 0: no list
    bool is_index = false;       ///< whole numbers named as the vertices of a face
};
struct Element {
    std::string name;
    std::uintmax_t n = 0;
    std::vector<Property> properties;
};
struct Header {
    enum class Form { text, little_endian, big_endian };
    Form form = Form::text;
    std::vector<Element> elements;
};

/// Bytes of a value; 0: there is no such type.
std::size_t size_of(const std::string& type) {
    static const std::map<std::string, std::size_t> sizes = {
        {"char", 1}, {"uchar", 1}, {"int8", 1},  {"uint8", 1},  {"short", 2}, {"ushort", 2},  {"int16", 2},  {"uint16", 2},
        {"int", 4},  {"uint", 4},  {"int32", 4}, {"uint32", 4}, {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
    const auto found = sizes.find(type);
    return found == sizes.end() ? 0 : found->second;
}

bool is_whole(const std::string& type) {
    return type.find("int") != std::string::npos || type.find("char") != std::string::npos ||
           type.find("short") != std::string::npos;
}

/// The rest of "property list uchar int vertex_indices", or of "property float x". Sizes of 0: something is wrong.
Property property_of(std::istringstream& words) {
    Property property;
    std::string type, name;
    words >> type;
    if (type == "list") {
        std::string count_type;
        words >> count_type >> type;
        property.count_size = is_whole(count_type) ? size_of(count_type) : 0;
        if (property.count_size == 0) return {};
    }
    words >> name;
    property.size = size_of(type);
    property.is_index = property.count_size > 0 && is_whole(type) && (name == "vertex_indices" || name == "vertex_index");
    return property;
}

Header header_of(std::istream& in, const std::string& path, std::uintmax_t size) {
    Header header;
    std::string line;
    std::getline(in, line);
    if (line.rfind("ply", 0) != 0 && line.rfind("PLY", 0) != 0)
        throw InputError(path, "the file is no PLY, or damaged", "export it again");
    while (std::getline(in, line)) {
        std::istringstream words(line);
        std::string word, form;
        words >> word;
        if (word == "end_header") return header;
        if (word == "format") {
            words >> form;
            header.form = form == "binary_little_endian" ? Header::Form::little_endian
                          : form == "binary_big_endian"  ? Header::Form::big_endian
                                                         : Header::Form::text;
        }
        if (word == "element") {
            Element element;
            if (!(words >> element.name >> element.n) || element.n > size)
                refuse(path, "damaged: an element is stated without a number");
            header.elements.push_back(element);
        }
        if (word == "property") {
            const Property property = property_of(words);
            if (header.elements.empty() || property.size == 0) refuse(path, "damaged: a property is of no known type");
            header.elements.back().properties.push_back(property);
        }
    }
    refuse(path, "damaged: its header does not end");
}

// ---- what follows ----

bool is_end_of_line(char c) {
    return c == '\n' || c == '\r';
}

bool is_blank(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

/// The next line that holds anything, which is taken off; empty at the end.
std::string_view next_line(std::string_view& text) {
    const auto begin = std::find_if_not(text.begin(), text.end(), is_blank);
    const auto end = std::find_if(begin, text.end(), is_end_of_line);
    const std::string_view line(begin, end);
    text.remove_prefix(static_cast<std::size_t>(end - text.begin()));
    return line;
}

/// The number that the line begins with, which is taken off; nothing where it begins otherwise.
std::optional<double> next_number(std::string_view& line) {
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t' || line.front() == '+')) line.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), value);
    const bool is_whole_word = end == line.data() + line.size() || is_blank(*end);
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    if (error == std::errc::result_out_of_range && is_whole_word) return 0;  // assimp reads 1e-400 so
    return error == std::errc() && is_whole_word ? std::optional(value) : std::nullopt;
}

void check_line(std::string_view line, const Element& element, std::uintmax_t n_vertices, bool is_last,
                const std::string& path) {
    const auto next = [&] {
        const std::optional<double> value = next_number(line);
        if (!value)
            refuse(path, std::string(is_last ? "truncated" : "damaged") + ": a line of element '" + element.name +
                             "' holds too few numbers, or none");
        return *value;
    };
    for (const Property& property : element.properties) {
        const double n = property.count_size > 0 ? next() : 1;
        for (double k = 0; k < n; ++k) {
            const double value = next();
            if (property.is_index && !(value >= 0 && value < static_cast<double>(n_vertices)))
                refuse(path, "damaged: a face names a vertex that is not there");
        }
    }
}

void check_text(std::string_view text, const Header& header, std::uintmax_t n_vertices, const std::string& path) {
    for (const Element& element : header.elements)
        for (std::uintmax_t k = 0; k < element.n; ++k) {
            const std::string_view line = next_line(text);
            if (line.empty()) refuse(path, "truncated: it states " + std::to_string(element.n) + " of '" + element.name + "'");
            const bool is_last = std::all_of(text.begin(), text.end(), is_blank);
            check_line(line, element, n_vertices, is_last, path);
        }
}

/// Walks through the values of a binary file.
class Body {
public:
    Body(const std::string& bytes, bool is_big, const std::string& path) : bytes_(bytes), is_big_(is_big), path_(path) {}

    void pass(const Element& element, std::uintmax_t n_vertices) {
        for (std::uintmax_t k = 0; k < element.n; ++k)
            for (const Property& property : element.properties) pass(property, n_vertices);
    }

private:
    void pass(const Property& property, std::uintmax_t n_vertices) {
        std::uintmax_t n = property.count_size > 0 ? value(property.count_size) : 1;
        if (!property.is_index) return skip(n, property.size);
        for (; n > 0; --n)
            if (value(property.size) >= n_vertices) refuse(path_, "damaged: a face names a vertex that is not there");
    }
    void skip(std::uintmax_t n, std::size_t size) {
        if (n > (bytes_.size() - at_) / size) refuse(path_, "truncated: it ends before all its elements");
        at_ += static_cast<std::size_t>(n) * size;
    }
    std::uintmax_t value(std::size_t size) {
        const std::size_t from = at_;
        skip(1, size);
        std::uintmax_t sum = 0;
        for (std::size_t k = 0; k < size; ++k)
            sum = 256 * sum + static_cast<unsigned char>(bytes_[is_big_ ? from + k : from + size - 1 - k]);
        return sum;
    }

    const std::string& bytes_;
    bool is_big_;
    const std::string& path_;
    std::size_t at_ = 0;
};

}  // namespace

void check_ply(const std::string& path, std::uintmax_t size) {
    std::ifstream in(path, std::ios::binary);
    const Header header = header_of(in, path, size);
    const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    std::uintmax_t n_vertices = 0;
    for (const Element& element : header.elements)
        if (element.name == "vertex") n_vertices = element.n;
    if (header.form == Header::Form::text) return check_text(bytes, header, n_vertices, path);
    Body body(bytes, header.form == Header::Form::big_endian, path);
    for (const Element& element : header.elements) body.pass(element, n_vertices);
}

}  // namespace abut::geometry
