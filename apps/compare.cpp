// SPDX-License-Identifier: GPL-3.0-or-later
// abut compare and abut report: results that are there already.
#include <algorithm>
#include <filesystem>
#include <iostream>

#include "apps/commands.hpp"
#include "apps/output_folder.hpp"
#include "apps/print_text.hpp"
#include "geometry/brep/input_error.hpp"
#include "src/io/whole_file.hpp"
#include "src/io/write_file.hpp"
#include "src/report/made_report.hpp"
#include "src/results/result_difference.hpp"

namespace abut {

namespace {

/// The path of a file of a result's folder, which may be given by its result.json.
std::string file_of_result(const std::string& given, const std::string& name) {
    const std::filesystem::path path(given);
    if (!std::filesystem::exists(path))
        throw InputError(given, "there is no such file or folder", "give a folder of abut analyze");
    if (!std::filesystem::is_directory(path) && path.filename() != "result.json" && path.filename() != name)
        throw InputError(given, "this is no result", "give a folder of abut analyze, or its " + name);
    const std::filesystem::path folder = std::filesystem::is_directory(path) ? path : path.parent_path();
    if (!std::filesystem::exists(folder / name) && std::filesystem::exists(folder / "cases.json") && name == "result.json")
        throw InputError(given, "this is the result of several load cases or steps",
                         "give the folder of one of them: " + (folder / "case_1").string());
    return (folder / name).string();
}

}  // namespace

CommandSpec compare_spec() {
    CommandSpec spec{
        "compare",
        "A B",
        "Compares two results of abut analyze, number by number.",
        {{"-o", "DIR", "folder for compare.html: both results in one page"},
         {"--tolerance", "T", "end with status 1 where a number differs by more than T, relative to the larger"},
         {"--quiet", "", "print nothing but errors"}},
        "A and B are folders of abut analyze, or their result.json. Contacts are the same where their edges are, "
        "parts where\ntheir names are. Differences that are larger than what both are known to (their estimated errors "
        "together) are marked.\n"};
    spec.operands = Operands::any;
    return spec;
}

int compare_command(const Arguments& arguments) {
    if (arguments.operands.size() != 2)
        throw InputError("", "two results are compared, " + std::to_string(arguments.operands.size()) + " are given",
                         "abut compare A B");
    const std::string &a = arguments.operands[0], &b = arguments.operands[1];
    const std::string json_a = file_of_result(a, "result.json"), json_b = file_of_result(b, "result.json");
    const std::optional<double> tolerance = positive_number(arguments, "--tolerance");
    const ResultDifference difference = compare_results(read_whole_file(json_a), json_a, read_whole_file(json_b), json_b);
    if (!has(arguments, "--quiet")) print_text(difference_table(difference));
    if (has(arguments, "-o")) {
        const std::string folder = arguments.options.at("-o");
        const std::string html_a = file_of_result(a, "report.html"), html_b = file_of_result(b, "report.html");
        const std::string page = compare_html(difference, read_whole_file(html_a), html_a, read_whole_file(html_b), html_b);
        prepare_output_folder(folder);
        write_file(folder, "compare.html", page);
        if (!has(arguments, "--quiet")) print_text("page: " + path_in(folder, "compare.html") + "\n");
    }
    const auto differs = [&](const ComparedNumber& n) {
        const std::optional<double> relative = relative_difference(n);
        return !relative || *relative > *tolerance;
    };
    if (!tolerance || std::none_of(difference.numbers.begin(), difference.numbers.end(), differs)) return exit_done;
    std::cout.flush();
    std::cerr << "abut: the results differ by more than " << arguments.options.at("--tolerance") << "\n";
    return exit_failed;
}

CommandSpec report_spec() {
    return {
        "report",
        "DIR",
        "Makes the report.html of a result anew, with the instrument of this program.",
        {{"--quiet", "", "print nothing but errors"}},
        "DIR is a folder of abut analyze with a report.html, which is replaced: its pictures, words and fields stay, its style "
        "and\nits script become those of this program.\n"};
}

int report_command(const Arguments& arguments) {
    const std::string file = file_of_result(arguments.operand, "report.html");
    const std::string page = remade_report(read_whole_file(file), file);
    const std::filesystem::path path(file);
    write_file(path.parent_path().string(), path.filename().string(), page);
    if (!has(arguments, "--quiet")) print_text("report: " + file + "\n");
    return exit_done;
}

}  // namespace abut
