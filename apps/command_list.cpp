// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/commands.hpp"

namespace abut {

std::vector<Command> known_commands() {
    return {{analyze_spec(), analyze_command}, {live_spec(), live_command},         {report_spec(), report_command},
            {compare_spec(), compare_command}, {contacts_spec(), contacts_command}, {inspect_spec(), inspect_command},
            {init_spec(), init_command},       {study_spec(), study_command},       {verify_spec(), verify_command},
            {batch_spec(), batch_command},     {merge_spec(), merge_command},       {sweep_spec(), sweep_command},
            {help_spec(), help_command}};
}

std::string exit_status_text() {
    return "0 done; 1 the analysis failed, or a comparison differs; 2 the input or the usage is wrong.\n";
}

std::string general_help() {
    std::string text = "usage: abut COMMAND FILE [OPTIONS]\n\nContact analysis of plane assemblies.\n\ncommands:\n";
    for (const Command& command : known_commands())
        text += "  " + command.spec.name + std::string(10 - command.spec.name.size(), ' ') + command.spec.summary + "\n";
    return text +
           "\nabut COMMAND --help shows a command's options; abut help KEY what a key of a scene or a result means;\n"
           "abut --version the version.\nExit status: " +
           exit_status_text();
}

}  // namespace abut
