// SPDX-License-Identifier: GPL-3.0-or-later
// What an error costs: families of runs that differ in cell size alone, and what follows from their errors and times.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "src/study/study.hpp"

namespace abut {

/// Runs that differ in cell size (or level) alone, those that were solved, from few unknowns to many.
struct StudyFamily {
    StudySetting like;  ///< of its first run
    std::string name;   ///< "levels", "degree 2", "degree 2, normalized", "equal cells"
    std::vector<std::size_t> runs;
};
std::vector<StudyFamily> families_of(const Study& study);
std::string family_name(const StudySetting& setting);

/// The largest error of each run and of the runs of its family with more unknowns. An error may pass through zero by chance;
/// this one does not. NaN where the run has no error.
std::vector<double> kept_errors(const Study& study, std::size_t measure);

/// The settings that reach an error, and keep it with smaller cells, in the least solver time.
struct CheapestSetting {
    double error = 0;
    std::optional<std::size_t> level;  ///< index of the run among the levels: the whole way, from nothing known
    std::optional<std::size_t> grid;   ///< among those on one given grid, which somebody has to know
};
/// The cheapest settings for errors of 20, 10, 5, 2, 1 % ... as far as any run reaches.
std::vector<CheapestSetting> cheapest_settings(const Study& study, std::size_t measure);

/// What half the error costs along a family: time as a power of the error, by least squares of log time over log error.
struct PriceOfHalving {
    StudySetting like;  ///< of the family's first run
    std::string family;
    double factor = 0;  ///< of solver time for half the error
    double first_error = 0, last_error = 0;
    double first_seconds = 0, last_seconds = 0;
};
/// The prices of the families whose error falls from their first run to their last by a factor of two at least, and that have
/// three runs with errors.
std::vector<PriceOfHalving> prices_of_halving(const Study& study, std::size_t measure);

/// The exponent of solver time over unknowns, by least squares over a family's runs; unset with fewer than three.
std::optional<double> time_exponent(const Study& study, const StudyFamily& family);

/// The measure that tables and sentences are about: the first that is not held.
std::optional<std::size_t> main_measure(const Study& study);

/// The study in sentences.
std::vector<std::string> study_sentences(const Study& study, std::size_t measure);

/// A duration in words: "0.81 ms", "45 ms", "1.2 s", "120 s".
std::string duration_text(double seconds);
/// A count for axes: "0.8k", "14k", "1.2M".
std::string count_text(double count);
/// A size of memory in words: "26 MB", "1.2 GB".
std::string memory_text(double bytes);

}  // namespace abut
