// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of the files that abut reads and writes, out of their JSON schemas (data/schema/). There is no other text about
// them.
#pragma once
#include <string>
#include <vector>

namespace abut {

/// A key, or (is_key false) an object that is an item of a list or of an object with free names.
struct ReferenceEntry {
    std::string path;            ///< "loads[].force", "materials.*.E"; empty: the file itself
    std::string parent;          ///< the path of the object that has it as a key, of the list that has it as an item
    std::string title;           ///< what it is called, where that is not its path: "contact_<k>.csv"
    std::string type;            ///< in words: "number or expression"
    std::string meaning;         ///< whole sentences, without the unit
    std::string unit;            ///< "force per length^2", "1" of ratios; empty: it has none
    std::string standard;        ///< the default as it would be written; empty: there is none
    std::string example;         ///< as it would be written, in lines; empty: there is none
    std::string example_around;  ///< of a key without an example: one of the object that has it, or of what it may be
    std::string same_as;         ///< the path of an entry that has the same keys, which are listed there alone; may be empty
    bool required = false;
    bool is_key = true;
};

/// The keys of one schema. The first entry is the file itself, each object stands before its keys.
struct ReferencePage {
    std::string name;   ///< "scene": keys are scene.loads[].force
    std::string title;  ///< "result.json"
    std::vector<ReferenceEntry> entries;
};

/// Names of the schemas in the order in which the reference has them; NAME.schema.json in data/schema/.
const std::vector<std::string>& reference_names();

/// Throws InputError where the text is no JSON object.
ReferencePage reference_page(const std::string& name, const std::string& schema);

/// All of them, out of the folder. Throws InputError where one cannot be read.
std::vector<ReferencePage> read_reference(const std::string& folder);

/// "scene.loads[].force"; of a whole file its title
std::string full_name(const ReferencePage& page, const ReferenceEntry& entry);

/// The entries below an object, a list of objects or an object of objects: its keys.
std::vector<const ReferenceEntry*> keys_of(const ReferencePage& page, const ReferenceEntry& entry);

}  // namespace abut
