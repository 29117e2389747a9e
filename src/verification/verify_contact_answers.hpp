// SPDX-License-Identifier: GPL-3.0-or-later
// What the contact problems of `abut verify` ask of an answer.
#pragma once
#include <string>
#include <vector>

#include "src/verification/verify_problem.hpp"

namespace abut {

/// Line contact of two half planes' worth of bodies (Johnson 1985, chapter 4): half width and largest pressure.
struct Hertz {
    double a, p0;
    double pressure(double x) const;  ///< 0 outside
};
/// Hertz' contact. radius: 1 / (1/R1 + 1/R2), concave ones negative; modulus: of contact, 1 / (1/E1' + 1/E2'); load: per
/// thickness, all of it.
Hertz hertz(double radius, double modulus, double load);

/// Okubo's series for an elastic punch on a half plane of the same material, both under the pressure 1, at x of the half width
/// [Grishin10, section 4.6.1.1, k = 1, after Okubo 1951]: an approximation printed to three digits. Its mean is 1.
double okubo_pressure(double x);

/// The first run's first contact, its largest pressure, and the size of its force.
const ContactResult& contact_of(const Answers& answers);
double peak(const Answers& answers);
double force(const Answers& answers);
/// The vertical force of the first contact, for models with a symmetry about x = 0, where forces along x are no matter of
/// statics.
double vertical_force(const Answers& answers);
/// The half width of a contact of models cut at x = 0.
double half_width(const ContactResult& contact);

/// The pressure or gap of a contact's profile at a coordinate, by straight lines between its points in order of x (or y); NaN
/// outside.
double pressure_at_x(const ContactResult& contact, double x);
double pressure_at_y(const ContactResult& contact, double y);
double gap_at_y(const ContactResult& contact, double y);
/// The gap at the profile's highest point.
double gap_at_top(const ContactResult& contact);

/// The mean and the least pressure over the profile's points, each standing for the stretch of edge around it.
double mean_pressure(const ContactResult& contact);
double least_pressure(const ContactResult& contact);
/// The largest deviation from a pressure over the profile, relative to it.
double pressure_error(const ContactResult& contact, double exact);

/// The relative error || p_h - p || / || p || over points.
double relative_error_norm(const std::vector<double>& value, const std::vector<double>& exact);

}  // namespace abut
