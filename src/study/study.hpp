// SPDX-License-Identifier: GPL-3.0-or-later
// What accuracy costs in time: one scene solved at many settings, each with its error, its time by stage and its memory.
#pragma once
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/results/result.hpp"

namespace abut {

/// The word in place of a level, where the scene gives its grids or its cell size: there is nothing that a level could change.
inline constexpr const char* level_as_given = "as given";
/// A level of a study's own, that the others are compared with where no closed form is known.
inline constexpr const char* level_reference = "a fifth of fine";

/// The word in place of a basis for runs by the dissertation's method (dissertation_method.hpp), which has one of its own.
inline constexpr const char* basis_of_dissertation = "dissertation";

/// How one run of a study solves the scene.
struct StudySetting {
    enum class Kind {
        level,    ///< as `abut analyze` does: grids that follow the contacts, by the accuracy level
        graded,   ///< one solution on given grids, graded as those that the level "standard" ended with
        uniform,  ///< one solution on equal cells
    };
    Kind kind = Kind::level;
    std::string level{};        ///< of Kind::level: "draft", "standard", "fine", level_as_given, level_reference
    int degree = 2;             ///< levels: the scene's own, as is the basis
    std::string basis = "web";  ///< "web", "normalized", basis_of_dissertation
    double size = 1;            ///< cell size over that of the grids of "standard"; uniform: over that of as many equal cells

    int threads = 1;  ///< at most so many

    bool operator==(const StudySetting&) const = default;
};

/// The seconds by stage, in the order of study_stages.
using StageSeconds = std::array<double, 8>;
/// The stages. import: reading the scene; geometry to recovery: Result::stages; report: making the texts of all files, not
/// writing them; other: what none of these holds (plan, mobility, checks, condition number).
inline constexpr std::array<const char*, 8> study_stages{"import",  "geometry", "assembly", "factorisation",
                                                         "contact", "recovery", "report",   "other"};

/// What one run of a study came to.
struct StudyRun {
    StudySetting setting;
    enum class Status { ok, failed, skipped } status = Status::ok;
    std::string message{};  ///< why it failed or was skipped; of one that was solved, why there is no error
    std::string reasons{};  ///< not to take a solved one as it is (verdict.hpp)
    int repeats = 0;        ///< solved so many times; seconds are medians
    int unknowns = 0, multipliers = 0;
    std::array<int, 3> cells{0, 0, 0};      ///< inner, boundary, outer
    StageSeconds stage{};                   ///< medians of each
    double solver_seconds = 0;              ///< wall time: geometry, assembly, factorisation, contact
    double seconds = 0, cpu_seconds = 0;    ///< all stages: wall time, and processor time of all threads
    double peak_bytes = 0;                  ///< largest resident size of the process that solved it; 0: not known
    std::optional<double> estimated_error;  ///< the analysis' own: of the pressure, without contact of the energy
    std::vector<PassSummary> passes;        ///< of Kind::level
    std::vector<double> error;              ///< by measure, relative; NaN: not known
};

/// A quantity by which runs are judged.
struct StudyMeasure {
    std::string what;
    bool held = false;  ///< every run has it but for rounding: it says nothing about accuracy
};

/// A scene at many settings.
struct Study {
    std::string title, file;
    std::string reference;             ///< what errors are against, in words
    std::optional<int> reference_run;  ///< the run that the others are compared with, which has no error of its own
    std::vector<StudyMeasure> measures;
    std::vector<StudyRun> runs;
    double budget = 0, seconds = 0;
    std::vector<std::string> notes;  ///< what the reader must know of this study: what was left out, and why
};

/// The choices of a study.
struct StudyOptions {
    int threads = 0;     ///< of the levels' second runs; 0: one for each processor; 1: there are none
    double budget = 60;  ///< seconds of wall time; runs that would not fit are skipped, those that do not end are stopped
    double repeated_seconds = 0.5;  ///< runs shorter than this are repeated until they fill it, some times at most
    std::string data_folder{};      ///< with the scenes of the verification problems; empty: no closed forms
    /// The degrees and sizes of the runs on given grids. Sizes from large to small, so that what a budget leaves out is the
    /// finest.
    std::vector<int> degrees{1, 2, 3, 4};
    std::vector<double> sizes{4, 2.8, 2, 1.4, 1, 0.7, 0.5};
    std::function<void(const std::string&)> progress{};  ///< told what is being done; may be empty
};

/// Runs a study. Every run is a process of its own (memory, and an end where it takes too long). Throws InputError where the
/// scene cannot be read or analysed for a reason that lies in its text. The same scene gives the same runs and errors, but for
/// what the budget leaves out.
Study run_study(const std::string& scene_path, const StudyOptions& options);

/// A setting in words: "standard", "degree 2, cells x 0.7", "degree 2, normalized, cells x 0.7", "degree 2, equal cells x 1".
std::string setting_text(const StudySetting& setting);

std::string study_html(const Study& study);  ///< one page, no network
std::string study_csv(const Study& study);   ///< a line for each run
std::string study_json(const Study& study);
std::string study_table(const Study& study);  ///< what `abut study` prints

}  // namespace abut
