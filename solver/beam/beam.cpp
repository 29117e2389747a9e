// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/beam/beam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/linear_algebra/dense.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double unit = std::numeric_limits<double>::epsilon();

/// A function's value and its first two derivatives.
struct Jet {
    double value = 0, slope = 0, curvature = 0;
};
Jet operator*(const Jet& a, const Jet& b) {
    return {a.value * b.value, a.slope * b.value + a.value * b.slope,
            a.curvature * b.value + 2 * a.slope * b.slope + a.value * b.curvature};
}
Jet operator*(double a, const Jet& b) {
    return {a * b.value, a * b.slope, a * b.curvature};
}
Jet operator+(const Jet& a, const Jet& b) {
    return {a.value + b.value, a.slope + b.slope, a.curvature + b.curvature};
}
Jet constant(double c) {
    return {c, 0, 0};
}

int values_held(const BeamHold& hold) {
    return hold.end == BeamEnd::clamped ? 2 : hold.end == BeamEnd::pinned ? 1 : 0;
}
int values_held(const Beam& beam) {
    return values_held(beam.holds[0]) + values_held(beam.holds[1]);
}

double length(const Beam& beam) {
    return beam.end - beam.begin;
}

Jet power(const Jet& t, int exponent) {
    return exponent == 0 ? constant(1) : exponent == 1 ? t : t * t;
}

/// s: distance from begin over the length, t: from the end.
Jet weight(const Beam& beam, const Jet& s, const Jet& t) {
    const int a = values_held(beam.holds[0]), b = values_held(beam.holds[1]);
    return (a == 2 ? 0.5 : 1) * power(s, a) * ((b == 2 ? 0.5 : 1) * power(t, b));
}

/// phi = taylor + s^a (c + d (s - 1)); taylor holds what begin prescribes.
Jet prescribed(const Beam& beam, const Jet& s) {
    const double l = length(beam);
    const auto& [begin, end] = beam.holds;
    const int a = values_held(begin), b = values_held(end);
    const double v = a > 0 ? begin.deflection : 0, g = a > 1 ? begin.slope * l : 0;
    const double c = b > 0 ? end.deflection - (v + g) : 0, d = b > 1 ? end.slope * l - g - a * c : 0;
    return constant(v) + g * s + power(s, a) * (constant(c - d) + d * s);
}

/// The piece of an interval inside the beam.
struct Span {
    int interval;
    double begin, end;
    bool is_cut;  ///< the beam does not fill the interval
};

/// Coordinates closer than this are the same but for rounding.
double grid_rounding(const Beam& beam) {
    return grid_line_units * unit * std::max(std::abs(beam.begin), std::abs(beam.end));
}

std::vector<Span> spans_of(const Beam& beam) {
    const double rounding = grid_rounding(beam);
    std::vector<Span> spans;
    for (int k = 0; k < beam.knots.n_intervals(); ++k) {
        const double left = beam.knots.breakpoints[static_cast<std::size_t>(k)];
        const double right = beam.knots.breakpoints[static_cast<std::size_t>(k) + 1];
        const double a = std::max(left, beam.begin), b = std::min(right, beam.end);
        if (b - a > rounding) spans.push_back({k, a, b, a - left > rounding || right - b > rounding});
    }
    return spans;
}

/// The span that holds x; beside all, for what rounding left out, the nearest.
const Span& span_at(const std::vector<Span>& spans, double x) {
    for (const Span& s : spans)
        if (x < s.end) return s;
    return spans.back();
}

/// The functions of one span, in distances from its beginning: coordinates would leave little but rounding of the distances in
/// a sliver.
struct SpanFunctions {
    const Beam& beam;
    KnotVector knots,
        lower;  ///< of this interval alone; lower: the same knots, one degree less, without its outermost functions
    double from_begin, to_end;  ///< distances of the span's beginning from the beam's ends

    SpanFunctions(const Beam& of, const Span& span)
        : beam(of), knots{of.knots.degree, {}, {}, {0}}, from_begin(span.begin - of.begin), to_end(of.end - span.begin) {
        const int first = of.knots.first[static_cast<std::size_t>(span.interval)];
        for (int k = first; k < first + 2 * (knots.degree + 1); ++k)
            knots.knots.push_back(of.knots.knots[static_cast<std::size_t>(k)] - span.begin);
        lower = {knots.degree - 1, {}, knots.knots, {1}};
    }

    Jet along(double x) const { return {(from_begin + x) / length(beam), 1 / length(beam), 0}; }
    Jet prescribed_at(double x) const { return prescribed(beam, along(x)); }

    /// w N
    std::array<Jet, max_degree + 1> at(double x) const {
        const int p = knots.degree;
        LocalValues value, slope, lower_value, lower_slope;
        evaluate(knots, 0, x, value, slope);
        evaluate(lower, 0, x, lower_value, lower_slope);
        const double* t = knots.knots.data() + p;
        const Jet w = weight(beam, along(x), {(to_end - x) / length(beam), -1 / length(beam), 0});
        std::array<Jet, max_degree + 1> result;
        double previous = 0;  // N_i'' = p (N_{i,p-1}' / (t_{i+p} - t_i) - N_{i+1,p-1}' / (t_{i+p+1} - t_{i+1}))
        for (int r = 0; r <= p; ++r) {
            const auto i = static_cast<std::size_t>(r);
            const double next = r < p ? p * lower_slope[i] / (t[r + 1] - t[r + 1 - p]) : 0.0;
            result[i] = w * Jet{value[i], slope[i], previous - next};
            previous = next;
        }
        return result;
    }
};

bool rule_is_exact(const LineRule& rule, int degree) {
    double sum = 0;
    for (std::size_t q = 0; q < rule.points.size(); ++q) sum += rule.weights[q] * std::pow(rule.points[q], degree);
    return std::abs(sum - 1.0 / (degree + 1)) <= rule_rounding;
}

/// Whether slopes jump at a knot.
bool has_hinge(const KnotVector& knots) {
    for (std::size_t k = 1; k < knots.first.size(); ++k)
        if (knots.first[k] - knots.first[k - 1] >= knots.degree) return true;
    return false;
}

/// Why there is no system; empty: there is one.
std::string fault_of(const Beam& beam, const BeamLoad& load) {
    const double rounding = grid_rounding(beam);
    const auto& lines = beam.knots.breakpoints;
    const int p = beam.knots.degree;
    if (p < 2 || p > max_degree) return "a beam takes splines of degree 2 to 6, not " + std::to_string(p);
    if (has_hinge(beam.knots)) return "a knot of multiplicity p would be a hinge";
    if (!(length(beam) > 2 * rounding)) return "the beam has no length";
    if (!(beam.rigidity > 0)) return "the beam's rigidity is not positive";
    if (beam.begin < lines.front() - rounding || beam.end > lines.back() + rounding) return "the beam leaves its grid";
    if (values_held(beam) < 2) return "nothing resists a rigid motion of the beam: two values have to be held";
    if (!rule_is_exact(beam.rule, 2 * (p + values_held(beam) - 2))) return "the quadrature rule is not exact for the stiffness";
    for (const BeamPointLoad& at : load.points)
        if (!(at.x >= beam.begin - rounding && at.x <= beam.end + rounding)) return "a point load is off the beam";
    return "";
}

int first_of(const Beam& beam, const Span& span) {
    return beam.knots.first[static_cast<std::size_t>(span.interval)];
}

void add_span(BeamSystem& system, const Beam& beam, const Span& span, const BeamLoad& load) {
    const SpanFunctions functions(beam, span);
    const int n = beam.knots.degree + 1, row = first_of(beam, span) - system.first_function;
    for (std::size_t q = 0; q < beam.rule.points.size(); ++q) {
        const double size = span.end - span.begin, x = size * beam.rule.points[q], dx = size * beam.rule.weights[q];
        const auto f = functions.at(x);
        const double p = load.per_length ? load.per_length(span.begin + x) : 0;
        const double moment = beam.rigidity * functions.prescribed_at(x).curvature;
        VectorXd value(n), curvature(n);
        for (int i = 0; i < n; ++i) {
            value[i] = f[static_cast<std::size_t>(i)].value;
            curvature[i] = f[static_cast<std::size_t>(i)].curvature;
        }
        system.stiffness.block(row, row, n, n) += (beam.rigidity * dx) * curvature * curvature.transpose();
        system.load.segment(row, n) += dx * (p * value - moment * curvature);
    }
}

void add_point(BeamSystem& system, const Beam& beam, const Span& span, const BeamPointLoad& load) {
    const auto f = SpanFunctions(beam, span).at(load.x - span.begin);
    const int row = first_of(beam, span) - system.first_function;
    for (int i = 0; i <= beam.knots.degree; ++i) {
        const Jet& of = f[static_cast<std::size_t>(i)];
        system.load[row + i] += load.force * of.value + load.moment * of.slope;
    }
}

/// Of the B-spline itself, without its weight. B-splines rise once, then fall.
double largest_value(const Beam& beam, const Span& span, int function) {
    const KnotVector knots = SpanFunctions(beam, span).knots;
    const auto i = static_cast<std::size_t>(function - first_of(beam, span));
    LocalValues value, slope;
    double rising = 0, falling = span.end - span.begin;
    evaluate(knots, 0, rising, value, slope);
    if (slope[i] < 0) return value[i];  // 0: where the function begins
    evaluate(knots, 0, falling, value, slope);
    if (slope[i] > 0) return value[i];
    for (;;) {
        const double middle = 0.5 * (rising + falling);
        evaluate(knots, 0, middle, value, slope);
        if (middle <= rising || middle >= falling) return value[i];
        (slope[i] > 0 ? rising : falling) = middle;
    }
}

VectorXd corner_scale(const Beam& beam, const std::vector<Span>& spans, const BeamSystem& system) {
    VectorXd scale = VectorXd::Ones(system.load.size());
    for (Index i = 0; i < scale.size(); ++i) {
        const int function = system.first_function + static_cast<int>(i);
        const auto [begin, end] = support(beam.knots, function);
        std::vector<Span> met;
        for (const Span& s : spans)
            if (s.interval >= begin && s.interval < end) met.push_back(s);
        if (met.size() == 1 && met[0].is_cut) scale[i] = 1 / largest_value(beam, met[0], function);
    }
    return scale;
}

VectorXd scale_of(BeamScaling scaling, const Beam& beam, const std::vector<Span>& spans, const BeamSystem& system) {
    switch (scaling) {
        case BeamScaling::corner:
            return corner_scale(beam, spans, system);
        case BeamScaling::jacobi:
            return system.stiffness.diagonal().cwiseSqrt().cwiseInverse();
        default:
            return VectorXd::Ones(system.load.size());
    }
}

/// A pivot that is nothing but rounding of its diagonal entry tells of a matrix that is singular to working precision.
bool is_definite(const Cholesky& factor, const MatrixXd& matrix) {
    if (!factor.succeeded()) return false;
    const VectorXd pivot = factor.diagonal().cwiseAbs2().cwiseQuotient(matrix.diagonal());
    return (pivot.array() > unit).all();
}

double largest_eigenvalue(const MatrixXd& symmetric) {
    return symmetric_eigenvalues(symmetric).maxCoeff();
}

double norm_one(const MatrixXd& matrix) {
    return matrix.cwiseAbs().colwise().sum().maxCoeff();
}

}  // namespace

KnotVector uniform_knots(double cell_size, int first_cell, int n_cells, int degree) {
    KnotVector result{degree, {}, {}, {}};
    for (int k = 0; k <= n_cells; ++k) result.breakpoints.push_back((first_cell + k) * cell_size);
    for (int k = 0; k < n_cells; ++k) result.first.push_back(k);
    for (int k = -degree; k <= n_cells + degree; ++k) result.knots.push_back((first_cell + k) * cell_size);
    return result;
}

BeamSystem assemble_beam(const Beam& beam, const BeamLoad& load, BeamScaling scaling) {
    BeamSystem system;
    system.failure = fault_of(beam, load);
    if (!system.failure.empty()) return system;
    const std::vector<Span> spans = spans_of(beam);
    system.first_function = first_of(beam, spans.front());
    const int n = first_of(beam, spans.back()) + beam.knots.degree - system.first_function + 1;
    system.stiffness = MatrixXd::Zero(n, n);
    system.load = VectorXd::Zero(n);
    for (const Span& span : spans) add_span(system, beam, span, load);
    for (const BeamPointLoad& at : load.points) add_point(system, beam, span_at(spans, at.x), at);
    system.scale = scale_of(scaling, beam, spans, system);
    system.stiffness = system.scale.asDiagonal() * system.stiffness * system.scale.asDiagonal();
    system.load = system.scale.cwiseProduct(system.load);
    return system;
}

BeamSolution solve_beam(const Beam& beam, const BeamSystem& system) {
    if (!system.failure.empty()) return {{}, system.failure};
    const Cholesky factor(system.stiffness);
    if (!is_definite(factor, system.stiffness))
        return {{},
                "the beam's stiffness is not positive definite to working precision: the beam is much shorter than a cell, or "
                "has too many of them"};
    BeamSolution solution{VectorXd::Zero(beam.knots.n_functions()), ""};
    solution.coefficient.segment(system.first_function, system.load.size()) =
        system.scale.cwiseProduct(factor.solve(system.load));
    return solution;
}

BeamState beam_state(const Beam& beam, const BeamSolution& solution, double x) {
    const std::vector<Span> spans = spans_of(beam);
    const Span& span = span_at(spans, x);
    const SpanFunctions functions(beam, span);
    const auto f = functions.at(x - span.begin);
    Jet v = functions.prescribed_at(x - span.begin);
    for (int i = 0; i <= beam.knots.degree; ++i)
        v = v + solution.coefficient[first_of(beam, span) + i] * f[static_cast<std::size_t>(i)];
    return {v.value, v.slope, v.curvature};
}

ConditionNumbers condition_numbers(const MatrixXd& matrix) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const Cholesky factor(matrix);
    if (!is_definite(factor, matrix)) return {infinite, infinite, infinite};
    const MatrixXd inverse = factor.solve_columns(MatrixXd::Identity(matrix.rows(), matrix.cols()));
    return {norm_one(matrix) * norm_one(inverse), largest_eigenvalue(matrix) * largest_eigenvalue(inverse),
            matrix.stableNorm() * inverse.stableNorm()};
}

}  // namespace abut::solver
