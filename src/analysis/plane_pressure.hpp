// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure between bodies that answer it like half planes [Galin1953]: what a contact that is small beside its parts comes to.
#pragma once
#include <functional>
#include <optional>
#include <vector>

namespace abut {

/// The pressure of one contact of a symmetric profile: with s = middle + half_width cos t,
///   p(s) = sum of sine[k] sin((2 k + 1) t),
/// the sum that the gap's derivative has in cosines of t, times E* / 2.
struct PlaneStretch {
    double middle, half_width;
    std::vector<double> sine;
};

double pressure_at(const PlaneStretch& stretch, double s);  ///< 0 outside

/// Makes the stretch of one contact. slope(x): derivative of the gap at a distance x from the middle; force: per thickness,
/// both halves. Nothing where the slope is unknown, or so rough that its sum does not settle: a wedge, an edge's joint within.
std::optional<PlaneStretch> plane_stretch(const std::function<std::optional<double>(double)>& slope, double middle,
                                          double half_width, double force);

/// The pressure of all stretches of a contact, along the middle curve s; s1: the same places on the zone's first chain.
struct PlanePressure {
    std::vector<double> s1, s;
    std::vector<PlaneStretch> stretches;
    /// The relative error of the theory itself, about: the square of half width over hydraulic diameter.
    double doubt = 0;
};

}  // namespace abut
