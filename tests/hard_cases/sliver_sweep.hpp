// SPDX-License-Identifier: GPL-3.0-or-later
// A part moved through its grid, or the grid through the part, so that cut fractions run from 1 to 1e-12 and below.
#pragma once
#include <vector>

#include "tests/hard_cases/part_problem.hpp"
#include "tests/hard_cases/shapes.hpp"

namespace abut::test {

/// Places of the grid: a quarter of them spread evenly over one cell; of the others the lines come as near to the part's
/// vertices and extreme points as 1 to 1e-13 of a cell, evenly in the logarithm, from both sides: in x, in y, and in both.
std::vector<Vec2> sweep_offsets(const geometry::Part& part, double h, int n);

/// The shape with a smooth field and exact tractions; with Hold::nitsche a support on one edge.
PartProblem sweep_problem(const SweptShape& shape, int degree, solver::Basis basis, Hold hold);
inline constexpr double sweep_cell = 0.17;

struct SweepCurve {
    std::vector<Vec2> offsets;
    std::vector<PartAnswer> answers;  ///< by offset

    int failures() const;
    double smallest_fraction() const;
    /// Of those that could be solved.
    double median(double PartAnswer::*value) const;
    /// Largest value over the median.
    double worst_ratio(double PartAnswer::*value) const;
};
SweepCurve sweep(const SweptShape& shape, int degree, solver::Basis basis, Hold hold, int n);

/// Median of a value over the answers whose smallest fraction is within [low, high).
double median_within(const SweepCurve& curve, double PartAnswer::*value, double low, double high);

/// Curves of one shape in one folder: sliver_sweep_<shape>.csv with every step, and a picture of the condition numbers.
struct NamedCurve {
    int degree;
    solver::Basis basis;
    Hold hold;
    SweepCurve curve;
};
void write_sweep(const SweptShape& shape, const std::vector<NamedCurve>& curves);

}  // namespace abut::test
