// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/solution/pressed_stretches.hpp"

#include <algorithm>
#include <cmath>

#include "solver/contact/interface.hpp"

namespace abut {

namespace {

constexpr double open_fraction = 1e-9;  // of the largest coefficient: below, a pressure is rounding
// The stretch of the fit, in knot intervals from where the last coefficient's support ends: nearer, the spline that may not be
// negative overshoots, and farther the pressure is no root any more. Measured on pins in holes (16 grids, h = R/10, half angle
// of 61 degrees): off by 0.18 degrees at most; 1 to 3 intervals 0.85.
constexpr double fit_from = 1.5, fit_to = 4;
constexpr int steps = 40;  // of the integral over the stretch
/// An interface's end counts as a corner where the pressure is so much larger there than so far away, of the contact's length;
/// errors so near to it are left out.
constexpr double corner_rise = 1.05, corner_test = 0.1, corner_reach = 0.05;

/// A pressure A sqrt(x - zero), x the distance inward from where the last coefficient's support ends.
struct Root {
    double zero = 0, amplitude = 0;
};

/// From the line through F^(2/3), F the force between the end and a place `from` to `to` inside it: such a pressure has
/// F = 2/3 A (x - zero)^(3/2). A force averages the waves that the last coefficients throw; the pressure itself does not.
template <class Pressure>
Root fitted_root(const Pressure& pressure, double from, double to) {
    double force = 0, n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    const double step = to / steps;
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
    if (!(slope > 0)) return {};
    return {std::clamp(-(sy - slope * sx) / n / slope, 0.0, from), 1.5 * slope * std::sqrt(slope)};
}

/// L2 distance of pressure and root between the end and `to`.
template <class Pressure>
double misfit(const Pressure& pressure, const Root& root, double to) {
    double sum = 0;
    const double step = to / steps;
    for (int i = 0; i < steps; ++i) {
        const double x = (i + 0.5) * step;
        const double difference = pressure(x) - root.amplitude * std::sqrt(std::max(0.0, x - root.zero));
        sum += step * difference * difference;
    }
    return std::sqrt(sum);
}

/// How far inside of the last coefficient's support the contact ends. h: knot spacing there.
template <class Pressure>
double free_end(const Pressure& pressure, double h, StretchEnd& end) {
    const Root root = fitted_root(pressure, fit_from * h, fit_to * h);
    end = {StretchEnd::Kind::free, error_reach * h, misfit(pressure, root, error_reach * h)};
    return root.zero;
}

template <class Pressure>
StretchEnd fixed_end(const Pressure& pressure, double length) {
    if (pressure(0) > corner_rise * pressure(corner_test * length)) return {StretchEnd::Kind::corner, corner_reach * length, 0};
    return {StretchEnd::Kind::plain, 0, 0};
}

}  // namespace

std::vector<PressedStretch> pressed_stretches(const solver::KnotVector& pressure, const Eigen::VectorXd& coefficients) {
    std::vector<PressedStretch> stretches;
    const int n = static_cast<int>(coefficients.size()), p = pressure.degree;
    const double limit = open_fraction * std::max(0.0, coefficients.maxCoeff());
    const bool has_seam = pressure.knots.front() < pressure.breakpoints.front();  // of a zone that goes all the way round
    for (int k = 0; k < n; ++k) {
        if (!(coefficients[k] > limit)) continue;
        int last = k;
        while (last + 1 < n && coefficients[last + 1] > limit) ++last;
        // supports of neighbouring coefficients overlap, so a stretch is only separate where the supports are
        const double begin = std::max(pressure.knots[static_cast<std::size_t>(k)], pressure.breakpoints.front());
        const double end = std::min(pressure.knots[static_cast<std::size_t>(last + p) + 1], pressure.breakpoints.back());
        if (!stretches.empty() && begin < stretches.back().end) {
            stretches.back().end = end;
            stretches.back().to_end = last == n - 1;
        } else {
            stretches.push_back({begin, end, k == 0, last == n - 1});
        }
        k = last;
    }
    for (PressedStretch& stretch : stretches) {
        const double length = stretch.end - stretch.begin;
        const auto from_begin = [&, s = stretch.begin](double x) { return solver::pressure_at(pressure, coefficients, s + x); };
        const auto from_end = [&, s = stretch.end](double x) { return solver::pressure_at(pressure, coefficients, s - x); };
        const double most = length / (2 * fit_to), inside = std::nextafter(stretch.end, stretch.begin);
        const auto knots_at = [&](double s) { return std::min(spacing_at(pressure, s), most); };
        if (stretch.from_start)
            stretch.at_begin = has_seam ? StretchEnd{} : fixed_end(from_begin, length);
        else
            stretch.begin += free_end(from_begin, knots_at(stretch.begin), stretch.at_begin);
        if (stretch.to_end)
            stretch.at_end = has_seam ? StretchEnd{} : fixed_end(from_end, length);
        else
            stretch.end -= free_end(from_end, knots_at(inside), stretch.at_end);
    }
    return stretches;
}

double length_of(const std::vector<PressedStretch>& stretches) {
    double length = 0;
    for (const PressedStretch& stretch : stretches) length += stretch.end - stretch.begin;
    return length;
}

}  // namespace abut
