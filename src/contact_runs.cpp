// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/contact_runs.hpp"

#include <algorithm>
#include <cmath>

#include "solver/interface.hpp"

namespace abut {

namespace {

constexpr double open_fraction = 1e-9;  // of the largest coefficient: below, a pressure is rounding
constexpr int samples = 8;              // of the fit

/// Zero of the line through the squared pressures between `near` and `far` inside the end.
double fitted_end(const solver::KnotVector& k, const Eigen::VectorXd& c, double end, double inward, double near, double far) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int i = 0; i < samples; ++i) {
        const double x = near + (far - near) * i / (samples - 1);
        const double p = solver::pressure_at(k, c, end + inward * x), y = p * p;
        n += 1;
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    if (!(slope > 0)) return end;
    const double zero = -(sy - slope * sx) / n / slope;
    return end + inward * std::clamp(zero, 0.0, near + 0.5 * (far - near));
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
            const double h = std::min(knot_at(begin + 1e-9 * whole), whole / 6);
            run.begin = fitted_end(pressure, coefficients, begin, 1, h, 3 * h);
        }
        if (!run.to_end) {
            const double h = std::min(knot_at(end - 1e-9 * whole), whole / 6);
            run.end = fitted_end(pressure, coefficients, end, -1, h, 3 * h);
        }
    }
    return runs;
}

}  // namespace abut
