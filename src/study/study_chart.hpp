// SPDX-License-Identifier: GPL-3.0-or-later
// Curves on two logarithmic axes.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace abut::report {

enum class Mark { disc, square, triangle, diamond, cross };

/// A point of a curve.
struct ChartPoint {
    double x = 0, y = 0;  ///< above zero; others are left out
    std::string title;    ///< shown where the pointer rests on it
    std::string label{};  ///< written beside it
};

/// A curve: its points, marks and line.
struct ChartSeries {
    std::string label;  ///< written at the last point's side
    std::string color;
    Mark mark = Mark::disc;
    bool hollow = false;      ///< marks with a white middle
    std::string dashes{};     ///< of the line, as SVG takes them; empty: solid
    double line_width = 1.6;  ///< 0: no line
    std::vector<ChartPoint> points;
};

/// A chart with its axes' texts and its curves.
struct LogChart {
    std::string title;  ///< for those who cannot see it
    std::string x_title, y_title;
    std::function<std::string(double)> x_text, y_text;  ///< of ticks
    std::vector<ChartSeries> series;                    ///< later ones are drawn above
};

/// The values at which a logarithmic axis is marked: 1, 10, 100 where it spans three decades or more; 1, 2, 5 in less.
std::vector<double> log_ticks(double low, double high);

/// An SVG of the report's half width; empty without two different points.
std::string log_chart(const LogChart& chart);

/// A line with a mark, as wide as a word of a legend.
std::string series_sign(const ChartSeries& series);

}  // namespace abut::report
