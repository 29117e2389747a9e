// SPDX-License-Identifier: GPL-3.0-or-later
// A parser of our own, because messages need the line of every key and because duplicate keys must not get lost; the usual
// libraries give positions for faults of syntax only.
#include "src/io/json_document.hpp"

#include <utf8.h>

#include <cctype>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <utility>

#include "src/io/nearest_name.hpp"
#include "src/io/utf8.hpp"

namespace abut {

namespace {

constexpr int depth_limit = 100;

std::string escaped_key(const std::string& key) {
    std::string text;
    for (const char c : key) text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return text;
}

class JsonParser {
public:
    JsonParser(const std::string& text, JsonDocument& document) : text_(text), document_(document) {}

    void parse() {
        if (text_.compare(0, 3, "\xEF\xBB\xBF") == 0) at_ = line_start_ = 3;
        skip_blanks();
        value(document_.root, "", 0);
        skip_blanks();
        if (at_ < text_.size()) fail("expected the end of the file" + found(), "");
    }

private:
    void value(JsonValue& result, std::string pointer, int depth) {
        if (depth > depth_limit) fail("lists and objects are nested too deeply", "");
        result.pointer = std::move(pointer);
        if (result.key.empty()) result.line = line_;
        const char c = peek();
        if (c == '{') return object(result, depth);
        if (c == '[') return array(result, depth);
        if (c == '"') {
            result.kind = JsonValue::Kind::string;
            result.text = string();
        } else if (c == '-' || (c >= '0' && c <= '9')) {
            result.kind = JsonValue::Kind::number;
            result.number = number();
        } else {
            word(result);
        }
    }

    void object(JsonValue& result, int depth) {
        result.kind = JsonValue::Kind::object;
        std::set<std::string> keys;
        ++at_;
        skip_blanks();
        if (take('}')) return;
        for (;;) {
            member(result, keys, depth);
            skip_blanks();
            if (take('}')) return;
            if (!take(',')) fail("expected ',' or '}' after a value" + found(), "");
            skip_blanks();
            if (peek() == '}') fail("expected a key in double quotes, found '}'", "remove the comma before it");
        }
    }

    void member(JsonValue& object, std::set<std::string>& keys, int depth) {
        if (peek() != '"') fail("expected a key in double quotes" + found(), "");
        JsonValue item;
        item.line = line_;
        item.key = string();
        skip_blanks();
        if (!take(':')) fail("expected ':' after the key \"" + shortened(item.key) + "\"" + found(), "");
        skip_blanks();
        const int line = item.line;
        value(item, object.pointer + "/" + escaped_key(item.key), depth + 1);
        item.line = line;
        if (keys.insert(item.key).second) {
            object.items.push_back(std::move(item));
        } else {
            document_.problems.push_back(
                {place_of(document_.file, item), "the key '" + item.key + "' is given twice", "keep one of them"});
        }
    }

    void array(JsonValue& result, int depth) {
        result.kind = JsonValue::Kind::array;
        ++at_;
        skip_blanks();
        if (take(']')) return;
        for (;;) {
            result.items.emplace_back();
            value(result.items.back(), result.pointer + "/" + std::to_string(result.items.size() - 1), depth + 1);
            skip_blanks();
            if (take(']')) return;
            if (!take(',')) fail("expected ',' or ']' after a value" + found(), "");
            skip_blanks();
            if (peek() == ']') fail("expected a value, found ']'", "remove the comma before it");
        }
    }

    void word(JsonValue& result) {
        std::size_t end = at_;
        while (end < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[end])) || text_[end] == '_')) ++end;
        const std::string name = text_.substr(at_, end - at_);
        if (name == "true" || name == "false") {
            result.kind = JsonValue::Kind::boolean;
            result.boolean = name == "true";
        } else if (name != "null") {
            if (name.empty()) fail("expected a value" + found(), "");
            fail("expected a value, found '" + shortened(name) + "'",
                 "numbers, \"texts\", true, false, null, [lists] and {objects} are values");
        }
        at_ = end;
    }

    double number() {
        const std::size_t begin = at_;
        take('-');
        if (!take('0')) digits("a digit");
        if (take('.')) digits("a digit after the decimal point");
        if (take('e') || take('E')) {
            if (!take('+')) take('-');
            digits("a digit of the exponent");
        }
        double result = 0;
        const auto [end, error] = std::from_chars(text_.data() + begin, text_.data() + at_, result);
        if (error != std::errc() || end != text_.data() + at_) {
            at_ = begin;
            fail("this number is too large or too small to be represented", "");
        }
        return result;
    }

    void digits(const std::string& expected) {
        const std::size_t begin = at_;
        while (peek() >= '0' && peek() <= '9') ++at_;
        if (at_ == begin) fail("expected " + expected + found(), "");
    }

    std::string string() {
        const std::size_t begin = at_++;
        std::string result;
        while (peek() != '"') {
            const auto c = static_cast<unsigned char>(peek());
            if (at_ >= text_.size() || c == '\n' || c == '\r') {
                at_ = begin;
                fail("this text has no closing double quote on its line", "");
            }
            if (c < 0x20) fail("a control character inside a text", "write it as \\u00XX");
            if (c == '\\') {
                escape(result);
                continue;
            }
            const std::size_t n = utf8_length(text_, at_);
            if (n == 0) fail("this is not UTF-8 text", "save the file as UTF-8");
            result.append(text_, at_, n);
            at_ += n;
        }
        ++at_;
        return result;
    }

    void escape(std::string& result) {
        static constexpr std::string_view letters = "\"\\/bfnrt", meanings = "\"\\/\b\f\n\r\t";
        ++at_;
        const std::size_t i = at_ < text_.size() ? letters.find(text_[at_]) : std::string_view::npos;
        if (i != std::string_view::npos) {
            result += meanings[i];
            ++at_;
        } else if (peek() == 'u') {
            utf8::append(unicode_escape(), std::back_inserter(result));
        } else {
            fail("expected one of \" \\ / b f n r t u after a backslash" + found(), "a backslash itself is written \\\\");
        }
    }

    unsigned unicode_escape() {
        const unsigned first = hexadecimal();
        if (first < 0xD800 || first > 0xDFFF) return first;
        const bool pair = first < 0xDC00 && text_.compare(at_, 2, "\\u") == 0;
        if (pair) ++at_;
        const unsigned second = pair ? hexadecimal() : 0;
        if (second < 0xDC00 || second > 0xDFFF) fail("half of a surrogate pair in a \\u escape", "write the character itself");
        return 0x10000 + ((first - 0xD800) << 10) + (second - 0xDC00);
    }

    unsigned hexadecimal() {
        ++at_;
        unsigned code = 0;
        const char* begin = text_.data() + at_;
        if (text_.size() - at_ < 4) fail("expected four hexadecimal digits after \\u", "");
        const auto [end, error] = std::from_chars(begin, begin + 4, code, 16);
        if (error != std::errc() || end != begin + 4) fail("expected four hexadecimal digits after \\u", "");
        at_ += 4;
        return code;
    }

    void skip_blanks() {
        for (;;) {
            const char c = peek();
            if (c == '\n')
                new_line();
            else if (c == ' ' || c == '\t' || c == '\r')
                ++at_;
            else if (text_.compare(at_, 2, "//") == 0)
                skip_line();
            else if (text_.compare(at_, 2, "/*") == 0)
                skip_comment();
            else
                return;
        }
    }

    void skip_line() {
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
    }

    void skip_comment() {
        const std::size_t end = text_.find("*/", at_ + 2);
        if (end == std::string::npos) fail("this comment has no end", "close it with */");
        while (at_ < end) {
            if (text_[at_] == '\n')
                new_line();
            else
                ++at_;
        }
        at_ = end + 2;
    }

    void new_line() {
        ++line_;
        line_start_ = ++at_;
    }

    /// The next character; 0 at the end of the text (a 0 inside the text is no valid character anywhere, so the two may be
    /// mixed up).
    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

    bool take(char c) {
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }

    std::string found() const {
        if (at_ >= text_.size()) return ", but the file ends";
        const auto c = static_cast<unsigned char>(text_[at_]);
        if (c == '\n' || c == '\r') return ", but the line ends";
        const std::size_t n = utf8_length(text_, at_);
        if (c < 0x20 || n == 0) return ", found a character that is no text";
        return ", found '" + text_.substr(at_, n) + "'";
    }

    [[noreturn]] void fail(const std::string& what, const std::string& hint) const {
        throw InputError(document_.file + ":" + std::to_string(line_) + ":" + std::to_string(at_ - line_start_ + 1), what,
                         hint);
    }

    const std::string& text_;
    JsonDocument& document_;
    std::size_t at_ = 0, line_start_ = 0;
    int line_ = 1;
};

}  // namespace

JsonDocument parse_json(const std::string& text, const std::string& file) {
    JsonDocument document;
    document.file = file;
    JsonParser(text, document).parse();
    return document;
}

JsonDocument read_json(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) throw InputError(path, "there is no such file", "check the name and the folder");
    if (std::filesystem::is_directory(path, error))
        throw InputError(path, "this is a folder, not a file", "name the scene file in it");
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream) throw InputError(path, "the file cannot be read", "check its permissions and that it is not empty");
    return parse_json(text.str(), path);
}

const JsonValue* find_member(const JsonValue& value, std::string_view key) {
    if (value.kind != JsonValue::Kind::object) return nullptr;
    for (const JsonValue& item : value.items) {
        if (item.key == key) return &item;
    }
    return nullptr;
}

const JsonValue* find_pointer(const JsonValue& root, const std::string& pointer) {
    const JsonValue* value = &root;
    while (value && value->pointer != pointer) {
        const JsonValue* next = nullptr;
        for (const JsonValue& item : value->items) {
            if (pointer == item.pointer || pointer.compare(0, item.pointer.size() + 1, item.pointer + "/") == 0) next = &item;
        }
        value = next;
    }
    return value;
}

std::string described(const JsonValue& value) {
    switch (value.kind) {
        case JsonValue::Kind::null:
            return "null";
        case JsonValue::Kind::boolean:
            return value.boolean ? "true" : "false";
        case JsonValue::Kind::number:
            return "a number";
        case JsonValue::Kind::string:
            return "the text '" + shortened(value.text) + "'";
        case JsonValue::Kind::array:
            return "a list of " + std::to_string(value.items.size());
        case JsonValue::Kind::object:
            return "an object";
    }
    return "";
}

std::string place_of(const std::string& file, const JsonValue& value) {
    return file + ":" + std::to_string(value.line) + (value.pointer.empty() ? "" : " " + value.pointer);
}

}  // namespace abut
