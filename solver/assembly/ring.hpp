// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that are turned about an axis: x - axis is the radius r, y runs along the axis, the third direction is the hoop's, with
// the strain u_x / r.
//
// Integrals over the part's volume are those over its section times 2 pi r. The radius is part of every weight (cut rules,
// boundary, interfaces; for_all_cells for full cells), 2 pi is the thickness: what integrates with weights and thickness is
// right as it is. New is only what the hoop strain adds: to the stiffness (ring_stiffness.hpp), to stresses, to the volume
// strain. Rigid motions: along y alone, all others stretch the hoops.
//
// On the axis u_x = 0: functions of the outermost grid line are dropped (make_part_system), what is left vanishes there like r,
// and N N' / r is a polynomial.
#pragma once
#include "solver/assembly/assembly.hpp"
#include "solver/splines/displacement.hpp"

namespace abut::solver {

/// Points closer to the axis than this fraction of the first cell are on it: u_x / r is du_x / dx there. Between, the quotient
/// loses the digits that r has lost to rounding, 1e-16 over this.
inline constexpr double on_axis_fraction = 1e-8;

/// The distance of a point from the axis that the part has.
inline double radius(const PartInput& input, const Vec2& x) {
    return x.x() - *input.axis;
}

/// Is a point as good as on the axis?
inline bool is_on_axis(const PartInput& input, const Vec2& x) {
    const std::vector<double>& lines = input.space.x.breakpoints;
    return radius(input, x) <= on_axis_fraction * (lines[1] - lines[0]);
}

/// The integral of the weights: the section's area, around an axis the volume over 2 pi.
double measure(const PartInput& input);

/// The hoop strain u_x / r at a point of a part with an axis.
inline double hoop_strain(const PartInput& input, const Vec2& x, const DisplacementAt& u) {
    return is_on_axis(input, x) ? u.gradient(0, 0) : u.value.x() / radius(input, x);
}

}  // namespace abut::solver
