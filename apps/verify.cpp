// SPDX-License-Identifier: GPL-3.0-or-later
// abut verify: problems with known answers, solved and compared.
#include "src/verify.hpp"

#include <algorithm>
#include <iostream>

#include "apps/commands.hpp"
#include "apps/data_folder.hpp"
#include "apps/print_text.hpp"
#include "apps/progress_line.hpp"
#include "geometry/input_error.hpp"

namespace abut {

namespace {

void refuse_future_names(const std::vector<std::string>& names) {
    if (std::find(names.begin(), names.end(), "dissertation") != names.end())
        throw InputError("verify", "the dissertation's tables are not supported yet", "abut verify --list shows what is");
}

std::vector<VerifyRow> verified(const std::vector<VerifyProblem>& problems, const std::string& folder) {
    ProgressLine line(true);
    std::vector<VerifyRow> rows;
    for (const VerifyProblem& problem : problems) {
        line.show(problem.name);
        const std::vector<VerifyRow> more = verify(problem, folder);
        rows.insert(rows.end(), more.begin(), more.end());
    }
    return rows;
}

/// Failures are said once a problem, whatever is printed of the rows.
void report_failures(const std::vector<VerifyRow>& rows) {
    std::string last;
    for (const VerifyRow& row : rows) {
        if (row.failure.empty() || row.name == last) continue;
        std::cerr << "abut: " << row.name << ": " << one_line_text(row.failure) << "\n";
        last = row.name;
    }
}

}  // namespace

CommandSpec verify_spec() {
    CommandSpec spec{
        "verify",
        "NAME...",
        "Solves problems with known answers and compares.",
        {{"--list", "", "list the problems and stop"},
         {"--json", "", "print the comparison as JSON instead of a table"},
         {"--data", "DIR", "folder with verification/ and scenes/ (default: the one the program came with)"}},
        "NAME is a problem (E4-quarter) or a group of them (E4); without any, all are solved, which takes minutes.\n"
        "The exit status is 1 where a quantity misses its tolerance.\n"};
    spec.operands = Operands::any;
    return spec;
}

int verify_command(const Arguments& arguments) {
    refuse_future_names(arguments.operands);
    const std::vector<VerifyProblem> problems = chosen_problems(arguments.operands);
    if (has(arguments, "--list")) {
        print_text(verify_list(problems));
        return exit_done;
    }
    const std::vector<VerifyRow> rows = verified(problems, data_folder(arguments));
    print_text(has(arguments, "--json") ? verify_json(rows) : verify_table(rows));
    std::cout.flush();
    report_failures(rows);
    const bool all_pass = std::all_of(rows.begin(), rows.end(), [](const VerifyRow& row) { return row.pass; });
    return all_pass ? exit_done : exit_failed;
}

}  // namespace abut
