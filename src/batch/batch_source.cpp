// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch/batch_source.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <sstream>
#include <system_error>

#include "geometry/brep/input_error.hpp"
#include "src/batch/job_key.hpp"
#include "src/io/csv_table.hpp"
#include "src/io/folder_walk.hpp"
#include "src/io/nearest_name.hpp"
#include "src/io/utf8.hpp"
#include "src/io/whole_file.hpp"
#include "src/scene/read_drawing.hpp"

namespace abut {

namespace {

namespace fs = std::filesystem;

/// CAD files that nothing here reads. Someone who put them into the folder expects an answer, if only that they cannot be read.
const std::set<std::string> foreign_cad{".iges", ".igs", ".dwg", ".sldprt", ".sldasm", ".ipt",   ".iam", ".catpart",
                                        ".x_t",  ".x_b", ".sat", ".brep",   ".prt",    ".fcstd", ".dgn", ".catproduct"};

constexpr std::size_t longest_name = 160;  // bytes; file systems take 255, and "~2" may be added
constexpr std::size_t row_digits = 4;      // of the number in a job's name: names sort like rows up to 9999 of them

/// Bytes that are no text would not come back from job.json as they were.
std::string as_text(const std::string& bytes) {
    std::string text;
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t n = utf8_length(bytes, at);
        text += n == 0 ? "_" : bytes.substr(at, n);
        at += std::max<std::size_t>(n, 1);
    }
    return text;
}

/// Long names keep their end, and begin with a hash of the whole.
std::string shortened_name(const std::string& name) {
    if (name.size() <= longest_name) return name;
    return content_hash(name) + "-" + as_text(name.substr(name.size() - longest_name / 2));
}

/// A name that is one folder on every file system.
std::string folder_name(const std::string& path) {
    std::string name = as_text(fs::path(path).lexically_normal().generic_string());
    while (name.starts_with("../")) name.erase(0, 3);
    for (char& c : name)
        if (c == '/' || c == '\\' || c == ':' || static_cast<unsigned char>(c) < ' ') c = '-';
    while (!name.empty() && (name.front() == '.' || name.front() == '-')) name.erase(0, 1);
    return name.empty() ? "job" : shortened_name(name);
}

/// Jobs of the same name get numbers, in their order.
void make_names_unique(std::vector<BatchJob>& jobs) {
    std::set<std::string> taken;
    for (BatchJob& job : jobs) {
        const std::string wanted = job.name;
        for (int k = 2; !taken.insert(job.name).second; ++k) job.name = wanted + "~" + std::to_string(k);
    }
}

bool belongs(const fs::path& file, const SourceOptions& options) {
    const std::string ending = ending_of(file.string());
    if (ending == ".json") return !options.only_drawings;
    return is_importable(file.string()) || foreign_cad.contains(ending);
}

/// Hidden, the OUT of this batch, or that of another one.
bool is_passed_over(const fs::path& folder, const SourceOptions& options) {
    std::error_code error;
    if (folder.filename().string().starts_with(".")) return true;
    if (!options.excluded.empty() && fs::equivalent(folder, options.excluded, error)) return true;
    return fs::exists(folder / "batch.json", error) && fs::is_directory(folder / "jobs", error);
}

/// What abut itself writes beside a scene is none.
bool is_answer(const fs::path& file) {
    static const std::set<std::string> names{"result.json",  "contacts.json", "study.json",
                                             "summary.json", "job.json",      "batch.json"};
    return names.contains(file.filename().string());
}

BatchSource from_folder(const std::string& folder, const SourceOptions& options) {
    std::error_code error;
    if (!options.excluded.empty() && fs::equivalent(folder, options.excluded, error))
        throw InputError(folder, "the results would go into the folder that the jobs are read from",
                         "give another folder with -o");
    BatchSource source;
    const FolderFiles found = files_below(folder, [&](const fs::path& below) { return is_passed_over(below, options); });
    source.folders_left_out = found.left_out;
    for (const fs::path& file : found.files) {
        if (belongs(file, options) && !is_answer(file))
            source.jobs.push_back({folder_name(file.lexically_relative(folder).generic_string()), file.string(), {}, ""});
        else
            ++source.left_out[ending_of(file.string())];
    }
    std::sort(source.jobs.begin(), source.jobs.end(), [](const BatchJob& a, const BatchJob& b) { return a.file < b.file; });
    return source;
}

std::string beside(const std::string& list, const std::string& file) {
    return (fs::path(list).parent_path() / file).lexically_normal().string();
}

BatchSource from_list(const std::string& list) {
    BatchSource source;
    std::istringstream lines(read_whole_file(list));
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first == std::string::npos || line[first] == '#') continue;
        const std::string file = line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
        source.jobs.push_back({folder_name(file), beside(list, file), {}, list + ":" + std::to_string(number)});
    }
    return source;
}

std::optional<double> number_in(const std::string& text) {
    double number = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || stop != end || !std::isfinite(number)) return std::nullopt;
    return number;
}

std::string row_number(std::size_t row) {
    const std::string digits = std::to_string(row);
    return std::string(row_digits - std::min(row_digits, digits.size()), '0') + digits;
}

void read_parameters(const Table& table, const TableRow& row, BatchJob& job, std::vector<Problem>& problems) {
    for (const auto& [column, text] : row.cells) {
        if (column == "file" || column == "name") continue;
        if (const std::optional<double> number = number_in(text))
            job.parameters[column] = *number;
        else
            problems.push_back({place_of(table, row), "column " + column + ": '" + shortened(text) + "' is no number",
                                "parameters are numbers with a decimal point; an empty field leaves the template's value"});
    }
}

BatchSource from_table(const std::string& path) {
    const Table table = read_table(path);
    BatchSource source;
    source.names_files = std::find(table.columns.begin(), table.columns.end(), "file") != table.columns.end();
    for (const std::string& column : table.columns)
        if (column != "file" && column != "name") source.parameters[column] = table.file;
    std::vector<Problem> problems;
    for (const TableRow& row : table.rows) {
        BatchJob job{"", "", {}, place_of(table, row)};
        const std::optional<std::string> file = cell(row, "file"), name = cell(row, "name");
        if (file) job.file = beside(path, *file);
        if (source.names_files && !file) problems.push_back({job.where, "this row names no file", "fill the column 'file'"});
        const std::string number = row_number(source.jobs.size() + 1);
        job.name = name ? folder_name(*name) : file ? number + "-" + folder_name(*file) : number;
        read_parameters(table, row, job, problems);
        source.jobs.push_back(std::move(job));
    }
    if (!problems.empty()) throw InputError(std::move(problems));
    return source;
}

BatchSource from_file(const std::string& path) {
    if (is_table(path)) return from_table(path);
    const std::string ending = ending_of(path);
    if (ending == ".txt" || ending == ".list" || ending == ".lst") return from_list(path);
    if (ending != ".json" && !is_importable(path))
        throw InputError(path, "this is nothing that a batch can be made of",
                         "give a folder, a list of files (.txt), a table (.csv, .jsonl), a scene, a drawing, solids or a mesh");
    BatchSource source;
    source.jobs.push_back({folder_name(fs::path(path).filename().string()), path, {}, ""});
    return source;
}

}  // namespace

BatchSource read_batch_source(const std::string& source, const SourceOptions& options) {
    std::error_code error;
    if (!fs::exists(source, error))
        throw InputError(source, "there is no such file or folder", "check the name and the folder");
    BatchSource read = fs::is_directory(source, error) ? from_folder(source, options) : from_file(source);
    if (read.jobs.empty())
        throw InputError(source, "there is nothing to do in it",
                         options.only_drawings ? "give a folder with drawings or meshes, or a table"
                                               : "give a folder with scenes, drawings or meshes");
    make_names_unique(read.jobs);
    return read;
}

}  // namespace abut
