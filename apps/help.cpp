// SPDX-License-Identifier: GPL-3.0-or-later
// abut help: commands and keys explained; the pages that are made from the same text.
#include <algorithm>
#include <iterator>

#include "apps/commands.hpp"
#include "apps/data_folder.hpp"
#include "apps/man_page.hpp"
#include "apps/print_text.hpp"
#include "geometry/brep/input_error.hpp"
#include "src/io/nearest_name.hpp"
#include "src/io/text_table.hpp"
#include "src/reference/reference_search.hpp"
#include "src/reference/reference_text.hpp"

namespace abut {

namespace {

std::vector<std::string> command_names() {
    std::vector<std::string> names;
    for (const Command& command : known_commands()) names.push_back(command.spec.name);
    return names;
}

std::string candidates_text(const std::string& topic, const std::vector<FoundEntry>& found) {
    std::vector<TextRow> rows;
    for (const FoundEntry& f : found) rows.push_back({"  " + full_name(*f.page, *f.entry), first_sentence(f.entry->meaning)});
    return topic + " may be one of these keys:\n" + aligned(rows);
}

std::string key_text(const std::vector<ReferencePage>& pages, const std::string& topic) {
    const std::vector<FoundEntry> found = find_keys(pages, topic);
    if (found.empty())
        throw InputError("help", "there is no command and no key '" + shortened(topic) + "'",
                         nearest_key_hint(pages, topic, command_names()));
    return found.size() == 1 ? entry_text(*found[0].page, *found[0].entry) : candidates_text(topic, found);
}

/// Those of scenes begin with no word of their own: that is what people ask for most.
std::string key_names(const std::vector<ReferencePage>& pages) {
    std::string names;
    for (const ReferencePage& page : pages)
        for (const ReferenceEntry& entry : page.entries)
            if (entry.is_key && !entry.path.empty())
                names += plain_path((page.name == "scene" ? "" : page.name + ".") + entry.path) + "\n";
    return names;
}

/// A word that is a command is that first, and says where it is a key, too.
std::string topic_text(const std::vector<ReferencePage>& pages, const std::string& topic) {
    for (const Command& command : known_commands()) {
        if (command.spec.name != topic) continue;
        const std::vector<FoundEntry> found = find_keys(pages, topic);
        return command_help(command.spec) + (found.empty() ? "" : "\n" + candidates_text(topic, found));
    }
    return key_text(pages, topic);
}

}  // namespace

CommandSpec help_spec() {
    CommandSpec spec{
        "help",
        "TOPIC...",
        "Explains commands, and the keys of scenes and of the files that abut writes.",
        {{"--markdown", "", "print all keys as the pages of data/schema/README.md"},
         {"--man", "", "print the man page"},
         {"--keys", "", "print the names of all keys, for completion"}},
        "TOPIC is a command (analyze) or a key: loads.force, contacts.friction, result.contacts.profile.pressure,\n"
        "or its last word alone where there is only one (omega). Where that is to be said, keys begin with scene,\n"
        "result, contacts, expect, csv, study, batch, inspect or verify.\n"};
    spec.operands = Operands::any;
    return spec;
}

int help_command(const Arguments& arguments) {
    if (arguments.options.empty() && arguments.operands.empty()) {
        print_text(general_help());
        return exit_done;
    }
    const std::vector<ReferencePage> pages = read_reference(schema_folder());
    if (has(arguments, "--markdown")) print_text(reference_markdown(pages));
    if (has(arguments, "--man")) print_text(man_page(pages));
    if (has(arguments, "--keys")) print_text(key_names(pages));
    if (!arguments.options.empty()) return exit_done;
    std::vector<std::string> texts;
    for (const std::string& topic : arguments.operands) texts.push_back(topic_text(pages, topic));
    for (const std::string& text : texts) print_text((&text == &texts.front() ? "" : "\n") + text);
    return exit_done;
}

}  // namespace abut
