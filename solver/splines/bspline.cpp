// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/splines/bspline.hpp"

#include <algorithm>
#include <utility>

#include "src/base/quadtree.hpp"

namespace abut::solver {

namespace {

/// Cox-de Boor on a fixed interval: values of all functions of degree p there.
void cox_de_boor(const double* t, int p, double x, double* values) {
    // t points at the knot that starts the interval
    values[0] = 1;
    for (int d = 1; d <= p; ++d) {
        double carried = 0;
        for (int r = 0; r < d; ++r) {
            const double right = t[r + 1], left = t[r + 1 - d];
            const double share = values[r] / (right - left);
            values[r] = carried + (right - x) * share;
            carried = (x - left) * share;
        }
        values[d] = carried;
    }
}

}  // namespace

LocalValues blossom(const IntervalKnots& knots, const double* arguments) {
    const int p = knots.degree;
    const double* t = knots.start;
    LocalValues result{};
    for (int unit = 0; unit <= p; ++unit) {
        LocalValues d{};
        d[static_cast<std::size_t>(unit)] = 1;
        for (int r = 1; r <= p; ++r) {
            const double u = arguments[r - 1];
            for (int i = p; i >= r; --i) {
                const double left = t[i - p], right = t[i + 1 - r];
                const double a = (u - left) / (right - left);
                d[static_cast<std::size_t>(i)] =
                    (1 - a) * d[static_cast<std::size_t>(i) - 1] + a * d[static_cast<std::size_t>(i)];
            }
        }
        result[static_cast<std::size_t>(unit)] = d[static_cast<std::size_t>(p)];
    }
    return result;
}

KnotVector clamped_knots(std::vector<double> breakpoints, int degree) {
    const std::vector<int> simple(breakpoints.size(), 1);
    return clamped_knots(std::move(breakpoints), degree, simple);
}

KnotVector clamped_knots(std::vector<double> breakpoints, int degree, const std::vector<int>& multiplicity) {
    KnotVector result{degree, std::move(breakpoints), {}, {}};
    const std::size_t last = result.breakpoints.size() - 1;
    for (std::size_t k = 0; k <= last; ++k) {
        const int times = k == 0 || k == last ? degree + 1 : multiplicity[k];
        result.knots.insert(result.knots.end(), static_cast<std::size_t>(times), result.breakpoints[k]);
        if (k < last) result.first.push_back(static_cast<int>(result.knots.size()) - 1 - degree);
    }
    return result;
}

KnotVector periodic_knots(std::vector<double> breakpoints, int degree) {
    const std::vector<int> simple(breakpoints.size(), 1);
    return periodic_knots(std::move(breakpoints), degree, simple);
}

KnotVector periodic_knots(std::vector<double> breakpoints, int degree, const std::vector<int>& multiplicity) {
    KnotVector result{degree, std::move(breakpoints), {}, {}};
    const std::vector<double>& b = result.breakpoints;
    std::vector<double> once;  // the knots of one period
    for (std::size_t k = 0; k + 1 < b.size(); ++k) {
        once.insert(once.end(), static_cast<std::size_t>(multiplicity[k]), b[k]);
        result.first.push_back(static_cast<int>(once.size()) - 1);
    }
    const double period = b.back() - b.front();
    const int n = static_cast<int>(once.size());
    for (int k = -degree; k <= n + degree; ++k) {
        const int turns = (k < 0 ? k - n + 1 : k) / n;  // rounded down
        result.knots.push_back(k == n ? b.back() : once[static_cast<std::size_t>(k - turns * n)] + period * turns);
    }
    return result;
}

IntervalRange support(const KnotVector& knots, int i) {
    const auto& f = knots.first;
    return {static_cast<int>(std::lower_bound(f.begin(), f.end(), i - knots.degree) - f.begin()),
            static_cast<int>(std::upper_bound(f.begin(), f.end(), i) - f.begin())};
}

int interval_of(const KnotVector& knots, double x) {
    const auto& b = knots.breakpoints;
    const int i = static_cast<int>(std::upper_bound(b.begin(), b.end(), x) - b.begin()) - 1;
    return std::clamp(i, 0, knots.n_intervals() - 1);
}

double spacing_at(const KnotVector& knots, double x) {
    const auto i = static_cast<std::size_t>(interval_of(knots, x));
    return knots.breakpoints[i + 1] - knots.breakpoints[i];
}

void evaluate(const IntervalKnots& knots, double x, LocalValues& values) {
    cox_de_boor(knots.start, knots.degree, x, values.data());
}

void evaluate(const IntervalKnots& knots, double x, LocalValues& values, LocalValues& derivatives) {
    const int p = knots.degree;
    const double* t = knots.start;
    cox_de_boor(t, p - 1, x, values.data());
    // the last step, by the shares of which the derivatives are made:
    // N_i' = p (N_{i,p-1} / (t_{i+p} - t_i) - N_{i+1,p-1} / (t_{i+p+1} - t_{i+1}))
    double carried = p == 0 ? 1 : 0, previous = 0;
    for (int r = 0; r < p; ++r) {
        const double right = t[r + 1], left = t[r + 1 - p];
        const double share = values[static_cast<std::size_t>(r)] / (right - left);
        values[static_cast<std::size_t>(r)] = carried + (right - x) * share;
        carried = (x - left) * share;
        derivatives[static_cast<std::size_t>(r)] = previous - p * share;
        previous = p * share;
    }
    values[static_cast<std::size_t>(p)] = carried;
    derivatives[static_cast<std::size_t>(p)] = previous;
}

double greville(const KnotVector& knots, int i) {
    if (knots.degree == 0)
        return 0.5 * (knots.knots[static_cast<std::size_t>(i)] + knots.knots[static_cast<std::size_t>(i) + 1]);
    double sum = 0;
    for (int k = 1; k <= knots.degree; ++k) sum += knots.knots[static_cast<std::size_t>(i + k)];
    return sum / knots.degree;
}

double greville(const IntervalKnots& knots, int k) {
    if (knots.degree == 0) return 0.5 * (knots.low() + knots.high());
    double sum = 0;
    for (int i = 0; i < knots.degree; ++i) sum += knots.inner_knots(k)[i];
    return sum / knots.degree;
}

namespace {

/// How often the line of a level is a knot.
int level_multiplicity(const KnotVector& base, int level, int line) {
    const int old = line >> level, n = base.n_intervals();
    if (line != old << level) return 1;
    if (old == 0 || old == n) return base.degree + 1;
    return base.first[at(old)] - base.first[at(old) - 1];
}

}  // namespace

std::vector<double> level_knots(const KnotVector& base, int level, int interval) {
    const int each_way = std::max(1, base.degree);
    std::vector<double> knots;
    for (int line = interval; static_cast<int>(knots.size()) < each_way; --line)
        knots.insert(knots.end(), at(level_multiplicity(base, level, line)), level_line(base.breakpoints, level, line));
    knots.resize(at(each_way));
    std::reverse(knots.begin(), knots.end());
    for (int line = interval + 1; static_cast<int>(knots.size()) < 2 * each_way; ++line)
        knots.insert(knots.end(), at(level_multiplicity(base, level, line)), level_line(base.breakpoints, level, line));
    knots.resize(at(2 * each_way));
    return knots;
}

int level_first(const KnotVector& base, int level, int interval) {
    const int old = interval >> level;
    return interval + base.first[at(old)] - old;
}

KnotVector derivative_knots(const KnotVector& knots) {
    KnotVector lower{knots.degree - 1, knots.breakpoints, {knots.knots.begin() + 1, knots.knots.end() - 1}, knots.first};
    return lower;
}

LocalValues extension_coefficients(const KnotVector& knots, int interval, int j) {
    return blossom(knots.interval(interval), knots.knots.data() + j + 1);
}

std::vector<RefinedCoefficient> refinement(const KnotVector& coarse, const KnotVector& fine) {
    std::vector<RefinedCoefficient> rows;
    for (int j = 0; j < fine.n_functions(); ++j) {
        // any interval of the function will do: the middle of one holds no coarse knot
        const auto on = static_cast<std::size_t>(support(fine, j).begin);
        const int from = interval_of(coarse, 0.5 * (fine.breakpoints[on] + fine.breakpoints[on + 1]));
        rows.push_back(
            {coarse.first[static_cast<std::size_t>(from)], blossom(coarse.interval(from), fine.knots.data() + j + 1)});
    }
    return rows;
}

}  // namespace abut::solver
