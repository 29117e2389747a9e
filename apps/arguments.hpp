// SPDX-License-Identifier: GPL-3.0-or-later
// The words of a command line, checked against what a command accepts.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace abut {

struct OptionSpec {
    std::string name;   ///< as written: "--json", "-o"
    std::string value;  ///< what the value is called in the help, "DIR"; empty: the option takes none
    std::string help;   ///< one line
};

enum class Operands { one, any };  ///< exactly one is required; any number of them, none included

struct CommandSpec {
    std::string name;     ///< "analyze"
    std::string operand;  ///< what it is called in the help: "SCENE"
    std::string summary;  ///< one line
    std::vector<OptionSpec> options;
    std::string notes;  ///< paragraphs for the end of the help, may be empty
    Operands operands = Operands::one;
};

struct Arguments {
    std::string operand;                         ///< the first
    std::map<std::string, std::string> options;  ///< by name, those given; the value is empty where the option takes none
    bool help = false;                           ///< --help or -h was given: nothing else has been checked
    std::vector<std::string> operands{};         ///< all
};

/// `--name value`, `--name=value`, `-o value`, options and operand in any order; everything after `--` is an operand. A value
/// may begin with a minus sign but not be the name of an option. Throws InputError with all that is wrong: unknown options
/// (with the nearest known one), repeated options, missing or superfluous values and operands.
Arguments parse_arguments(const CommandSpec& spec, const std::vector<std::string>& words);

bool has(const Arguments& arguments, const std::string& name);
/// The option's value, or the default where it was not given.
std::string value_or(const Arguments& arguments, const std::string& name, const std::string& standard);
/// The option's value as a number above zero, unset where it was not given. Throws InputError if it is anything else.
std::optional<double> positive_number(const Arguments& arguments, const std::string& name);
/// Likewise as a whole number from 1 to `most`.
std::optional<int> whole_number(const Arguments& arguments, const std::string& name, int most);
/// A whole text as a finite number with a decimal point, whatever the locale; unset if it is none.
std::optional<double> to_number(const std::string& text);

/// The text of `abut COMMAND --help`.
std::string command_help(const CommandSpec& spec);

}  // namespace abut
