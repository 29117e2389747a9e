// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/curve_rule.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "geometry/curves/gauss.hpp"

namespace abut::geometry {

CurveRule curve_rule(const Curve& curve, double t0, double t1) {
    constexpr int pieces_of_curved = 16, points = 8;
    const GaussRule& rule = gauss_rule(points);
    const int pieces = std::holds_alternative<Segment>(curve) ? 1 : pieces_of_curved;
    const std::vector<double> cuts = smooth_cuts(curve, std::min(t0, t1), std::max(t0, t1));
    CurveRule along;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double h = (cuts[i + 1] - cuts[i]) / pieces;
        for (int k = 0; k < pieces; ++k)
            for (std::size_t q = 0; q < rule.points.size(); ++q) {
                along.t.push_back(cuts[i] + h * (k + rule.points[q]));
                along.weights.push_back(std::copysign(h * rule.weights[q], t1 - t0));
            }
    }
    return along;
}

}  // namespace abut::geometry
