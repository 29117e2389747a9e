// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/dxf/dxf_prepass.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "geometry/brep/input_error.hpp"

namespace abut::geometry::dxf {

namespace {

std::string load(const std::string& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) throw InputError(path, "is a folder, not a file", "name a DXF file");
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) throw InputError(path, "cannot be opened", "check the name and the folder");
    const std::streamoff size = file.tellg();
    std::string bytes(size > 0 ? static_cast<std::size_t>(size) : 0, '\0');
    file.seekg(0);
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!file) throw InputError(path, "cannot be read", "copy it again");
    return bytes;
}

bool is_mark(const Group& group, std::string_view mark) {
    return group.code == 0 && group.value == mark;
}

/// Walks over the groups and knows where it is.
class GroupReader {
public:
    explicit GroupReader(const Groups& groups) : groups_(groups) {}

    const Group& next() {
        if (next_ >= groups_.groups.size()) throw_truncated();
        return groups_.groups[next_++];
    }
    /// Index of the group that next() gives.
    std::size_t position() const { return next_; }
    std::span<const Group> between(std::size_t begin, std::size_t end) const {
        return std::span(groups_.groups).subspan(begin, end - begin);
    }
    std::string where(int place) const { return groups_.where(place); }
    /// "line 12" or "byte 345"
    std::string place_name(int place) const { return (groups_.is_binary ? "byte " : "line ") + std::to_string(place); }

    /// The section that is being read, for the message about a file that ends too early.
    void enter(const Group& name) {
        section_ = " within section " + std::string(name.value.substr(0, 40)) + " (begun at " + place_name(name.place) + ")";
    }
    void leave() { section_.clear(); }

private:
    [[noreturn]] void throw_truncated() const {
        throw InputError(groups_.where(groups_.last_line),
                         "the file ends" + section_ + " without its closing EOF: it is truncated", "export or copy it again");
    }

    const Groups& groups_;
    std::size_t next_ = 0;
    std::string section_;
};

struct Section {
    std::string name;
    std::span<const Group> before;  ///< what stands before the first code 0
    std::vector<Record> records;
};

[[noreturn]] void throw_unclosed(const GroupReader& reader, const Section& section, int begin, int place) {
    throw InputError(reader.where(place),
                     "section " + section.name + ", which begins at " + reader.place_name(begin) + ", has no ENDSEC",
                     "the file is damaged; export it again");
}

/// Reads up to ENDSEC; the reader stands behind the group "0 SECTION" at the given place.
Section read_section(GroupReader& reader, int place) {
    const Group& name = reader.next();
    if (name.code != 2)
        throw InputError(reader.where(name.place), "the name of the section is missing", "export the file again");
    reader.enter(name);
    Section section{upper_case(name.value), {}, {}};
    std::size_t begin = reader.position();
    const auto close_record = [&] {  // before the group just read
        const auto groups = reader.between(begin, reader.position() - 1);
        (section.records.empty() ? section.before : section.records.back().groups) = groups;
        begin = reader.position();
    };
    for (const Group* group = &reader.next(); !is_mark(*group, "ENDSEC"); group = &reader.next()) {
        if (group->code != 0) continue;
        const bool is_empty = section.records.empty() && reader.position() == begin + 1;
        if (is_empty && is_mark(*group, "SECTION")) return read_section(reader, group->place);  // begun twice
        if (is_mark(*group, "SECTION") || is_mark(*group, "EOF")) throw_unclosed(reader, section, place, group->place);
        close_record();
        section.records.push_back({upper_case(group->value), group->place, {}});
    }
    close_record();
    reader.leave();
    return section;
}

void take_header(Structure& structure, const Section& section) {
    std::string variable;
    for (const Group& group : section.before) {
        if (group.code == 9)
            variable = group.value;
        else
            structure.header.emplace(variable, group.value);
    }
}

void take_layers(Structure& structure, const Section& section) {
    for (const Record& record : section.records) {
        if (record.type == "LTYPE" && record.integer(73, 0) > 0) structure.interrupted.insert(upper_case(record.text(2)));
        if (record.type == "DIMSTYLE") structure.dimension_factors.emplace(upper_case(record.text(2)), record.number(144, 1));
        if (record.type != "LAYER") continue;
        Layer layer;
        const int color = record.integer(62, 7);
        layer.off = color < 0;
        if (color >= -255 && color <= 255 && color != 0) layer.color = std::abs(color);
        layer.frozen = (record.integer(70, 0) & 1) != 0;
        layer.linetype = record.text(6);
        structure.layers[upper_case(record.text(2))] = layer;
    }
}

/// A block runs from BLOCK to ENDBLK; the first of several with one name counts.
void take_blocks(Structure& structure, const std::vector<Record>& records) {
    constexpr int external = 4, overlay = 8;
    for (std::size_t i = 0; i < records.size(); ++i) {
        if (records[i].type != "BLOCK") continue;
        const std::size_t begin = i + 1;
        while (i + 1 < records.size() && records[i + 1].type != "ENDBLK" && records[i + 1].type != "BLOCK") ++i;
        const Record& head = records[begin - 1];
        const std::string name = head.text(2);
        const bool is_external = (head.integer(70, 0) & (external | overlay)) != 0;
        structure.blocks.emplace(upper_case(name),
                                 Block{head, name, std::span(records).subspan(begin, i + 1 - begin), is_external});
    }
}

void take_section(Structure& structure, Section section) {
    if (section.name == "HEADER") take_header(structure, section);
    if (section.name == "TABLES") take_layers(structure, section);
    if (section.name != "BLOCKS" && section.name != "ENTITIES") return;
    structure.sections.push_back(std::move(section.records));
    if (section.name == "BLOCKS")
        take_blocks(structure, structure.sections.back());
    else
        structure.entities.emplace_back(structure.sections.back());
}

/// Variables of the header that stand behind its end, and a second ENDSEC.
bool pass_over(Structure& structure, const Group& group, std::string& variable) {
    if (group.code == 9)
        variable = group.value;
    else if (group.code != 0 && !variable.empty())
        structure.header.emplace(variable, group.value);
    const bool is_harmless = group.code == 9 || (group.code != 0 && !variable.empty()) || is_mark(group, "ENDSEC");
    if (is_harmless && structure.warnings.empty())
        structure.warnings.push_back(
            {"'" + std::string(group.value.substr(0, 40)) + "' stands outside of any section and is passed over",
             {0, 0},
             {},
             group.place,
             "export the drawing again"});
    return is_harmless;
}

void read_sections(Structure& structure) {
    GroupReader reader(structure.groups);
    bool has_section = false;
    std::string variable;
    for (const Group* group = &reader.next(); !is_mark(*group, "EOF"); group = &reader.next()) {
        if (has_section && pass_over(structure, *group, variable)) continue;
        variable.clear();
        if (!is_mark(*group, "SECTION"))
            throw InputError(reader.where(group->place),
                             has_section ? "'" + std::string(group->value.substr(0, 40)) + "' stands outside of any section"
                                         : "the file does not begin with a section: it is no DXF file or only a piece of one",
                             "export the drawing again");
        take_section(structure, read_section(reader, group->place));
        has_section = true;
    }
    if (!has_section) throw InputError(structure.groups.file, "the file holds no section", "export the drawing again");
}

}  // namespace

const Group* Record::find(int code) const {
    const auto found = std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.code == code; });
    return found == groups.end() ? nullptr : &*found;
}

std::string Record::text(int code, const std::string& missing) const {
    const Group* group = find(code);
    return group ? unescaped(group->value) : missing;
}

int Record::integer(int code, int missing) const {
    const Group* group = find(code);
    return group ? parse_integer(group->value).value_or(missing) : missing;
}

double Record::number(int code, double missing) const {
    const Group* group = find(code);
    double value = missing;
    return group && parse_number(group->value, value) ? value : missing;
}

Structure structure_of(const std::string& file, std::string bytes) {
    Structure structure;
    structure.groups = split_groups(file, std::move(bytes));
    read_sections(structure);
    return structure;
}

Structure read_structure(const std::string& path) {
    return structure_of(path, load(path));
}

}  // namespace abut::geometry::dxf
