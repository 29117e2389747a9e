// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/result_files.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <filesystem>
#include <system_error>
#include <utility>

#include "apps/output_folder.hpp"
#include "geometry/brep/input_error.hpp"
#include "src/analysis/accuracy_results.hpp"
#include "src/io/nearest_name.hpp"
#include "src/io/whole_file.hpp"
#include "src/io/write_file.hpp"
#include "src/report/report.hpp"
#include "src/results/result_units.hpp"

namespace abut {

namespace {

const std::vector<std::string> writable_formats{"json", "csv", "html"};

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

void remove_contacts_from(std::size_t k, const std::string& folder) {
    std::error_code ignored;  // a left-over that cannot be removed is no reason to fail
    while (std::filesystem::remove(std::filesystem::path(folder) / contact_file(k), ignored)) ++k;
}

void write_contacts(const Result& result, const std::string& folder) {
    for (std::size_t k = 0; k < result.contacts.size(); ++k)
        write_file(folder, contact_file(k), contact_csv(result.contacts[k]));
    remove_contacts_from(result.contacts.size(), folder);
}

void remove_file(const std::string& folder, const std::string& name) {
    std::error_code ignored;
    std::filesystem::remove(std::filesystem::path(folder) / name, ignored);
}

/// Removes what an earlier run with load cases has written into the folder, which its cases.json lists.
void remove_cases(const std::string& folder) {
    const std::string list = path_in(folder, "cases.json");
    std::error_code ignored;
    if (!std::filesystem::exists(list, ignored)) return;
    for (const std::string& own : folders_of_cases(read_whole_file(list))) {
        const std::string path = path_in(folder, own);
        for (const char* file : {"result.json", "report.html"}) remove_file(path, file);
        remove_contacts_from(0, path);
        std::filesystem::remove(path, ignored);  // if nothing else is there
    }
    for (const char* file : {"cases.json", "envelope.csv"}) remove_file(folder, file);
}

}  // namespace

void check_formats(const Scene& scene) {
    std::vector<Problem> problems;
    for (const std::string& format : scene.output.formats) {
        if (holds(writable_formats, format)) continue;
        problems.push_back({scene.file + " /output/formats", "the format '" + shortened(format) + "' is not supported",
                            "use " + listed(writable_formats)});
    }
    if (!problems.empty()) throw InputError(std::move(problems));
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

void write_results(Result& result, const ModelFacts& model, const std::string& folder, const std::vector<std::string>& formats,
                   const Stopwatch& since_start) {
    const Stopwatch output;
    set_time(result, "output", 0);
    remove_cases(folder);
    if (holds(formats, "csv")) write_contacts(result, folder);
    set_time(result, "total", since_start.seconds());
    if (holds(formats, "html")) write_file(folder, "report.html", report_html(result, model));
    set_time(result, "output", output.seconds());
    set_time(result, "total", since_start.seconds());
    predict_next_level(result);  // with the time of writing
    if (holds(formats, "json")) write_file(folder, "result.json", result_json(result, model));
}

void write_case_results(std::vector<CaseResult>& cases, const std::vector<ModelFacts>& models, const std::string& folder,
                        const std::vector<std::string>& formats, const Stopwatch& since_start) {
    remove_cases(folder);
    remove_file(folder, "result.json");
    remove_contacts_from(0, folder);
    for (std::size_t k = 0; k < cases.size(); ++k) {
        const std::string own = path_in(folder, case_folder(k));
        prepare_output_folder(own);
        write_results(cases[k].result, models[k], own, formats, since_start);
    }
    if (holds(formats, "csv")) write_file(folder, "envelope.csv", envelope_csv(cases));
    if (holds(formats, "html")) write_file(folder, "report.html", cases_html(cases, models));
    write_file(folder, "cases.json", cases_json(cases));  // in any case: it lists the folders
}

std::string main_file_line(const std::string& folder, const Output& output, bool has_cases) {
    if (holds(output.formats, "html")) return "report: " + path_in(folder, "report.html") + "\n";
    if (has_cases) return "result: " + path_in(folder, "cases.json") + "\n";
    if (holds(output.formats, "json")) return "result: " + path_in(folder, "result.json") + "\n";
    return "";
}

}  // namespace abut
