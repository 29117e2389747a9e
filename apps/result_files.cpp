// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/result_files.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <utility>

#include "apps/output_folder.hpp"
#include "apps/png_file.hpp"
#include "geometry/brep/input_error.hpp"
#include "solver/linear_algebra/parallel_for.hpp"
#include "src/analysis/accuracy_results.hpp"
#include "src/io/nearest_name.hpp"
#include "src/io/whole_file.hpp"
#include "src/io/write_file.hpp"
#include "src/report/field_file.hpp"
#include "src/report/picture_files.hpp"
#include "src/report/report.hpp"
#include "src/results/result_units.hpp"

namespace abut {

namespace {

const std::vector<std::string> writable_formats{"json", "csv", "html", "vtu", "svg", "png"};

bool holds(const std::vector<std::string>& list, const std::string& word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

void set_time(Result& result, const std::string& name, double seconds) {
    auto entry = std::find_if(result.timing.begin(), result.timing.end(), [&](const auto& e) { return e.first == name; });
    if (entry == result.timing.end()) entry = result.timing.insert(entry, {name, 0.0});
    entry->second = seconds;
}

/// "2026-01-31T12:00:00Z", so many seconds ago.
std::string utc_time(double seconds_ago) {
    const std::chrono::duration<double> ago(seconds_ago);
    const auto then = std::chrono::system_clock::now() - std::chrono::duration_cast<std::chrono::system_clock::duration>(ago);
    const std::time_t time = std::chrono::system_clock::to_time_t(then);
    std::tm parts{};
    gmtime_r(&time, &parts);
    std::array<char, 32> text{};
    return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

std::string contact_file(std::size_t k) {
    return "contact_" + contact_number(k) + ".csv";
}

void write_contacts(const Result& result, const std::string& folder) {
    for (std::size_t k = 0; k < result.contacts.size(); ++k)
        write_file(folder, contact_file(k), contact_csv(result.contacts[k]));
}

void remove_file(const std::string& folder, const std::string& name) {
    std::error_code ignored;
    std::filesystem::remove(std::filesystem::path(folder) / name, ignored);
}

/// contact_12.csv, a table, or .svg, .png, a picture.
bool is_of_contact(const std::filesystem::path& file) {
    const std::string stem = file.stem().string(), ending = file.extension().string(), start = "contact_";
    return stem.rfind(start, 0) == 0 && stem.size() > start.size() &&
           stem.find_first_not_of("0123456789", start.size()) == std::string::npos &&
           (ending == ".csv" || ending == ".svg" || ending == ".png");
}

/// Removes what an earlier run has written of a result, whose contacts may have been others.
void remove_result(const std::string& folder) {
    std::vector<std::string> files{"result.json", "report.html", "fields.vtu"};
    for (const std::string picture : {"assembly", "stress", "displacement"})
        for (const char* ending : {".svg", ".png"}) files.push_back(picture + ending);
    std::error_code ignored;  // a left-over that cannot be removed is no reason to fail
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
        if (is_of_contact(entry.path())) files.push_back(entry.path().filename().string());
    for (const std::string& file : files) remove_file(folder, file);
}

/// As files that any program shows: png goes by way of svg, which stays only where it is asked for.
void write_pictures(const Result& result, const ModelFacts& model, const std::string& folder,
                    const std::vector<std::string>& formats) {
    for (const PictureFile& picture : picture_files(result, model)) {
        write_file(folder, picture.name + ".svg", picture.svg);
        if (holds(formats, "png")) write_png(folder, picture.name, picture.name + ".svg");
        if (!holds(formats, "svg")) remove_file(folder, picture.name + ".svg");
    }
}

/// Removes what an earlier run with load cases has written into the folder, which its cases.json lists.
void remove_cases(const std::string& folder) {
    const std::string list = path_in(folder, "cases.json");
    std::error_code ignored;
    if (!std::filesystem::exists(list, ignored)) return;
    for (const std::string& own : folders_of_cases(read_whole_file(list))) {
        const std::string path = path_in(folder, own);
        remove_result(path);
        std::filesystem::remove(path, ignored);  // if nothing else is there
    }
    for (const char* file : {"cases.json", "envelope.csv", "fields.pvd"}) remove_file(folder, file);
}

}  // namespace

void check_formats(const Scene& scene) {
    std::vector<Problem> problems;
    for (const std::string& format : scene.output.formats) {
        if (!holds(writable_formats, format))
            problems.push_back({scene.file + " /output/formats", "the format '" + shortened(format) + "' is not supported",
                                "use " + listed(writable_formats)});
        else if (format == "png" && !can_write_png())
            problems.push_back({scene.file + " /output/formats",
                                std::string("pictures as png are made by ") + png_program + ", which is not installed",
                                "install it (apt-get install librsvg2-bin), or write svg"});
    }
    if (!problems.empty()) throw InputError(std::move(problems));
}

void add_formats(Output& output, const std::string& words) {
    std::istringstream list(words);
    for (std::string word; std::getline(list, word, ',');) {
        if (!holds(writable_formats, word))
            throw InputError("--format", "the format '" + shortened(word) + "' is not supported",
                             "give some of " + listed(writable_formats) + ", with commas between");
        if (!holds(output.formats, word)) output.formats.push_back(word);
    }
}

void complete_import_time(Result& result, double seconds) {
    auto& timing = result.timing;
    const auto entry = std::find_if(timing.begin(), timing.end(), [](const auto& e) { return e.first == "import"; });
    if (entry == timing.end()) {
        timing.insert(timing.begin(), {"import", seconds});
    } else if (entry->second == 0) {
        entry->second = seconds;
    }
}

ModelFacts facts_of_run(const Scene& scene, const ModelSources& sources, const Stopwatch& since_start) {
    ModelFacts facts = model_facts(scene, sources);
    facts.begun = utc_time(since_start.seconds());
    return facts;
}

namespace {

/// data: report_data of the result, where it is made already; else null.
void write_files(Result& result, const ModelFacts& model, const std::string* data, const std::string& folder,
                 const std::vector<std::string>& formats, const Stopwatch& since_start, int threads) {
    const Stopwatch output;
    set_time(result, "output", 0);
    remove_cases(folder);
    remove_result(folder);
    if (holds(formats, "csv")) write_contacts(result, folder);
    if (holds(formats, "vtu")) write_file(folder, "fields.vtu", fields_vtu(result));
    if (holds(formats, "svg") || holds(formats, "png")) write_pictures(result, model, folder, formats);
    set_time(result, "total", since_start.seconds());
    if (holds(formats, "html")) write_file(folder, "report.html", report_html(result, model, threads, data));
    set_time(result, "output", output.seconds());
    set_time(result, "total", since_start.seconds());
    predict_next_level(result);  // with the time of writing
    if (holds(formats, "json")) write_file(folder, "result.json", result_json(result, model));
}

}  // namespace

void write_results(Result& result, const ModelFacts& model, const std::string& folder, const std::vector<std::string>& formats,
                   const Stopwatch& since_start, int threads) {
    write_files(result, model, nullptr, folder, formats, since_start, threads);
}

void write_case_results(std::vector<CaseResult>& cases, const std::vector<ModelFacts>& models, const std::string& folder,
                        const std::vector<std::string>& formats, const Stopwatch& since_start, int threads) {
    remove_cases(folder);
    remove_result(folder);
    std::vector<std::pair<std::string, std::string>> series;
    std::vector<std::string> data(cases.size());
    solver::parallel_for(static_cast<int>(cases.size()), threads, [&](int i) {
        const auto k = static_cast<std::size_t>(i);
        const std::string own = path_in(folder, case_folder(k));
        prepare_output_folder(own);
        if (holds(formats, "html")) data[k] = report_data(cases[k].result, models[k]);
        write_files(cases[k].result, models[k], &data[k], own, formats, since_start, 1);
    });
    for (std::size_t k = 0; k < cases.size(); ++k) series.emplace_back(cases[k].name, case_folder(k) + "/fields.vtu");
    if (holds(formats, "vtu")) write_file(folder, "fields.pvd", fields_pvd(series));
    if (holds(formats, "csv")) write_file(folder, "envelope.csv", envelope_csv(cases));
    if (holds(formats, "html")) write_file(folder, "report.html", cases_html(cases, models, data));
    write_file(folder, "cases.json", cases_json(cases));  // in any case: it lists the folders
}

std::string main_file_line(const std::string& folder, const Output& output, bool has_cases) {
    if (holds(output.formats, "html")) return "report: " + path_in(folder, "report.html") + "\n";
    if (has_cases) return "result: " + path_in(folder, "cases.json") + "\n";
    if (holds(output.formats, "json")) return "result: " + path_in(folder, "result.json") + "\n";
    return "";
}

}  // namespace abut
