// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/batch_job.hpp"

#include <algorithm>
#include <filesystem>

#include "apps/accuracy_option.hpp"
#include "apps/drawing_options.hpp"
#include "apps/drawing_problems.hpp"
#include "apps/print_text.hpp"
#include "apps/result_files.hpp"
#include "apps/stopwatch.hpp"
#include "geometry/brep/input_error.hpp"
#include "src/analysis/analysis.hpp"
#include "src/batch/batch_thumbnail.hpp"
#include "src/batch/job_store.hpp"
#include "src/contact/detect.hpp"
#include "src/contact/expected_pairs.hpp"
#include "src/inspection/detect_pictures.hpp"
#include "src/io/whole_file.hpp"
#include "src/io/write_file.hpp"
#include "src/results/result.hpp"
#include "src/results/verdict.hpp"
#include "src/scene/read_scene.hpp"
#include "src/scene/scene.hpp"

namespace abut {

namespace {

/// Faults of the disk are none of the job's.
template <class Write>
void writing(Write write) {
    try {
        write();
    } catch (const InputError& error) { throw StoreError(error.what()); }
}

bool is_scene(const std::string& file) {
    return kind_of_file(file) == FileKind::scene;
}

/// A folder may hold JSON of other kinds; one line about that says more than twenty about its keys.
void check_is_scene(const std::string& file) {
    if (read_whole_file(file).find("\"abut\"") == std::string::npos)
        throw InputError(file, "this is no scene: it has no key 'abut'",
                         "take it out of the folder, or begin it with \"abut\": 1");
}

Scene read_job_scene(const JobSettings& settings, const BatchJob& job) {
    if (settings.template_file.empty()) {
        if (!is_scene(job.file)) return read_whole_sketch(job.file, settings.import_options).scene;
        check_is_scene(job.file);
        return read_scene(job.file, job.parameters);
    }
    if (!job.file.empty() && is_scene(job.file))
        throw InputError(job.file, "this is a scene, and the template is one already",
                         "give drawings or meshes with a template");
    Scene scene = read_scene(settings.template_file, job.parameters, job.file);
    scene.title += (scene.title.empty() ? "" : ": ") + job.name;
    return scene;
}

std::optional<double> worst_error(const Result& result) {
    std::optional<double> worst;
    for (const ContactResult& contact : result.contacts)
        if (contact.error_estimate) worst = std::max(worst.value_or(0), *contact.error_estimate);
    return worst ? worst : result.error_estimate.stress;
}

void note_answer(const Result& result, JobRecord& record) {
    const Verdict verdict = verdict_of(result);
    if (verdict == Verdict::failed) {
        record.status = JobRecord::Status::failed;
        record.message = one_line_text(result.message);
    } else if (verdict == Verdict::solved_but) {
        record.status = JobRecord::Status::solved_but;
        record.message = one_line_text(reasons_text(result));
    }
    int closed = 0;
    for (const ContactResult& contact : result.contacts) {
        closed += contact.status != "open";
        record.max_pressure = std::max(record.max_pressure.value_or(0), contact.max_pressure.value);
    }
    for (const PartResult& part : result.parts)
        record.max_von_mises = std::max(record.max_von_mises.value_or(0), part.max_von_mises.value);
    record.pairs = static_cast<int>(result.contacts.size());
    record.closed = closed;
    record.error_estimate = worst_error(result);
    record.warnings = result.warnings;
    if (ended_well(record)) return;
    record.max_pressure = record.max_von_mises = record.error_estimate = std::nullopt;
    record.closed = std::nullopt;
}

void analyze_job(const JobSettings& settings, Scene& scene, const std::string& folder, const Stopwatch& watch,
                 JobRecord& record) {
    const double reading_seconds = watch.seconds();
    const ModelSources sources = model_sources(scene);
    override_accuracy(scene.accuracy, settings.arguments);
    check_formats(scene);
    AnalyzeOptions options;
    options.threads = 1;  // other jobs have the other processors
    Result result = analyze(scene, options);
    complete_import_time(result, reading_seconds);
    note_answer(result, record);
    writing([&] {
        write_results(result, facts_of_run(scene, sources, watch), folder, scene.output.formats, watch);
        write_file(folder, "thumbnail.svg", thumbnail(scene, result));
    });
}

void detect_job(const JobSettings& settings, const BatchJob& job, const Scene& scene, const std::string& folder,
                JobRecord& record) {
    const Detection detection = detect_contacts(scene, settings.distance);
    record.pairs = count_pairs(detection);
    record.warnings = scene.warnings;
    if (const std::vector<ExpectedPair>* expected = expected_for(settings, job)) {
        record.expectation = count_expected(detection, *expected);
        const std::size_t n = record.expectation->differences.size();
        if (n > 0) record.status = JobRecord::Status::differs;
        if (n > 0) record.message = std::to_string(n) + (n == 1 ? " difference" : " differences") + " from what is expected";
    }
    writing([&] {
        write_file(folder, "contacts.json", detection_json(scene, detection));
        write_file(folder, "contacts.svg", detection_svg(scene, detection));
        write_file(folder, "thumbnail.svg", thumbnail(scene, detection));
    });
}

}  // namespace

const std::vector<ExpectedPair>* expected_for(const JobSettings& settings, const BatchJob& job) {
    if (!settings.expectations) return nullptr;
    return expected_for(*settings.expectations, {job.name, job.file, std::filesystem::path(job.file).filename().string()});
}

JobRecord do_batch_job(const JobSettings& settings, const BatchJob& job, const std::string& folder) {
    const Stopwatch watch;
    JobRecord record;
    Scene scene = read_job_scene(settings, job);
    refuse_guesses(scene, settings.arguments);
    const bool drawing = settings.template_file.empty() && !is_scene(job.file);
    record.mode = settings.contacts_only || drawing ? "contacts" : "analysis";
    record.title = scene.title;
    record.length_unit = scene.length_unit;
    record.force_unit = scene.force_unit;
    record.parts = static_cast<int>(scene.parts.size());
    if (record.mode == "contacts")
        detect_job(settings, job, scene, folder, record);
    else
        analyze_job(settings, scene, folder, watch, record);
    return record;
}

}  // namespace abut
