// SPDX-License-Identifier: GPL-3.0-or-later
// Univariate B-splines on clamped, non-uniform knots.
#pragma once
#include <array>
#include <vector>

namespace abut::solver {

inline constexpr int max_degree = 6;
/// Values of the at most max_degree + 1 functions that live on one interval.
using LocalValues = std::array<double, max_degree + 1>;

/// The knots that the functions of one interval depend on: those before and after the one at `start`, with which the interval
/// [start[0], start[1]] begins; start[1 - p] to start[p] count, for degree 0 the interval's two. Function k of the interval, 0
/// to p, has the inner knots start[k + 1 - p] to start[k].
struct IntervalKnots {
    int degree;
    const double* start;

    double low() const { return start[0]; }
    double high() const { return start[1]; }
    const double* inner_knots(int k) const { return start + k + 1 - degree; }
};

/// A knot vector of degree p over breakpoints x_0 < ... < x_n, inner knots of multiplicity m: C^(p-m) there. On the interval
/// [x_i, x_i+1] live the functions first[i] to first[i] + p. Clamped: the ends are repeated p + 1 times, and only function 0
/// (the last) is not zero at x_0 (x_n).
struct KnotVector {
    int degree;
    std::vector<double> breakpoints;
    std::vector<double> knots;
    std::vector<int> first;  ///< function of each interval

    int n_intervals() const { return static_cast<int>(breakpoints.size()) - 1; }
    int n_functions() const { return static_cast<int>(knots.size()) - degree - 1; }
    IntervalKnots interval(int i) const { return {degree, knots.data() + first[static_cast<std::size_t>(i)] + degree}; }
};

/// Clamped knots, the inner ones simple.
KnotVector clamped_knots(std::vector<double> breakpoints, int degree);
/// Clamped knots of given multiplicity of every breakpoint, 1 to p for the inner ones; those of the ends are not read.
KnotVector clamped_knots(std::vector<double> breakpoints, int degree, const std::vector<int>& multiplicity);

/// Knots over breakpoints that span one period: beyond its ends they go on as they begin and end. Functions i and i + n are
/// then one periodic function; nothing is special about the seam.
KnotVector periodic_knots(std::vector<double> breakpoints, int degree);
/// Periodic knots of given multiplicity, 1 to p, of every breakpoint but the last, which is the first one again.
KnotVector periodic_knots(std::vector<double> breakpoints, int degree, const std::vector<int>& multiplicity);

/// The intervals [begin, end) on which a function lives.
struct IntervalRange {
    int begin, end;
};
IntervalRange support(const KnotVector& knots, int i);

/// The interval that holds x; the last for the right end, the nearest for points outside.
int interval_of(const KnotVector& knots, double x);
/// The length of that interval.
double spacing_at(const KnotVector& knots, double x);

/// The values (and first derivatives) at x of the functions of an interval; x may lie outside of it: the polynomials are
/// continued.
void evaluate(const IntervalKnots& knots, double x, LocalValues& values);
void evaluate(const IntervalKnots& knots, double x, LocalValues& values, LocalValues& derivatives);
inline void evaluate(const KnotVector& knots, int interval, double x, LocalValues& values) {
    evaluate(knots.interval(interval), x, values);
}
inline void evaluate(const KnotVector& knots, int interval, double x, LocalValues& values, LocalValues& derivatives) {
    evaluate(knots.interval(interval), x, values, derivatives);
}

/// The abscissa of function i: the mean of its inner knots; the coefficients of the function x (Greville). Degree 0: the
/// middle. Likewise of function k of an interval.
double greville(const KnotVector& knots, int i);
double greville(const IntervalKnots& knots, int k);

/// The knots of level l of a hierarchy around the interval i there, whose intervals are those of `base` halved l times: old
/// knots as often as they are there, new ones once. 2 max(1, p) numbers, the interval's begin in their middle at [max(1, p) -
/// 1]. Clamped bases only.
std::vector<double> level_knots(const KnotVector& base, int level, int interval);
/// Which function of its level is the first of an interval; over all intervals it ascends.
int level_first(const KnotVector& base, int level, int interval);

/// The knots of the derivatives: one degree less, smooth across a knot to one order less.
KnotVector derivative_knots(const KnotVector& knots);

/// The blossom of the polynomials of an interval's functions at p arguments: what these functions' coefficients are multiplied
/// by in the coefficient of the B-spline whose inner knots the arguments are.
LocalValues blossom(const IntervalKnots& knots, const double* arguments);

/// The polynomial pieces of an interval's functions, continued over the whole line, have B-spline coefficients everywhere:
/// those for function j, one for each function of the interval, are the blossom at j's inner knots. This is the extension of
/// [Grishin10, eqs 3.16-3.17] (Hoellig) on non-uniform knots.
LocalValues extension_coefficients(const KnotVector& knots, int interval, int j);

/// Knot insertion: rows of the matrix that takes coefficients over `coarse` to those of the same function over `fine`, whose
/// knots hold all of the coarse ones. Row j: coefficient of the coarse functions first + k in the fine function j (Oslo
/// algorithm, by blossoms).
struct RefinedCoefficient {
    int first;
    LocalValues value;
};
std::vector<RefinedCoefficient> refinement(const KnotVector& coarse, const KnotVector& fine);

}  // namespace abut::solver
