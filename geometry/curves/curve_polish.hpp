// SPDX-License-Identifier: GPL-3.0-or-later
// Newton iterations on two true curves, started where their arc splines meet or come closest.
#pragma once
#include <optional>

#include "geometry/curves/curve.hpp"

namespace abut::geometry {

/// A parameter on each of two curves, both in [0, 1].
struct ParameterPair {
    double a = 0, b = 0;
};

/// The crossing of two curves, x_a = x_b, by Newton iterations from `start`. Steps that leave a curve stop at its end. None
/// where the iteration breaks down (parallel tangents) or does not settle; the caller checks the distance of what is returned.
std::optional<ParameterPair> polished_crossing(const Curve& a, const Curve& b, ParameterPair start);

/// The pair of points whose line is normal to both curves: their closest approach, or their deepest penetration. Well
/// conditioned where the curves touch, too, as long as their curvatures differ. None where the iteration does not settle.
std::optional<ParameterPair> polished_parallel(const Curve& a, const Curve& b, ParameterPair start);

/// The parameter of the local minimum of the distance to p that lies downhill of `start`.
double nearby_closest_parameter(const Curve& curve, const Vec2& p, double start);

}  // namespace abut::geometry
