// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses the command, and turns everything that can go wrong into lines on standard error and an exit status.
#include <algorithm>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "apps/arguments.hpp"
#include "apps/commands.hpp"
#include "apps/keep_heap.hpp"
#include "apps/print_text.hpp"
#include "geometry/brep/input_error.hpp"
#include "src/io/build_id.hpp"
#include "src/io/nearest_name.hpp"

namespace {

using namespace abut;

[[noreturn]] void refuse_command(const std::string& word) {
    std::vector<std::string> names;
    for (const Command& command : known_commands()) names.push_back(command.spec.name);
    throw InputError("", "unknown command '" + shortened(word) + "'", nearest_name_hint(word, names));
}

int run_command(const std::string& name, const std::vector<std::string>& words) {
    for (const Command& command : known_commands()) {
        if (command.spec.name != name) continue;
        const Arguments arguments = parse_arguments(command.spec, words);
        if (!arguments.help) return command.run(arguments);
        std::cout << command_help(command.spec);
        return exit_done;
    }
    refuse_command(name);
}

int run(const std::vector<std::string>& words) {
    if (words.empty()) throw InputError("", "no command given", "abut --help lists the commands");
    if (words[0] == "--help" || words[0] == "-h") {
        std::cout << general_help();
    } else if (words[0] == "--version") {
        std::cout << "abut " << program_build() << "\n";
    } else {
        return run_command(words[0], {words.begin() + 1, words.end()});
    }
    return exit_done;
}

/// Output that got lost, on a full disk for instance, must not look like success.
int check_output(int status) {
    std::cout.flush();
    if (std::cout.good()) return status;
    throw InputError("standard output", "it cannot be written to", "is the disk full?");
}

}  // namespace

int main(int argc, char** argv) {
    keep_heap();
    try {
        return check_output(run({argv + std::min(argc, 1), argv + argc}));
    } catch (const InputError& error) {
        std::cout.flush();
        for (const Problem& problem : error.problems()) std::cerr << "abut: " << one_line_text(one_line(problem)) << "\n";
        return exit_wrong_input;
    } catch (const std::bad_alloc&) {
        std::cerr << "abut: there is not enough memory; use larger cells, or --accuracy draft\n";
    } catch (const std::exception& error) {
        std::cerr << "abut: an error in the program itself: " << one_line_text(error.what())
                  << "; please report it with the file\n";
    }
    return exit_failed;
}
