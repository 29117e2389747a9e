// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <cmath>

#include "src/results/result.hpp"

namespace abut::test {

/// Relative L2 error of a contact's pressure against Hertz' ellipse over x, by the trapezoidal rule on the profile.
inline double hertz_error(const ContactProfile& profile, double a, double p0) {
    double error = 0, norm = 0;
    for (std::size_t i = 0; i + 1 < profile.x.size(); ++i) {
        const double x = 0.5 * (profile.x[i] + profile.x[i + 1]), dx = std::abs(profile.x[i + 1] - profile.x[i]);
        const double p = 0.5 * (profile.pressure[i] + profile.pressure[i + 1]);
        const double exact = std::abs(x) < a ? p0 * std::sqrt(1 - x * x / (a * a)) : 0.0;
        error += dx * (p - exact) * (p - exact);
        norm += dx * exact * exact;
    }
    return std::sqrt(error / norm);
}

}  // namespace abut::test
