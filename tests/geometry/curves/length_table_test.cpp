// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters at arc lengths from the table are those of the curve's lengths, to rounding, however unevenly it is run through.
#include "geometry/curves/length_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/curves/general_curve.hpp"
#include "geometry/curves/spline_shape.hpp"

namespace abut::geometry::length_table_test {
namespace {

/// Flat ellipses, and Bezier curves of degrees 3 to 7 through random points, weighted or not.
std::vector<Curve> curves() {
    std::vector<Curve> list;
    for (double aspect : {1.0, 0.5, 0.1, 0.01}) list.emplace_back(EllipticArc{{1, 2}, {3, 0}, {0, 3 * aspect}, 0.4, 5});
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int k = 0; k < 60; ++k) {
        std::vector<Vec2> points;
        std::vector<double> weights;
        for (int i = 0; i <= 3 + k % 5; ++i) {
            points.emplace_back(number(random), number(random));
            weights.push_back(std::exp(number(random)));
        }
        if (k % 2 == 0) weights.clear();
        list.push_back(bezier_curve(points, weights));
    }
    return list;
}

/// From the entry before.
double length_to(const Curve& curve, const LengthTable& table, double t) {
    const auto after = std::upper_bound(table.t.begin(), table.t.end(), t) - table.t.begin();
    const auto k = static_cast<std::size_t>(after) - 1;
    return table.s[k] + length_by_gauss(curve, table.t[k], t);
}

TEST(LengthTable, InvertsLengths) {
    for (const Curve& curve : curves()) {
        const LengthTable table = length_table(curve);
        const double total = table.s.back();
        EXPECT_NEAR(total, length(curve), 1e-13 * total);  // what the halves of a length agree to
        for (int i = 0; i <= 200; ++i) {
            const double s = i / 200.0 * total, t = parameter_at_length(curve, table, s);
            // the roundings of the length, and of the parameter
            EXPECT_NEAR(length_to(curve, table, t), s, 1e-15 * total + 4e-16 * derivative(curve, t).norm());
        }
        EXPECT_EQ(parameter_at_length(curve, table, -1), 0);
        EXPECT_EQ(parameter_at_length(curve, table, 2 * total), 1);
    }
}

}  // namespace
}  // namespace abut::geometry::length_table_test
