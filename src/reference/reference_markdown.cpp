// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/reference/reference_text.hpp"

namespace abut {

namespace {

/// In a cell of a table: what is between code marks is taken as it is, but for the bar.
std::string cell(const std::string& text, bool is_code) {
    std::string result;
    for (const char c : text) {
        const bool has_meaning = c == '|' || (!is_code && (c == '*' || c == '<' || c == '_'));
        result += (has_meaning ? "\\" : "") + std::string(1, c);
    }
    return is_code && !text.empty() ? "`" + result + "`" : result;
}

std::string row(const ReferenceEntry& e) {
    const std::string more = e.same_as.empty() ? "" : " Its keys are those of `" + e.same_as + "`.";
    return "| " + cell(e.path, true) + " | " + cell(e.type, false) + " | " + cell(e.unit, false) + " | " +
           (e.required ? "required" : cell(e.standard, true)) + " | " + cell(e.meaning, false) + more + " |\n";
}

/// A heading, the example and the keys of one object.
std::string section(const ReferencePage& page, const ReferenceEntry& entry) {
    std::string rows;
    for (const ReferenceEntry& e : page.entries)
        if (e.is_key && e.parent == entry.path && !e.path.empty()) rows += row(e);
    if (rows.empty()) return "";
    std::string text;
    if (!entry.path.empty()) {
        text += "### `" + entry.path + "`" + (entry.title.empty() ? "" : ": " + cell(entry.title, false)) + "\n\n";
        if (!entry.meaning.empty()) text += cell(entry.meaning, false) + "\n\n";
    }
    if (!entry.example.empty()) text += "```json\n" + entry.example + "\n```\n\n";
    return text + "| key | type | unit | default | meaning |\n| --- | --- | --- | --- | --- |\n" + rows + "\n";
}

}  // namespace

std::string reference_markdown(const std::vector<ReferencePage>& pages) {
    std::string text =
        "# The reference: every key of the files that abut reads and writes\n\n"
        "Made from the schemas beside it by `abut help --markdown > data/schema/README.md`: change those, not this. `abut help "
        "KEY` "
        "prints an entry of it (`abut help loads.force`), `man abut` has it where abut is installed.\n\n"
        "`[]` stands for each item of a list, `*` for a name that is free. Units are those of the scene; unit 1 is that of "
        "ratios.\n\n";
    for (const ReferencePage& page : pages)
        text +=
            "- " + cell(page.title, false) + ": `" + page.name + ".schema.json`, keys `" + page.name + ".*` of `abut help`\n";
    for (const ReferencePage& page : pages) {
        text += "\n## " + cell(page.title, false) + "\n\n" + cell(page.entries.front().meaning, false) + "\n\n";
        for (const ReferenceEntry& entry : page.entries) text += section(page, entry);
        text.pop_back();
    }
    return text;
}

}  // namespace abut
