// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that sum up a solution.
#pragma once
#include <limits>

#include "src/solution/solved_assembly.hpp"

namespace abut {

/// The strain energy of a solved part, and of all parts.
double energy_of_part(const SolvedAssembly& solved, std::size_t part);
double energy_of(const SolvedAssembly& solved);
/// What rounding may make of the strain energy: the energy of strains as large as displacements over size, times a bound on
/// rounding.
double energy_rounding_of(const SolvedAssembly& solved);

/// The resultant on the contact's first part, shear of bonds included, and its moment about the origin; from the same
/// quadrature that the solution used.
struct ContactForce {
    Vec2 force{0, 0};
    double moment = 0;
};
ContactForce contact_force(const SolvedAssembly& solved, std::size_t contact);
/// The resultant on the contact's first part of what it presses between two places of its middle curve.
ContactForce contact_force_between(const SolvedAssembly& solved, std::size_t contact, double begin, double end);
/// The resultant of every coefficient of an interface's pressure by itself, by column: force x, force y, moment about the
/// origin; of what lies between two places. first: the grid of its first part.
Eigen::Matrix3Xd forces_of_pressure(const PartOnGrid& first, const solver::Interface& face,
                                    double begin = -std::numeric_limits<double>::infinity(),
                                    double end = std::numeric_limits<double>::infinity());

/// The integral of a contact's pressure: a press fit presses all round without a resultant.
double pressing_force(const SolvedAssembly& solved, std::size_t contact);

/// Where a contact's pressure begins or ends.
struct PressedEnd {
    double s;  ///< of the middle curve
    StretchEnd::Kind kind;
    geometry::FacingPair pair;
};
std::vector<PressedEnd> pressed_ends(const Scene& scene, const SolvedAssembly& solved, std::size_t contact);

/// The points that hold a solved part by a force; of points that only keep it in place (what acts on it balances) there is
/// none.
std::vector<Vec2> points_that_carry(const Scene& scene, const SolvedAssembly& solved, std::size_t part);

/// The compliance 1 / E' of a half plane of the part's material, E' = E in plane stress, E / (1 - nu^2) in plane strain, per
/// thickness of the interface: a thicker part is stiffer. 0 of a rigid part.
double half_plane_compliance(const PartOnGrid& part, double thickness);

/// The compliance 1 / E* = 1 / E1' + 1 / E2' of a contact.
double compliance_of(const SolvedAssembly& solved, std::size_t contact);

/// The penetration that a penalty allows, over the elastic closing within the contact: p / beta over p a / E*, as in Hertz'
/// contact of half width a, whose middle closes by p a / E* more than its ends. 0 without penalty.
double penetration_share(const SolvedAssembly& solved, std::size_t contact);

/// Is any contact under pressure? A bond is none.
bool any_stretch(const SolvedAssembly& solved);

}  // namespace abut
