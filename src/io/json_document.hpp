// SPDX-License-Identifier: GPL-3.0-or-later
// JSON text to a tree that remembers where everything stands. RFC 8259 plus comments (// and /* */).
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "geometry/brep/input_error.hpp"

namespace abut {

/// A value of a JSON text, with its place.
struct JsonValue {
    enum class Kind { null, boolean, number, string, array, object };
    Kind kind = Kind::null;
    std::string key;      ///< inside an object
    std::string pointer;  ///< JSON pointer (RFC 6901), "" for the root
    int line = 1;         ///< counted from 1: of the key inside an object, of the value elsewhere
    bool boolean = false;
    double number = 0;             ///< finite
    std::string text;              ///< of a string; valid UTF-8
    std::vector<JsonValue> items;  ///< of an array or an object, in file order
};

/// A JSON text as a tree.
struct JsonDocument {
    std::string file;
    JsonValue root;
    std::vector<Problem> problems;  ///< duplicate keys (the first of them is in the tree)
};

/// Reads JSON from a text. Throws InputError ("file:line:column", what was expected and what was found) at the first fault of
/// syntax. Numbers beyond the range of doubles and nesting deeper than 100 are such faults.
JsonDocument parse_json(const std::string& text, const std::string& file);

/// Reads JSON from a file. Throws InputError at the first fault of syntax, and where the file is missing, unreadable or a
/// folder.
JsonDocument read_json(const std::string& path);

/// The member with this key, or nullptr (also where the value is no object).
const JsonValue* find_member(const JsonValue& value, std::string_view key);

/// The value that a JSON pointer stands for, or nullptr.
const JsonValue* find_pointer(const JsonValue& root, const std::string& pointer);

/// A value in words for messages: "a list", "a number", "the text 'abc'", ...
std::string described(const JsonValue& value);

/// The place of a value for messages: "file:line /pointer".
std::string place_of(const std::string& file, const JsonValue& value);

}  // namespace abut
