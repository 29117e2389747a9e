// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/contact_runs.hpp"

#include <algorithm>
#include <cmath>

#include "solver/interface.hpp"

namespace abut {

namespace {

constexpr double open_fraction = 1e-9;  // of the largest coefficient: below, a pressure is rounding
// The stretch of the fit, in knot intervals from where the last coefficient's support ends: nearer, the spline that may not be
// negative overshoots, and farther the pressure is no root any more. Measured on pins in holes (16 grids, h = R/10, half angle
// of 61 degrees): off by 0.18 degrees at most; 1 to 3 intervals 0.85.
constexpr double fit_from = 1.5, fit_to = 4;
constexpr int steps = 40;  // of the integral over the stretch

/// Zero of the line through F^(2/3), F the force between the end and a place `from` to `to` inside it: a pressure that ends
/// like A sqrt(x) has F = 2/3 A x^(3/2). A force averages the waves that the last coefficients throw; the pressure itself does
/// not.
double fitted_end(const solver::KnotVector& k, const Eigen::VectorXd& c, double end, double inward, double from, double to) {
    double force = 0, n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    const double step = to / steps;
    const auto pressure = [&](double x) { return solver::pressure_at(k, c, end + inward * x); };
    for (int i = 0; i < steps; ++i) {
        const double a = i * step, x = a + step;
        force += step / 6 * (pressure(a) + 4 * pressure(a + 0.5 * step) + pressure(x));
        if (x < from - 0.5 * step) continue;  // half a step: rounding must not choose the first sample
        const double y = std::cbrt(force * force);
        n += 1;
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    if (!(slope > 0)) return end;
    const double zero = -(sy - slope * sx) / n / slope;
    return end + inward * std::clamp(zero, 0.0, from);
}

}  // namespace

std::vector<ContactRun> contact_runs(const solver::KnotVector& pressure, const Eigen::VectorXd& coefficients) {
    std::vector<ContactRun> runs;
    const int n = static_cast<int>(coefficients.size()), p = pressure.degree;
    const double limit = open_fraction * std::max(0.0, coefficients.maxCoeff());
    for (int k = 0; k < n; ++k) {
        if (!(coefficients[k] > limit)) continue;
        int last = k;
        while (last + 1 < n && coefficients[last + 1] > limit) ++last;
        // supports of neighbouring coefficients overlap, so a run is only separate where the supports are
        const double begin = std::max(pressure.knots[static_cast<std::size_t>(k)], pressure.breakpoints.front());
        const double end = std::min(pressure.knots[static_cast<std::size_t>(last + p) + 1], pressure.breakpoints.back());
        if (!runs.empty() && begin < runs.back().end) {
            runs.back().end = end;
            runs.back().to_end = last == n - 1;
        } else {
            runs.push_back({begin, end, k == 0, last == n - 1});
        }
        k = last;
    }
    for (ContactRun& run : runs) {
        const double whole = run.end - run.begin, begin = run.begin, end = run.end;
        const auto knot_at = [&](double s) {
            const auto i = static_cast<std::size_t>(solver::interval_of(pressure, s));
            return pressure.breakpoints[i + 1] - pressure.breakpoints[i];
        };
        if (!run.from_start) {
            const double h = std::min(knot_at(begin + 1e-9 * whole), whole / (2 * fit_to));
            run.begin = fitted_end(pressure, coefficients, begin, 1, fit_from * h, fit_to * h);
        }
        if (!run.to_end) {
            const double h = std::min(knot_at(end - 1e-9 * whole), whole / (2 * fit_to));
            run.end = fitted_end(pressure, coefficients, end, -1, fit_from * h, fit_to * h);
        }
    }
    return runs;
}

}  // namespace abut
