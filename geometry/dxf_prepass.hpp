// SPDX-License-Identifier: GPL-3.0-or-later
// The structure of an ASCII DXF file: its group codes, sections, layers and entity records, with the line each stands in.
// dxflib reads binary files as empty and truncated ones as complete, and knows no line numbers: hence this pass before it.
#pragma once
#include <map>
#include <string>
#include <vector>

namespace abut::geometry::dxf {

struct Group {
    int code;
    std::string value;  ///< UTF-8, without blanks at either end
    int line;           ///< of the value, counted from 1
};

/// What stands between two groups of code 0: "LINE", "VERTEX", "LAYER", ...
struct Record {
    std::string type;
    int line = 0;  ///< of the type
    std::vector<Group> groups;

    /// First group with the code, or null.
    const Group* find(int code) const;
    std::string text(int code, const std::string& missing = {}) const;
    int integer(int code, int missing) const;
};

struct Layer {
    bool off = false, frozen = false;
    std::string linetype;
};

struct Structure {
    std::map<std::string, std::string> header;  ///< first value of each variable: "$INSUNITS" -> "4"
    std::map<std::string, Layer> layers;        ///< by upper-case name: layer names are compared without regard to case
    std::vector<Record> entities;               ///< of the section ENTITIES, in the file's order
};

/// Reads the file's structure. CR LF, LF and CR line ends, blank-padded codes and a byte order mark are accepted; text that is
/// not UTF-8 is taken as Latin-1. Throws InputError (file, line) if the file is missing, empty, binary, truncated or no DXF.
Structure read_structure(const std::string& path);

/// The number that a value stands for; a decimal comma counts as a point. False unless all of it is one finite number.
bool parse_number(const std::string& value, double& number);

std::string upper_case(std::string text);

}  // namespace abut::geometry::dxf
