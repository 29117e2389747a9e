// SPDX-License-Identifier: GPL-3.0-or-later
// Arc lengths of one ellipse or spline, tabulated for many inversions: 1 microsecond each, without 12.
#pragma once
#include <vector>

#include "geometry/curves/curve.hpp"

namespace abut::geometry {

/// Parameters from 0 to 1 and the arc lengths up to them, so close that one Gauss rule between neighbours is exact to rounding.
struct LengthTable {
    std::vector<double> t, s;
    std::vector<double> rate{};  ///< dt/ds there: for the first guess
};

/// Makes the table of an ellipse or a spline.
LengthTable length_table(const Curve& curve);

/// Parameter at arc length s, by safeguarded Newton between two entries; 0 below and 1 above the table.
double parameter_at_length(const Curve& curve, const LengthTable& table, double s);

}  // namespace abut::geometry
