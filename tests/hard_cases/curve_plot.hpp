// SPDX-License-Identifier: GPL-3.0-or-later
// The curves of sweeps as CSV tables and as SVG pictures with logarithmic axes.
#pragma once
#include <string>
#include <vector>

#include "geometry/curves/vec2.hpp"

namespace abut::test {

using geometry::Vec2;

/// Where sweeps write to: the environment's ABUT_SWEEP_DIR, else "sweeps" beside the test binary. Made if need be.
std::string sweep_folder();

struct Table {
    std::vector<std::string> columns;
    std::vector<std::vector<double>> rows;
    std::vector<std::string> labels;  ///< of the rows, first column "case"; empty: none
};
/// Writes folder/name.csv; numbers with eight digits, so that a file can be compared.
void write_csv(const std::string& name, const Table& table);

/// One curve; points by their values, not their logarithms, in the order drawn.
struct PlotSeries {
    std::string name, color;
    std::vector<Vec2> points;
    std::vector<Vec2> band{};  ///< (low, high) at each point: drawn shaded; empty: none
    bool with_marks = false, dashed = false;
};
struct PlotPanel {
    std::string title;
    std::vector<PlotSeries> series;
    std::vector<std::string> notes{};  ///< small print at the bottom, inside, by line
};
struct LogPlot {
    std::string title, x_label, y_label;
    Vec2 x_range, y_range;  ///< powers of ten, exponents
    std::vector<PlotPanel> panels;
    int columns = 2;
};
/// The picture's text; one that stands alone. Series of the same name have one entry in the legend.
std::string log_plot_svg(const LogPlot& plot);
/// Writes folder/name.svg.
void write_plot(const std::string& name, const LogPlot& plot);

}  // namespace abut::test
