// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/man_page.hpp"

#include "apps/commands.hpp"
#include "src/reference/reference_text.hpp"

namespace abut {

namespace {

std::string command_roff(const CommandSpec& spec) {
    std::string text = ".SS abut " + spec.name + " " + roff_escaped(spec.operand) + "\n" + roff_escaped(spec.summary) + "\n";
    for (const OptionSpec& option : spec.options)
        text += ".TP\n.B " + roff_escaped(option.name + (option.value.empty() ? "" : " " + option.value)) + "\n" +
                roff_escaped(option.help) + "\n";
    return spec.notes.empty() ? text : text + ".PP\n" + roff_escaped(spec.notes);
}

}  // namespace

std::string man_page(const std::vector<ReferencePage>& pages) {
    std::string text =
        ".TH ABUT 1\n.SH NAME\nabut \\- contact analysis of plane assemblies\n"
        ".SH SYNOPSIS\n.B abut\nCOMMAND FILE [OPTIONS]\n.SH COMMANDS\n";
    for (const Command& command : known_commands()) text += command_roff(command.spec);
    text += ".SH EXIT STATUS\n" + roff_escaped(exit_status_text());
    return text + reference_roff(pages);
}

}  // namespace abut
