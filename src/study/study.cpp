// SPDX-License-Identifier: GPL-3.0-or-later
// The walk of a study: levels, their grids at other sizes, degrees and bases, errors of all of them.
#include "src/study/study.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "solver/linear_algebra/blas_threads.hpp"
#include "src/io/number_text.hpp"
#include "src/scene/dissertation_method.hpp"
#include "src/scene/read_scene.hpp"
#include "src/study/study_plan.hpp"
#include "src/study/study_prices.hpp"
#include "src/study/study_reference.hpp"

namespace abut {

namespace {

using Clock = std::chrono::steady_clock;
using Kind = StudySetting::Kind;
using Status = StudyRun::Status;

/// A quantity whose errors are all below this is no matter of accuracy (forces that statics alone decides).
constexpr double held_error = 1e-6;
/// Runs on one thread that last longer than this times the processor time they use share the processor with other programs.
constexpr double busy_factor = 1.3;
/// At the end of a quantity's name where `verify` compares it otherwise than a study does.
constexpr const char* absolute_note = " (error absolute)";
/// Where no closed form is known, the reference may take this part of the budget.
constexpr double reference_share = 0.4;

/// A study on its way.
class Course {
public:
    Course(const std::string& path, const Scene& scene, const StudyOptions& options)
        : path_(path), scene_(scene), options_(options), known_(known_problem(path, scene, options.data_folder)) {}

    Study all();

private:
    double left() const { return options_.budget - std::chrono::duration<double>(Clock::now() - begin_).count(); }
    void run(const StudySetting& setting, double limit);
    void skip(const StudySetting& setting, const std::string& why);
    void run_levels(const std::vector<StudySetting>& settings);
    void run_reference();
    void run_grids();
    void fill_errors();
    void name_reference();
    void add_notes();

    const std::string path_;
    const Scene& scene_;
    const StudyOptions& options_;
    const VerifyProblem* known_;
    const int threads_ = solver::usable_threads(options_.threads);
    const Clock::time_point begin_ = Clock::now();
    Study study_;
    std::vector<StudyMeasured> measured_;  // parallel to study_.runs; skipped ones hold nothing
    std::vector<StudyGrid> grids_;         // of "standard"
    double equal_size_ = 0;
};

void Course::run(const StudySetting& setting, double limit) {
    if (options_.progress)
        options_.progress(setting_text(setting) + ", run " + std::to_string(study_.runs.size() + 1) + ", " +
                          number_text(std::max(0.0, std::round(left())), 3) + " s left");
    measured_.push_back(measure({path_, setting, &grids_, equal_size_, known_, options_.repeated_seconds}, limit));
    study_.runs.push_back(measured_.back().run);
}

void Course::skip(const StudySetting& setting, const std::string& why) {
    StudyRun run;
    run.setting = setting;
    run.status = Status::skipped;
    run.message = why;
    study_.runs.push_back(run);
    measured_.emplace_back();
}

/// The first level's grids are those of the whole study; where it fails, those of the next one that does not.
void Course::run_levels(const std::vector<StudySetting>& settings) {
    for (const StudySetting& setting : settings) {
        if (left() <= 0) {
            skip(setting, "nothing was left of the budget");
            continue;
        }
        run(setting, left());
        const StudyMeasured& m = measured_.back();
        if (!m.problems.empty()) throw InputError(m.problems);
        if (grids_.empty()) grids_ = m.grids;
    }
    if (!grids_.empty()) equal_size_ = equal_cell_size(scene_, grids_);
}

void Course::run_reference() {
    if (known_ || grids_.empty()) return;
    const double limit = reference_share * left();
    const StudySetting reference = reference_setting(scene_, options_);
    if (reference.kind == Kind::level) return run(reference, limit);
    // grids at its size have more cells by its square, and those of size 1 are among the runs
    const auto base =
        std::find_if(study_.runs.begin(), study_.runs.end(), [](const StudyRun& r) { return r.status == Status::ok; });
    StudyRun like = *base;
    like.setting = reference;
    like.setting.size = 1;
    const double predicted = *predicted_seconds({like}, reference);
    if (predicted > limit)
        skip(reference, "it would take about " + duration_text(predicted) + ", more than its share of the budget");
    else
        run(reference, limit);
}

void Course::run_grids() {
    if (grids_.empty()) return;
    for (const StudySetting& setting : grid_settings(scene_, options_)) {
        const std::optional<double> predicted = predicted_seconds(study_.runs, setting);
        if (left() <= 0)
            skip(setting, "nothing was left of the budget");
        else if (predicted && *predicted > left())
            skip(setting, "it would take about " + duration_text(*predicted) + ", and " + duration_text(left()) +
                              " of the budget were left");
        else
            run(setting, left());
    }
}

/// The reference that was asked for; where it was not solved the run with most unknowns among those whose basis bears any grid.
std::optional<std::size_t> finest_run(const std::vector<StudyRun>& runs, const std::string& basis) {
    std::optional<std::size_t> finest;
    for (std::size_t i = 0; i < runs.size(); ++i)
        if (runs[i].status == Status::ok && runs[i].setting.level == level_reference) return i;
    for (std::size_t i = 0; i < runs.size(); ++i)
        if (runs[i].status == Status::ok && runs[i].setting.basis == basis && runs[i].setting.degree > 1 &&
            runs[i].setting.kind != Kind::uniform && (!finest || runs[i].unknowns > runs[*finest].unknowns))
            finest = i;
    return finest;
}

void Course::fill_errors() {
    std::optional<std::size_t> finest;
    if (known_) {
        for (const Quantity& q : known_->quantities) study_.measures.push_back({q.what.substr(0, q.what.find(absolute_note))});
    } else if ((finest = finest_run(study_.runs, is_by_dissertation(scene_) ? basis_of_dissertation : "web"))) {
        study_.reference_run = static_cast<int>(*finest);
        study_.measures = measures_of(measured_[*finest].answer);
    }
    for (std::size_t i = 0; i < study_.runs.size(); ++i) {
        StudyRun& run = study_.runs[i];
        run.error.assign(study_.measures.size(), std::numeric_limits<double>::quiet_NaN());
        if (run.status != Status::ok || finest == i) continue;
        run.error = known_ ? measured_[i].known_error : differences(measured_[i].answer, measured_[*finest].answer);
        if (std::isnan(run.error.front())) run.message = "its contacts are not those that the reference has";
    }
    for (std::size_t k = 0; k < study_.measures.size(); ++k)
        study_.measures[k].held =
            std::all_of(study_.runs.begin(), study_.runs.end(), [k](const StudyRun& r) { return !(r.error[k] > held_error); });
}

void Course::name_reference() {
    if (known_)
        study_.reference = "the known answer of verification problem " + known_->name + " (" + known_->about + ")";
    else if (study_.reference_run)
        study_.reference =
            "the reference run (" + setting_text(study_.runs[static_cast<std::size_t>(*study_.reference_run)].setting) + ")";
}

/// Wall time over processor time of all runs on one thread.
double wall_over_processor(const std::vector<StudyRun>& runs) {
    double wall = 0, processor = 0;
    for (const StudyRun& run : runs)
        if (run.status == Status::ok && run.setting.threads == 1) {
            wall += run.seconds;
            processor += run.cpu_seconds;
        }
    return processor > 0 ? wall / processor : 1;
}

void Course::add_notes() {
    if (const double factor = wall_over_processor(study_.runs); factor > busy_factor)
        study_.notes.push_back("The machine was busy with other programs: runs took " + number_text(factor, 2) +
                               " times the processor time that they used. Times are too long by about that, and uneven; "
                               "errors and memory are not touched by it.");
    if (study_.reference_run)
        study_.notes.push_back(
            "No closed form is known for this scene. Errors are differences from the reference run: those of runs that are as "
            "fine come out wrong, and an error that all runs share is not seen.");
    const std::string doubts = study_.reference_run ? study_.runs[static_cast<std::size_t>(*study_.reference_run)].reasons : "";
    if (!doubts.empty())
        study_.notes.push_back("The reference run is solved, but: " + doubts +
                               ". What has no limit differs from it by any amount, on finer grids, too.");
    if (options_.threads != 1 && threads_ == 1)
        study_.notes.push_back(
            "No runs with threads: there is one processor, or the linear algebra library may not be called from several "
            "threads.");
    if (grids_.empty()) study_.notes.push_back("No level gave an answer, so that there are no grids to study.");
}

Study Course::all() {
    study_.title = scene_.title;
    study_.file = path_;
    study_.budget = options_.budget;
    run_levels(level_settings(scene_));
    run_levels(threaded_settings(scene_, threads_));
    run_reference();
    run_grids();
    fill_errors();
    name_reference();
    add_notes();
    study_.seconds = options_.budget - left();
    return std::move(study_);
}

}  // namespace

std::string setting_text(const StudySetting& setting) {
    if (setting.kind == Kind::level)
        return setting.level + (setting.threads > 1 ? ", " + std::to_string(setting.threads) + " threads" : "");
    if (setting.kind == Kind::uniform) return "equal cells x " + number_text(setting.size, 2);
    return "degree " + std::to_string(setting.degree) + (setting.basis == "web" ? "" : ", " + setting.basis) + ", cells x " +
           number_text(setting.size, 2);
}

Study run_study(const std::string& scene_path, const StudyOptions& options) {
    const Scene scene = read_scene(scene_path);
    return Course(scene_path, scene, options).all();
}

}  // namespace abut
