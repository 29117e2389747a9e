// SPDX-License-Identifier: GPL-3.0-or-later
// The groups of a DXF file, ASCII or binary: a code and a value each, and where they stand.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abut::geometry::dxf {

/// A group: a code and its value.
struct Group {
    int code;
    int place;               ///< of the value: line, counted from 1; in binary files the byte offset of the group, from 0
    std::string_view value;  ///< UTF-8, without blanks at either end; points into Groups::text
};

/// All groups of a file in its order, without comments (code 999).
struct Groups {
    std::shared_ptr<const std::string> text;  ///< keeps what the values point to
    std::vector<Group> groups;
    bool is_binary = false;
    std::string file;   ///< as messages name it
    int last_line = 0;  ///< of an ASCII file; the size in bytes of a binary one

    /// "a.dxf:12", or "a.dxf, byte 345" in a binary file.
    std::string where(int place) const;
};

/// Splits the bytes of a file into groups, up to and including the first "0 EOF"; at the end of the bytes if there is none:
/// what is missing then is for the reader of sections to say. CR LF, LF and CR line ends, blank-padded codes and a byte order
/// mark are accepted; text that is not UTF-8 is of the code page that the header states, or else Latin-1. Throws InputError
/// (file, line or byte) where a group code is expected and none stands there. Cost: a pass over the bytes, 24 bytes of memory
/// for each group.
Groups split_groups(const std::string& file, std::string bytes);

/// The number that a value stands for; a decimal comma counts as a point. False unless all of it is one finite number.
bool parse_number(std::string_view value, double& number);
std::optional<int> parse_integer(std::string_view value);
/// A name as the user knows it: files before R2007 write characters beyond their code page as \U+00E4.
std::string unescaped(std::string_view value);
std::string upper_case(std::string_view text);

}  // namespace abut::geometry::dxf
