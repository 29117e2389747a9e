// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "solver/parts/part_system.hpp"

namespace abut::solver {

/// Chooses as many coefficients of a part as there are motions (2n x motions) so that holding them holds the motions: pivoted
/// elimination on their rows. Reads stiffness and dropped.
std::vector<Eigen::Index> pins(const PartSystem& system, const Eigen::MatrixXd& motions);

/// The stiffness of the material against a coefficient, the median of all.
double median_stiffness(const PartSystem& system);

}  // namespace abut::solver
