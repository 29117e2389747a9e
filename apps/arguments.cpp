// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/arguments.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <system_error>
#include <utility>

#include "geometry/brep/input_error.hpp"
#include "src/io/nearest_name.hpp"

namespace abut {

namespace {

std::string help_pointer(const CommandSpec& spec) {
    return "see abut " + spec.name + " --help";
}

const OptionSpec* find_option(const CommandSpec& spec, const std::string& name) {
    const auto found =
        std::find_if(spec.options.begin(), spec.options.end(), [&](const OptionSpec& o) { return o.name == name; });
    return found == spec.options.end() ? nullptr : &*found;
}

std::vector<std::string> option_names(const CommandSpec& spec) {
    std::vector<std::string> names;
    for (const OptionSpec& option : spec.options) names.push_back(option.name);
    return names;
}

bool is_option(const std::string& word) {
    return word.size() > 1 && word[0] == '-';
}

/// "-j4", as make has it. Other values do not join: "-out" is a misspelt option and not -o with the value "ut".
bool is_letter_with_number(const std::string& word) {
    return word.size() > 2 && word[1] != '-' && word.find_first_not_of("0123456789", 2) == std::string::npos;
}

bool asks_for_help(const std::vector<std::string>& words) {
    const auto end = std::find(words.begin(), words.end(), "--");
    return std::any_of(words.begin(), end, [](const std::string& word) { return word == "--help" || word == "-h"; });
}

/// Walks over the words once; problems are collected in the order of the words.
class Parser {
public:
    explicit Parser(const CommandSpec& spec) : spec_(spec) {}

    Arguments parse(const std::vector<std::string>& words) {
        bool only_operands = false;
        for (std::size_t i = 0; i < words.size(); ++i) {
            if (!only_operands && words[i] == "--") {
                only_operands = true;
            } else if (!only_operands && is_option(words[i])) {
                i += take_option(words, i);
            } else {
                take_operand(words[i]);
            }
        }
        if (spec_.operands == Operands::one && arguments_.operands.empty())
            problem("no " + spec_.operand + " given", "write abut " + spec_.name + " " + spec_.operand);
        if (!problems_.empty()) throw InputError(std::move(problems_));
        return std::move(arguments_);
    }

private:
    void problem(const std::string& what, const std::string& hint) { problems_.push_back({spec_.name, what, hint}); }

    /// Gives the number of words taken beyond the option's own.
    std::size_t take_option(const std::vector<std::string>& words, std::size_t at) {
        const std::string& word = words[at];
        const std::size_t equals = word.rfind("--", 0) == 0 ? word.find('=') : std::string::npos;
        const bool has_number = is_letter_with_number(word);
        const std::string name = word.substr(0, has_number ? 2 : equals);
        const OptionSpec* option = find_option(spec_, name);
        if (option == nullptr) {
            problem("unknown option " + shortened(name), nearest_name_hint(name, option_names(spec_)));
            return equals == std::string::npos ? words_meant_as_value(name, words, at) : 0;
        }
        if (arguments_.options.count(name) > 0) problem("option " + name + " is given twice", "give it once");
        if (has_number || equals != std::string::npos) {
            store_joined(*option, word.substr(has_number ? 2 : equals + 1));
            return 0;
        }
        return store_next(*option, words, at);
    }

    /// Can the next word be an option's value?
    bool has_value(const std::vector<std::string>& words, std::size_t at) const {
        if (at + 1 >= words.size() || words[at + 1].empty()) return false;
        return words[at + 1].rfind("--", 0) != 0 && find_option(spec_, words[at + 1]) == nullptr;
    }

    /// A misspelt option's value must not be taken for a second operand.
    std::size_t words_meant_as_value(const std::string& name, const std::vector<std::string>& words, std::size_t at) const {
        const OptionSpec* meant = find_option(spec_, nearest_name(name, option_names(spec_)));
        return meant != nullptr && !meant->value.empty() && has_value(words, at) ? 1 : 0;
    }

    void store_joined(const OptionSpec& option, const std::string& value) {
        if (option.value.empty()) problem("option " + option.name + " takes no value", "write " + option.name + " alone");
        if (!option.value.empty() && value.empty()) missing_value(option);
        arguments_.options[option.name] = value;
    }

    std::size_t store_next(const OptionSpec& option, const std::vector<std::string>& words, std::size_t at) {
        std::string& value = arguments_.options[option.name];
        if (option.value.empty()) return 0;
        if (!has_value(words, at)) {
            missing_value(option);
            return at + 1 < words.size() && words[at + 1].empty() ? 1 : 0;
        }
        value = words[at + 1];
        return 1;
    }

    void missing_value(const OptionSpec& option) {
        problem("option " + option.name + " needs a value", "write " + option.name + " " + option.value);
    }

    void take_operand(const std::string& word) {
        if (word.empty()) problem("the name given for " + spec_.operand + " is empty", help_pointer(spec_));
        if (spec_.operands == Operands::one && arguments_.operands.size() == 1) {
            problem("more than one " + spec_.operand + " given: '" + shortened(arguments_.operand) + "' and '" +
                        shortened(word) + "'",
                    "run it once for each");
        }
        if (arguments_.operands.empty()) arguments_.operand = word;
        arguments_.operands.push_back(word);
    }

    const CommandSpec& spec_;
    Arguments arguments_;
    std::vector<Problem> problems_;
};

std::string usage_line(const CommandSpec& spec) {
    const std::string operand = spec.operands == Operands::one ? spec.operand : "[" + spec.operand + "]";
    std::string line = "usage: abut " + spec.name + " " + operand;
    for (const OptionSpec& o : spec.options) line += " [" + o.name + (o.value.empty() ? "" : " " + o.value) + "]";
    return line + "\n";
}

}  // namespace

Arguments parse_arguments(const CommandSpec& spec, const std::vector<std::string>& words) {
    if (asks_for_help(words)) return {{}, {}, true};
    return Parser(spec).parse(words);
}

bool has(const Arguments& arguments, const std::string& name) {
    return arguments.options.count(name) > 0;
}

std::string value_or(const Arguments& arguments, const std::string& name, const std::string& standard) {
    const auto found = arguments.options.find(name);
    return found == arguments.options.end() ? standard : found->second;
}

std::optional<double> to_number(const std::string& text) {
    double number = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || stop != end || !std::isfinite(number)) return std::nullopt;
    return number;
}

std::optional<double> positive_number(const Arguments& arguments, const std::string& name) {
    if (!has(arguments, name)) return std::nullopt;
    const std::string text = arguments.options.at(name);
    const std::optional<double> number = to_number(text);
    if (!number || *number <= 0)
        throw InputError(name, "'" + shortened(text) + "' is not a number above zero", "write it as in 0.25");
    return number;
}

std::optional<int> whole_number(const Arguments& arguments, const std::string& name, int most) {
    if (!has(arguments, name)) return std::nullopt;
    const std::optional<double> number = to_number(arguments.options.at(name));
    if (!number || *number != std::floor(*number) || *number < 1 || *number > most)
        throw InputError(name,
                         "'" + shortened(arguments.options.at(name)) + "' is no whole number from 1 to " + std::to_string(most),
                         "leave it out for one on each processor");
    return static_cast<int>(*number);
}

std::string command_help(const CommandSpec& spec) {
    std::size_t width = 0;
    const auto left = [](const OptionSpec& o) { return o.value.empty() ? o.name : o.name + " " + o.value; };
    for (const OptionSpec& o : spec.options) width = std::max(width, left(o).size());
    std::string text = usage_line(spec) + "\n" + spec.summary + "\n\noptions:\n";
    for (const OptionSpec& o : spec.options)
        text += "  " + left(o) + std::string(width + 2 - left(o).size(), ' ') + o.help + "\n";
    return spec.notes.empty() ? text : text + "\n" + spec.notes;
}

}  // namespace abut
