// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/implicit/cardinal_spline.hpp"

#include <cmath>

namespace abut::geometry {

namespace {

using Values = std::array<double, max_cardinal_degree + 1>;

/// Entry j of 0..degree belongs to k = cell - degree + j; u in [0, 1] is the place in the cell. Each degree from the one below:
/// B_n(s) = s / n B_{n-1}(s) + (n + 1 - s) / n B_{n-1}(s - 1), with s = u + degree - j.
Values of_degree(int degree, double u) {
    Values lower{1.0};
    for (int n = 1; n <= degree; ++n) {
        Values higher{};
        for (int j = 0; j <= n; ++j) {
            const double s = u + n - j;
            const auto i = static_cast<std::size_t>(j);
            if (j > 0) higher[i] += s / n * lower[i - 1];
            if (j < n) higher[i] += (n + 1 - s) / n * lower[i];
        }
        lower = higher;
    }
    return lower;
}

/// B_n' (s) = B_{n-1}(s) - B_{n-1}(s - 1), from the entries of degree n - 1.
Values differences(const Values& lower, int n) {
    Values slopes{};
    for (int j = 0; j <= n; ++j) {
        const auto i = static_cast<std::size_t>(j);
        slopes[i] = (j > 0 ? lower[i - 1] : 0.0) - (j < n ? lower[i] : 0.0);
    }
    return slopes;
}

}  // namespace

CardinalValues cardinal_splines(int degree, double x) {
    const double cell = std::floor(x), u = x - cell;
    CardinalValues values;
    values.first = static_cast<int>(cell) - degree;
    values.value = of_degree(degree, u);
    values.slope = differences(of_degree(degree - 1, u), degree);
    if (degree > 1) values.bend = differences(differences(of_degree(degree - 2, u), degree - 1), degree);
    return values;
}

}  // namespace abut::geometry
