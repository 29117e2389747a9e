// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/splines/bspline.hpp"

#include <algorithm>
#include <utility>

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

const double* interval_start(const KnotVector& knots, int interval) {
    return knots.knots.data() + knots.first[static_cast<std::size_t>(interval)] + knots.degree;
}

/// Blossom of an interval's polynomials at p arguments: one value for each of the interval's functions.
LocalValues blossom(const KnotVector& knots, int interval, const double* arguments) {
    const int p = knots.degree;
    const double* t = interval_start(knots, interval);
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

}  // namespace

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

void evaluate(const KnotVector& knots, int interval, double x, LocalValues& values) {
    cox_de_boor(interval_start(knots, interval), knots.degree, x, values.data());
}

void evaluate(const KnotVector& knots, int interval, double x, LocalValues& values, LocalValues& derivatives) {
    const int p = knots.degree;
    const double* t = interval_start(knots, interval);
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

KnotVector derivative_knots(const KnotVector& knots) {
    KnotVector lower{knots.degree - 1, knots.breakpoints, {knots.knots.begin() + 1, knots.knots.end() - 1}, knots.first};
    return lower;
}

LocalValues extension_coefficients(const KnotVector& knots, int interval, int j) {
    return blossom(knots, interval, knots.knots.data() + j + 1);
}

std::vector<RefinedCoefficient> refinement(const KnotVector& coarse, const KnotVector& fine) {
    std::vector<RefinedCoefficient> rows;
    for (int j = 0; j < fine.n_functions(); ++j) {
        // any interval of the function will do: the middle of one holds no coarse knot
        const auto on = static_cast<std::size_t>(support(fine, j).begin);
        const int from = interval_of(coarse, 0.5 * (fine.breakpoints[on] + fine.breakpoints[on + 1]));
        rows.push_back({coarse.first[static_cast<std::size_t>(from)], blossom(coarse, from, fine.knots.data() + j + 1)});
    }
    return rows;
}

}  // namespace abut::solver
