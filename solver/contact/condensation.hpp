// SPDX-License-Identifier: GPL-3.0-or-later
// An assembly's rows condensed to its multipliers and rigid amplitudes.
#pragma once
#include <vector>

#include "solver/contact/contact_qp.hpp"
#include "solver/contact/interface.hpp"

namespace abut::solver {

/// Where each part's free motions stand among the amplitudes; parts + 1 offsets.
std::vector<Eigen::Index> mode_offsets(const std::vector<PartSystem>& parts);

/// The free rigid motions of an assembly's rows, G and h, with gap0 for the gaps and no compliance: what bodies settle by.
ContactQp rigid_problem(const std::vector<PartSystem>& parts, const Rows& rows, double load_scale);

/// Condenses an assembly: C = sum of D K^-1 D' and softness, g = gap0 + D u of the loads, G = D R, h = R'f with the parts' free
/// motions R. Not filled in: foundation. load_scale: the largest single load, raised to what prescribed displacements do. One
/// forward solution a part, of its rows and its load together; parts side by side on `threads` threads, summed in their order.
ContactQp condense(const std::vector<PartSystem>& parts, const Rows& rows, double load_scale, int threads);

/// Turns rows into mean gaps and multipliers into forces, dividing by `weight` (m): C and G then have comparable entries
/// whatever the spacing of the multipliers.
void scale_rows(ContactQp& qp, const Eigen::VectorXd& weight);

}  // namespace abut::solver
