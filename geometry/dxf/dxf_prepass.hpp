// SPDX-License-Identifier: GPL-3.0-or-later
// The structure of a DXF file: its sections, header, layers, blocks and entity records, with the line each stands in.
#pragma once
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "geometry/dxf/dxf_groups.hpp"
#include "geometry/sketch/sketch.hpp"

namespace abut::geometry::dxf {

/// What stands between two groups of code 0: "LINE", "VERTEX", "LAYER", ...
struct Record {
    std::string type;  ///< upper case
    int line = 0;      ///< of the type; in binary files the byte offset
    std::span<const Group> groups;

    /// First group with the code, or null.
    const Group* find(int code) const;
    /// First value with the code as a name: characters escaped as \U+ are resolved.
    std::string text(int code, const std::string& missing = {}) const;
    int integer(int code, int missing) const;
    /// First value with the code where that is one finite number, else `missing`.
    double number(int code, double missing) const;
};

/// A layer's look, for the entities on it.
struct Layer {
    bool off = false, frozen = false;
    std::string linetype;
    int color = 7;
};

/// A block: entities that INSERT records place.
struct Block {
    Record head;  ///< holds the base point (10, 20)
    std::string name;
    std::span<const Record> entities;
    bool is_external = false;  ///< its entities are in another file
};

/// A DXF file taken apart into records; it can be moved and not copied, since records point into it.
struct Structure {
    Groups groups;                                    ///< what the records point to
    std::map<std::string, std::string> header;        ///< first value of each variable: "$INSUNITS" -> "4"
    std::map<std::string, Layer> layers;              ///< by upper-case name: layer names are compared without regard to case
    std::set<std::string> interrupted;                ///< upper-case names of line types that have gaps
    std::map<std::string, double> dimension_factors;  ///< DIMLFAC by upper-case name of the dimension style
    std::map<std::string, Block> blocks;              ///< by upper-case name
    std::vector<std::vector<Record>> sections;        ///< the records of BLOCKS and ENTITIES, in the file's order
    std::vector<std::span<const Record>> entities;    ///< of each section ENTITIES
    std::vector<SketchProblem> warnings;              ///< what is out of place in the file

    Structure() = default;
    Structure(Structure&&) = default;
    Structure& operator=(Structure&&) = default;
};

/// Reads the structure of a DXF file. Variables behind the header's end, a section's beginning that is written twice, and a
/// second ENDSEC are read as they are meant, with a warning. Throws InputError (file, line) if the file is missing, empty,
/// truncated or no DXF. Cost: see split_groups().
Structure read_structure(const std::string& path);
/// Reads the structure from a file's bytes; `file` is its name in messages.
Structure structure_of(const std::string& file, std::string bytes);

}  // namespace abut::geometry::dxf
