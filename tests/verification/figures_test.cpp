// SPDX-License-Identifier: GPL-3.0-or-later
// `abut verify dissertation --figures`: which files there are, and that they show the answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "src/verification/verify_figures.hpp"
#include "tests/src/io/xml_fault.hpp"

namespace abut::figures_test {
namespace {

using abut_tests::fault_of_xml;

const std::string data = ABUT_SOURCE_DIR "/data";

/// A table with the column of the dissertation's method alone.
DissertationTable as_written(const std::string& name) {
    for (DissertationTable& table : dissertation_tables()) {
        if (table.name != name) continue;
        for (std::size_t k = 0; k < n_ours; ++k)
            if (k != static_cast<std::size_t>(Ours::written)) table.runs[k].reset();
        return table;
    }
    throw std::out_of_range(name);
}

std::map<std::string, std::string> by_file(const std::vector<Figure>& figures) {
    std::map<std::string, std::string> files;
    for (const Figure& figure : figures) {
        EXPECT_EQ(fault_of_xml(figure.svg), "") << figure.file;
        EXPECT_TRUE(files.emplace(figure.file, figure.svg).second) << figure.file;
    }
    return files;
}

/// Highest places (least y) of the picture's curves of more than two points.
std::vector<double> tops_of_curves(const std::string& svg) {
    std::vector<double> tops;
    const std::string begin = " points=\"";
    for (std::size_t at = svg.find(begin); at != std::string::npos; at = svg.find(begin, at + 1)) {
        std::string points = svg.substr(at + begin.size(), svg.find('"', at + begin.size()) - at - begin.size());
        std::replace(points.begin(), points.end(), ',', ' ');
        std::istringstream numbers(points);
        std::vector<double> y;
        for (double a, b; numbers >> a >> b;) y.push_back(b);
        if (y.size() > 2) tops.push_back(*std::min_element(y.begin(), y.end()));
    }
    return tops;
}

TEST(DissertationFigures, OfAContactShowItsPressureBesideTheReference) {
    const SolvedTable solved = solve_table(as_written("B"), data);
    const auto files = by_file(answer_figures(solved));
    ASSERT_EQ(files.size(), 4U);
    for (const char* file : {"B_stress.svg", "B_displacement.svg", "B_deformed.svg"}) ASSERT_TRUE(files.contains(file)) << file;
    const std::vector<double> tops = tops_of_curves(files.at("B_pressure.svg"));
    ASSERT_EQ(tops.size(), 2U) << "Hertz, and the method as it was written";
    // Both from the axis at y = 400 upwards; the method's peak is 3355.7 of 3454.9.
    double peak = 0;
    const Result& answer = *solved.answers[static_cast<std::size_t>(Ours::written)];
    for (double pressure : answer.contacts.front().profile.pressure) peak = std::max(peak, pressure);
    EXPECT_NEAR((400 - tops[1]) / (400 - tops[0]), peak / solved.table.pressure->pressure(0), 2e-3);
}

TEST(DissertationFigures, OfABeamHaveNoPressure) {
    const auto files = by_file(answer_figures(solve_table(as_written("beam"), data)));
    EXPECT_EQ(files.size(), 3U);
    EXPECT_FALSE(files.contains("beam_pressure.svg"));
}

TEST(DissertationFigures, OfAnAnswerThatFailedAreNone) {
    DissertationTable table = as_written("vise");
    table.runs[static_cast<std::size_t>(Ours::written)] = VerifyRun{"verification/slope.json"};
    EXPECT_TRUE(answer_figures(solve_table(table, data)).empty());
}

TEST(DissertationFigures, OfTheMethodShowCellsWeightsAndTheSearch) {
    const auto files = by_file(method_figures(as_written("B"), data));
    EXPECT_EQ(files.size(), 3U);
    for (const char* file : {"B_grid.svg", "B_weights.svg", "B_search.svg"}) EXPECT_TRUE(files.contains(file)) << file;
}

}  // namespace
}  // namespace abut::figures_test
