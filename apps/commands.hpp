// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of `abut`. Each takes its words after the command's name and gives the exit status.
#pragma once
#include <string>
#include <vector>

#include "apps/arguments.hpp"

namespace abut {

/// The meaning of the exit status, for all commands.
enum ExitStatus : int {
    exit_done = 0,
    exit_failed = 1,       ///< the analysis failed (--strict: or has reservations), a comparison differs, or the program
                           ///< itself gave up (memory, a bug)
    exit_wrong_input = 2,  ///< the input or the usage is wrong
};

/// The commands. All throw InputError for wrong usage and wrong input.
int analyze_command(const Arguments& arguments);
int contacts_command(const Arguments& arguments);
int inspect_command(const Arguments& arguments);
int init_command(const Arguments& arguments);
int live_command(const Arguments& arguments);
int report_command(const Arguments& arguments);
int compare_command(const Arguments& arguments);
int study_command(const Arguments& arguments);
int verify_command(const Arguments& arguments);
int batch_command(const Arguments& arguments);
int sweep_command(const Arguments& arguments);
int merge_command(const Arguments& arguments);
int help_command(const Arguments& arguments);

/// The words that each command accepts, for parsing and for its help.
CommandSpec analyze_spec();
CommandSpec contacts_spec();
CommandSpec inspect_spec();
CommandSpec init_spec();
CommandSpec live_spec();
CommandSpec report_spec();
CommandSpec compare_spec();
CommandSpec study_spec();
CommandSpec verify_spec();
CommandSpec batch_spec();
CommandSpec sweep_spec();
CommandSpec merge_spec();
CommandSpec help_spec();

struct Command {
    CommandSpec spec;
    int (*run)(const Arguments&);
};
/// All commands, in the order in which the help lists them.
std::vector<Command> known_commands();

/// The text of `abut --help`.
std::string general_help();
/// The meaning of the exit status in a line.
std::string exit_status_text();

}  // namespace abut
