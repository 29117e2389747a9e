// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/plane_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abut {

namespace {

constexpr int terms = 16;         // of the sum; as many samples of the slope
constexpr double settled = 1e-4;  // the last terms, of the first

}  // namespace

double pressure_at(const PlaneStretch& stretch, double s) {
    const double u = (s - stretch.middle) / stretch.half_width;
    if (!(std::abs(u) < 1)) return 0;
    const double t = std::acos(u);
    double sum = 0;
    for (std::size_t k = 0; k < stretch.sine.size(); ++k) sum += stretch.sine[k] * std::sin(static_cast<double>(2 * k + 1) * t);
    return sum;
}

std::optional<PlaneStretch> plane_stretch(const std::function<std::optional<double>(double)>& slope, double middle,
                                          double half_width, double force) {
    PlaneStretch stretch{middle, half_width, std::vector<double>(terms, 0.0)};
    for (int i = 0; i < terms; ++i) {
        const double t = (i + 0.5) * std::numbers::pi / (2 * terms);
        const std::optional<double> there = slope(half_width * std::cos(t));
        if (!there) return std::nullopt;
        for (int k = 0; k < terms; ++k)
            stretch.sine[static_cast<std::size_t>(k)] += 2.0 / terms * *there * std::cos((2 * k + 1) * t);
    }
    const double first = stretch.sine.front(),
                 last = std::max(std::abs(stretch.sine[terms - 2]), std::abs(stretch.sine[terms - 1]));
    if (!(first > 0) || last > settled * first) return std::nullopt;
    // by the force, which statics know better than E* and the half width are known
    const double scale = force / (0.5 * std::numbers::pi * half_width * first);
    for (double& c : stretch.sine) c *= scale;
    return stretch;
}

}  // namespace abut
