// SPDX-License-Identifier: GPL-3.0-or-later
// abut verify: problems with known answers, solved and compared.
#include "src/verification/verify.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "apps/commands.hpp"
#include "apps/data_folder.hpp"
#include "apps/output_folder.hpp"
#include "apps/print_text.hpp"
#include "apps/progress_line.hpp"
#include "src/io/write_file.hpp"
#include "src/verification/expectations.hpp"
#include "src/verification/verify_dissertation.hpp"
#include "src/verification/verify_figures.hpp"

namespace abut {

namespace {

constexpr const char* dissertation = "dissertation";

/// Is the dissertation asked for? Its name is taken out of the list.
bool take_dissertation(std::vector<std::string>& names) {
    return std::erase(names, dissertation) > 0;
}

std::vector<SolvedTable> solved_tables(const std::string& folder) {
    ProgressLine line(true);
    std::vector<SolvedTable> solved;
    for (const DissertationTable& table : dissertation_tables()) {
        line.show(table.title);
        solved.push_back(solve_table(table, folder));
    }
    return solved;
}

void write_figures(const std::vector<SolvedTable>& solved, const std::string& data_folder, const std::string& folder) {
    for (const SolvedTable& table : solved) {
        std::vector<Figure> figures = method_figures(table.table, data_folder);
        for (Figure& figure : answer_figures(table)) figures.push_back(std::move(figure));
        for (const Figure& figure : figures) write_file(folder, figure.file, figure.svg);
    }
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

/// Folders and files of scenes among the names are taken out of the list.
std::vector<std::string> take_paths(std::vector<std::string>& names) {
    const auto is_path = [](const std::string& name) {
        if (std::filesystem::exists(name)) return true;
        if (name.ends_with(".json") || name.find('/') != std::string::npos)
            throw InputError(name, "there is no such file or folder", "");
        return false;
    };
    std::vector<std::string> paths;
    std::copy_if(names.begin(), names.end(), std::back_inserter(paths), is_path);
    std::erase_if(names, is_path);
    return paths;
}

std::vector<std::string> scenes_of(const std::vector<std::string>& paths) {
    std::vector<std::string> scenes;
    for (const std::string& path : paths)
        for (std::string& scene : scenes_with_expectations(path)) scenes.push_back(std::move(scene));
    return scenes;
}

std::vector<VerifyRow> verified_scenes(const std::vector<std::string>& scenes) {
    ProgressLine line(true);
    std::vector<VerifyRow> rows;
    for (const std::string& scene : scenes) {
        line.show(scene);
        const std::vector<VerifyRow> more = verify_scene(scene);
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
         {"--figures", "DIR",
          "write the figures of the dissertation's chapters 4 and 5, as its method has them; with dissertation"},
         {"--data", "DIR", "folder with verification/ and scenes/ (default: the one the program came with)"}},
        "NAME is a problem (E4-quarter) or a group of them (E4); without any, all are solved, which takes minutes.\n"
        "NAME may also be a folder, or a scene: then all scenes below it that have \"expect\" are solved (abut help expect).\n"
        "dissertation: the tables of the dissertation, its printed values beside its method's and ours.\n"
        "The exit status is 1 where a quantity misses its tolerance.\n"};
    spec.operands = Operands::any;
    return spec;
}

int verify_command(const Arguments& arguments) {
    std::vector<std::string> names = arguments.operands;
    const bool tables = take_dissertation(names);
    const std::vector<std::string> scenes = scenes_of(take_paths(names));
    // the dissertation or scenes alone ask for no other problem
    const bool has_others = tables || !scenes.empty();
    const std::vector<VerifyProblem> problems =
        has_others && names.empty() ? std::vector<VerifyProblem>{} : chosen_problems(names);
    if (has(arguments, "--list")) {
        if (!problems.empty()) print_text(verify_list(problems));
        for (const std::string& scene : scenes) print_text(scene + "\n");
        if (tables || (names.empty() && scenes.empty())) print_text(dissertation_list());
        return exit_done;
    }
    const std::string figures = has(arguments, "--figures") ? arguments.options.at("--figures") : "";
    if (!figures.empty() && !tables)
        throw InputError("--figures", "the figures are the dissertation's", "write: abut verify dissertation --figures DIR");
    if (!figures.empty()) prepare_output_folder(figures);
    const std::string folder = tables || !problems.empty() ? data_folder(arguments) : "";
    const std::vector<SolvedTable> solved = tables ? solved_tables(folder) : std::vector<SolvedTable>{};
    if (!figures.empty()) write_figures(solved, folder, figures);
    std::vector<VerifyRow> rows;
    for (const SolvedTable& table : solved)
        for (VerifyRow& row : rows_of(table)) rows.push_back(std::move(row));
    std::vector<VerifyRow> others = verified(problems, folder);
    for (VerifyRow& row : verified_scenes(scenes)) others.push_back(std::move(row));
    if (!has(arguments, "--json")) {
        if (tables) print_text(dissertation_text(solved));
        if (!others.empty()) print_text(verify_table(others));
    }
    rows.insert(rows.end(), others.begin(), others.end());
    if (has(arguments, "--json")) print_text(verify_json(rows));
    std::cout.flush();
    report_failures(rows);
    const bool all_pass = std::all_of(rows.begin(), rows.end(), [](const VerifyRow& row) { return row.pass; });
    return all_pass ? exit_done : exit_failed;
}

}  // namespace abut
