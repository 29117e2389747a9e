// SPDX-License-Identifier: GPL-3.0-or-later
// Gauss points along curves.
#pragma once
#include <vector>

#include "geometry/curves/curve.hpp"

namespace abut::geometry {

/// Parameters along a curve, and what they weigh in integrals over the parameter.
struct CurveRule {
    std::vector<double> t, weights;
};
/// The rule from t0 to t1; backwards weights are below zero. Exact to rounding for what changes as smoothly as point, normal
/// and length of an arc do along a full circle: no piece of it runs across smoothness_breaks.
CurveRule curve_rule(const Curve& curve, double t0 = 0, double t1 = 1);

}  // namespace abut::geometry
