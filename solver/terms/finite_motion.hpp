// SPDX-License-Identifier: GPL-3.0-or-later
// What small displacements leave out: forces balance where the part has gone, and stress turns with it. Of a displacement's
// gradient G there are the linear strain, whose stress is s, and the quadratic strain e = G'G / 2 of the Green-Lagrange strain;
// St. Venant-Kirchhoff's material, loads that keep their directions and act at the part's own points. Not with a solution
// structure. Cost of each: as the strain energy.
#pragma once
#include "solver/assembly/assembly.hpp"

namespace abut::solver {

/// The load vector (2n) that does what the linear balance leaves out, to the second order: - int (G s + D e) : grad v. Its
/// first term is that of columns, of strings, and of weights on what turns about a pin; its second takes back by what a
/// rotation taken for a displacement makes a part larger. Left out are strains above a tenth and
/// three times the mean, those of corners.
Eigen::VectorXd finite_motion_load(const PartInput& input, const Eigen::VectorXd& displacement);

/// The integral of the stress over the part: its mean times the volume.
Eigen::Matrix2d stress_integral(const PartInput& input, const Eigen::VectorXd& displacement);

/// The work that a displacement u does against the stress which it brings about by itself as it bends the part,
/// int G G' : (D e + s(v)), where v is what finite_motion_load of u adds to it. It grows with the fourth power of the
/// displacement: a beam between walls, whose ends cannot come closer.
double stretching_work(const PartInput& input, const Eigen::VectorXd& displacement, const Eigen::VectorXd& added);

}  // namespace abut::solver
