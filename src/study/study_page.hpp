// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of study.html. Each is HTML made from the study alone.
#pragma once
#include <string>
#include <vector>

#include "src/study/study_chart.hpp"
#include "src/study/study_prices.hpp"

namespace abut::report {

/// A number of a run for a chart's axis.
struct RunValue {
    std::function<double(const StudyRun&)> value;
    std::string (*text)(double);
    std::string title;
};
/// The number of unknowns of a run, for a chart's axis.
RunValue unknowns_of_run();
std::vector<ChartSeries> study_series(const Study& study, const RunValue& x, const RunValue& y);

/// What the colours, marks and dashes of all charts mean.
std::string study_legend(const Study& study);

/// Shares of the stages in levels, degrees and cell sizes, stacked.
std::string stages_section(const Study& study);

/// Error against time and unknowns, cheapest settings and prices, for each quantity; the reader chooses which.
std::string errors_section(const Study& study);

std::string growth_section(const Study& study);  ///< time and memory against unknowns
std::string runs_section(const Study& study);    ///< every run, also those that failed or were left out

}  // namespace abut::report
