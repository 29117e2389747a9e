// SPDX-License-Identifier: GPL-3.0-or-later
// The exact point where a Boolean's boundary goes from one curve to another, found from its place on the curves' arc splines.
#pragma once
#include <optional>

#include "geometry/curves/curve.hpp"

namespace abut::geometry {

/// A place on two curves, by its parameters and points.
struct Junction {
    double ta = 0, tb = 0;    ///< parameters; may lie outside [0, 1] on closed curves and by rounding
    Vec2 xa{0, 0}, xb{0, 0};  ///< the points there: equal at crossings, at most `merge` apart where the curves touch
};

/// How well the guess is known, and what counts as one point.
struct JunctionTolerance {
    double curves = 0;  ///< sum of the distances between the two curves and the arcs on which the guess was found
    double merge = 0;   ///< curves that come this close touch
};

/// The crossing of a and b next to a(ta) and b(tb), by Newton iterations; where they do not cross, their touching point. Of a
/// crossing at a small angle it must be certain that it is the one that the arcs showed: the two curves must part by several
/// times the tolerance on both sides of it. None if there is neither.
std::optional<Junction> find_junction(const Curve& a, double ta, const Curve& b, double tb, const JunctionTolerance& tolerance);

/// The point where a and b touch next to a(ta) and b(tb): parallel tangents, at most `merge` apart. None where they do not
/// touch.
std::optional<Junction> find_touching(const Curve& a, double ta, const Curve& b, double tb, const JunctionTolerance& tolerance);

/// Parameter of the point of the curve nearest to p, near the parameter t in a portion of the width `range`; not confined to
/// [0, 1].
double local_parameter(const Curve& curve, const Vec2& p, double t, double range);

}  // namespace abut::geometry
